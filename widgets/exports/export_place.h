#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>

namespace mirrorball::studio {

/// The folder that exports go to, and the command line that writes the same there.
class ExportPlace : public QWidget {
    Q_OBJECT

public:
    explicit ExportPlace(QWidget* parent = nullptr);
    ~ExportPlace() override;

    void setFolder(const QString& folder);
    QString folder() const;
    void focusFolder() { m_folder->setFocus(); }

    QString command() const { return m_command->text(); }
    /// A command line reads the scene's file: before the scene is saved it would write something else, and it is shown as not to be used.
    enum class SceneFile { UpToDate, Older };
    /// @param writesMaps  whether it has any map to write
    void showCommand(const QString& command, SceneFile file, bool writesMaps);

signals:
    void folderChanged();
    void copied();
    /// The user wants the scene saved, so that the command line can read it.
    void saveRequested();

private:
    void addFolderRow(QGridLayout& layout);
    void addCommandRow(QGridLayout& layout);

    QLineEdit *m_folder, *m_command;
    QPushButton *m_copy, *m_save;
    QLabel* m_note;
};

} // namespace mirrorball::studio
