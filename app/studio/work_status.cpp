#include "work_status.h"

#include "theme.h"

#include <cmath>

namespace mirrorball::studio {

WorkStatus::WorkStatus(QStatusBar& bar, Workspace& workspace, PreviewWidget& preview, JobRunner& pictures)
    : QObject(&bar), m_workspace(workspace), m_preview(preview), m_pictures(pictures), m_state(new QLabel(&bar)),
      m_progress(new QProgressBar(&bar)), m_stop(new QToolButton(&bar))
{
    m_state->setObjectName(QStringLiteral("workState"));
    m_state->setAccessibleName(tr("State of the work"));
    m_state->setProperty("role", QStringLiteral("footnote"));
    bar.addWidget(m_state, 1);
    addStop(bar);
    m_showProgress.setSingleShot(true);
    m_showProgress.setInterval(400);
    connect(&m_showProgress, &QTimer::timeout, this, [this] {
        m_progress->setValue(0);
        m_progress->show();
        m_stop->show();
        look();
    });
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &WorkStatus::look);
    const auto soon = [this] {
        if (!m_soon.isActive())
            m_soon.start();
    };
    connect(&m_workspace.document, &Document::changed, this, [this] { // maps and picture know of it already
        m_wasStopped = false;
        look();
    });
    connect(&m_workspace.document, &Document::dragFinished, this, soon);
    connect(&m_workspace.live, &LiveScene::updated, this, soon);
    connect(&m_preview, &PreviewWidget::painted, this, [this, soon](auto, double seconds) {
        m_drawSeconds = seconds;
        soon();
    });
    for (JobRunner* runner : {&m_workspace.live.runner(), &m_pictures}) {
        connect(runner, &JobRunner::busyChanged, this, soon);
        connect(runner, &JobRunner::progressed, this, [this](double fraction) {
            if (!m_progress->isHidden())
                m_progress->setValue(static_cast<int>(1000 * fraction));
        });
    }
}

void WorkStatus::addStop(QStatusBar& bar)
{
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedSize(160, 10);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setToolTip(tr("Progress of the work in the background"));
    m_stop->setIcon(icon("stop"));
    m_stop->setAutoRaise(true);
    m_stop->setAccessibleName(tr("Stop"));
    m_stop->setToolTip(tr("Stop the work in the background (Esc)"));
    m_stop->setShortcut(QKeySequence(Qt::Key_Escape));
    bar.addPermanentWidget(m_progress);
    bar.addPermanentWidget(m_stop);
    bar.setSizeGripEnabled(false);
    m_progress->hide();
    m_stop->hide();
    connect(m_stop, &QToolButton::clicked, this, [this] {
        m_wasStopped = true;
        m_workspace.live.stop();
        m_pictures.stop();
        look();
    });
}

// Each change of a widget composes the whole window anew: a text that is the same is none, and a drag changes it twice.
void WorkStatus::look()
{
    const bool busy = m_workspace.live.runner().isBusy() || m_pictures.isBusy();
    if (!busy) {
        m_showProgress.stop();
        m_progress->hide();
        m_stop->hide();
    } else if (!m_showProgress.isActive() && m_progress->isHidden()) {
        m_showProgress.start();
    }
    m_state->setText(state());
}

QString WorkStatus::state() const
{
    if (m_pictures.isBusy())
        return tr("Saving the picture…");
    if (m_wasStopped)
        return tr("Stopped");
    if (m_workspace.document.isDragging())
        return tr("Drawing…");
    if (m_workspace.live.runner().isBusy())
        return m_progress->isHidden() ? tr("Drawing…") : tr("Making maps…");
    if (!m_workspace.live.isUpToDate())
        return tr("Not made: the notice above the picture says why");
    if (!m_preview.isUpToDate() || m_drawSeconds < 0.0)
        return tr("Drawing…");
    return tr("Up to date. Drawn in %1 ms at %2 × %3")
        .arg(m_drawSeconds * 1e3, 0, 'f', 0)
        .arg(std::lround(m_preview.width() * m_preview.devicePixelRatioF()))
        .arg(std::lround(m_preview.height() * m_preview.devicePixelRatioF()));
}

} // namespace mirrorball::studio
