#pragma once

#include "command_keys.h"
#include "edit_actions.h"
#include "file_actions.h"
#include "help/help_actions.h"
#include "recovery.h"
#include "view_actions.h"

#include "widgets/files/drop_target.h"
#include "widgets/picture/preview_widget.h"
#include "widgets/workspace/workspace.h"

#include <QDockWidget>
#include <QMainWindow>

#include <memory>

namespace mirrorball::studio {

/// The window of one document: the preview in the middle, docks around it.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// @param recoveryFolder where copies of unsaved changes go
    explicit MainWindow(const QString& recoveryFolder = Recovery::defaultFolder(), QWidget* parent = nullptr);
    ~MainWindow() override;

    Workspace& workspace() { return *m_workspace; }
    PreviewWidget& preview() { return *m_preview; }
    FileActions& files() { return *m_files; }
    HelpActions& help() { return *m_help; }
    Tour& tour() { return *m_tour; }
    Recovery& recovery() { return *m_recovery; }
    /// The dock of that id (docks.h), or null.
    QDockWidget* dock(const QString& id) const;

    /// Opens files as if they were dropped: a scene, a mesh, a probe, a folder of probes.
    void openFiles(const QStringList& paths);
    /// Offers the tour to who has never seen it.
    void greet();
    /// Shows what a prefiltered map is, in the doctor's words.
    void askDoctor(const QString& path);
    /// Draws the picture at its own size into a file, in the background.
    void savePicture(const QString& path);

public slots:
    void hideOrShowDocks();
    void resetLayout();
    void openPalette();
    void openExport();
    void openPreferences();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void addDocks();
    void addOpening();
    void offerDoctor(const QString& path);
    QAction* makeDockAction(QDockWidget& dock);
    void addMenus();
    void arrange();
    void watch();
    void offerRecovery();
    void askAndSavePicture();
    void showTitle();
    void showProblems();
    void showPictureMenu(const QPoint& position);
    void showPlace(const QString& id, const QString& control);

    std::unique_ptr<Workspace> m_workspace; ///< goes after the widgets that look at it
    JobRunner m_pictures;                   ///< draws pictures into files
    PreviewWidget* m_preview;
    FileActions* m_files;
    ViewActions* m_views;
    Recovery* m_recovery;
    DropTarget* m_dropTarget;
    EditActions* m_edits;
    Tour* m_tour;
    HelpActions* m_help;
    CommandKeys* m_keys = nullptr;
    QMenu* m_dockMenu = nullptr;
    QList<QDockWidget*> m_hiddenDocks;
    QByteArray m_firstLayout;
};

} // namespace mirrorball::studio
