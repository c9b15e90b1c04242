#pragma once

#include "widgets/picture/preview_widget.h"
#include "widgets/workspace/workspace.h"

#include <QLabel>
#include <QObject>
#include <QProgressBar>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

namespace mirrorball::studio {

/// The status line: what is being made, how far it is, and how to stop it. "Up to date" is said when maps and picture are.
class WorkStatus : public QObject {
    Q_OBJECT

public:
    /// @param pictures  draws pictures into files
    WorkStatus(QStatusBar& bar, Workspace& workspace, PreviewWidget& preview, JobRunner& pictures);
    QString text() const { return m_state->text(); }

private:
    void addStop(QStatusBar& bar);
    void look();
    QString state() const;

    Workspace& m_workspace;
    PreviewWidget& m_preview;
    JobRunner& m_pictures;
    QLabel* m_state;
    QProgressBar* m_progress;
    QToolButton* m_stop;
    QTimer m_showProgress; ///< work that is done at once shows none
    QTimer m_soon;         ///< when all of this moment's events are through
    bool m_wasStopped = false;
    double m_drawSeconds = -1.0;
};

} // namespace mirrorball::studio
