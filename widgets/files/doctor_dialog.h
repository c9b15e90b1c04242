#pragma once

#include "widgets/workspace/job_runner.h"
#include "widgets/workspace/workspace.h"

#include <QComboBox>
#include <QDialog>
#include <QPlainTextEdit>
#include <QProgressBar>

namespace mirrorball::studio {

/// "What is this map?": the doctor's words about a prefiltered map of anyone (core/doctor). With what the map was made from it tells
/// orientation, law, scale and the error of every level; without, what the levels tell of each other.
class DoctorDialog : public QDialog {
    Q_OBJECT

public:
    DoctorDialog(Workspace& workspace, const QString& map, QWidget* parent);

    /// The doctor's words, or why there are none; empty while the map is examined.
    QString text() const { return m_text->toPlainText(); }
    QComboBox& source() { return *m_source; }

private:
    void chooseSource();
    void examine();

    QString m_map;
    QComboBox* m_source; ///< what the map was made from
    QPlainTextEdit* m_text;
    QProgressBar* m_progress;
    JobRunner m_runner;
};

} // namespace mirrorball::studio
