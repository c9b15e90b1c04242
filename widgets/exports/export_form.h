#pragma once

#include "core/scene/scene.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QWidget>

#include <functional>

namespace mirrorball::studio {

/// The settings of one map that is exported. It changes nothing itself: it says what is to be changed.
class ExportForm : public QWidget {
    Q_OBJECT

public:
    explicit ExportForm(QWidget* parent = nullptr);
    ~ExportForm() override;

    /// Shows a map's settings, of which only those that mean something for it are seen; null: none is selected.
    void showTarget(const ExportTarget* target);
    /// What the map will take, in words.
    void showEstimate(const QString& text) { m_files->setText(text); }
    /// Whether a map can become the scene's sphere map: where the scene has one.
    void offerPainted(bool hasMap);

signals:
    /// A control was used: `change` does to the map what it stands for, `label` names the undo step.
    void edited(const QString& label, const std::function<void(mirrorball::ExportTarget&)>& change);

private:
    void makeControls();
    void addRows();
    void connectNames();
    void connectLayout();
    void connectFiles();

    QFormLayout* m_rows;
    QLineEdit* m_name;
    QComboBox *m_kind, *m_parameterization, *m_format;
    QSpinBox *m_size, *m_border, *m_levels;
    QCheckBox *m_faces, *m_mips, *m_levelFiles;
    QLineEdit* m_file;
    QLabel* m_files;
};

} // namespace mirrorball::studio
