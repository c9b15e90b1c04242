#include "comparison_meter.h"

namespace mirrorball::studio {

namespace {

/// The display values of a picture, in [0, 1].
Image displayValues(const QImage& picture)
{
    Image values(picture.width(), picture.height(), 3);
    for (int y = 0; y < values.height; ++y) {
        const auto* from = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
        float* to = values.row(y);
        for (int x = 0; x < values.width; ++x, to += 3) {
            to[0] = static_cast<float>(qRed(from[x])) / 255.0f;
            to[1] = static_cast<float>(qGreen(from[x])) / 255.0f;
            to[2] = static_cast<float>(qBlue(from[x])) / 255.0f;
        }
    }
    return values;
}

/// The order without what the figures do not depend on.
PictureOrder measured(PictureOrder order)
{
    order.size = {};
    order.comparison = Comparison::Difference;
    order.wipe = 0;
    order.number = 0;
    order.settings.marker.reset();
    order.snapshotSettings.marker.reset();
    return order;
}

} // namespace

ComparisonMeter::ComparisonMeter(Snapshots& snapshots, RenderThread& thread, QObject* parent)
    : QObject(parent), m_snapshots(snapshots), m_thread(thread), m_runner(this)
{
}

void ComparisonMeter::measure(const PictureOrder& order)
{
    const Snapshot* kept = m_snapshots.compared();
    const bool comparesNothing = order.comparison == Comparison::Off || (order.comparison == Comparison::Hold && !kept->thumbnail.isNull());
    if (!kept || comparesNothing) {
        wait();
        return;
    }
    const PictureOrder wanted = measured(order);
    if (wanted == m_of) {
        if (!m_kept.isNull())
            m_snapshots.setPicture(wanted.snapshot, m_kept); // a snapshot taken since may show the same
        return;
    }
    wait();
    m_of = wanted;
    m_thread.drawPair(wanted, [this, wanted](const PicturePair& pair) {
        if (wanted != m_of || pair.now.isNull())
            return; // something else is shown by now
        m_kept = pair.kept;
        m_snapshots.setPicture(wanted.snapshot, m_kept);
        m_runner.start([pair](const JobControl& job) { return pictureError(displayValues(pair.now), displayValues(pair.kept), job); },
                       [this](const PictureError& error) { m_snapshots.setError(error); });
    });
}

void ComparisonMeter::wait()
{
    m_of.reset();
    m_kept = {};
    m_runner.stop();
    m_snapshots.setError({});
}

} // namespace mirrorball::studio
