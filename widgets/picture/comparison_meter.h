#pragma once

#include "render_thread.h"

#include "widgets/workspace/job_runner.h"

#include <QObject>

#include <optional>

namespace mirrorball::studio {

/// Measures how far B is from A when both have come to rest: draws the two whole, which a wipe does not, and compares their display
/// values in the background. What it finds, the snapshots hold.
class ComparisonMeter : public QObject {
    Q_OBJECT

public:
    ComparisonMeter(Snapshots& snapshots, RenderThread& thread, QObject* parent);

    /// What is shown, at rest. Nothing is measured again that was; what compares nothing has no figures.
    void measure(const PictureOrder& order);
    /// Something moves: there are no figures until it rests.
    void wait();

private:
    Snapshots& m_snapshots;
    RenderThread& m_thread;
    JobRunner m_runner;
    std::optional<PictureOrder> m_of{}; ///< what the figures, or those that are on their way, are of
    QImage m_kept{};                    ///< A of the same; null while it is not drawn
};

} // namespace mirrorball::studio
