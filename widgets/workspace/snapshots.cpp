#include "snapshots.h"

#include "core/scene/scene_dependencies.h"

#include <cmath>

namespace mirrorball::studio {

namespace {

/// The middle of a picture, where the object is.
QImage thumbnailOf(const QImage& picture)
{
    if (picture.isNull())
        return {};
    constexpr QSize size = Snapshots::thumbnailSize;
    const QImage filled = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QImage middle = filled.copy(QRect(QPoint((filled.width() - size.width()) / 2, (filled.height() - size.height()) / 2), size));
    middle.setDevicePixelRatio(1.0);
    return middle;
}

} // namespace

void Snapshots::keep(std::shared_ptr<const PreparedScene> made, const QImage& picture)
{
    m_all.push_back({tr("Snapshot %1").arg(++m_kept), std::move(made), thumbnailOf(picture)});
    choose(static_cast<int>(m_all.size()) - 1);
}

void Snapshots::setPicture(const std::shared_ptr<const PreparedScene>& made, const QImage& picture)
{
    for (Snapshot& snapshot : m_all)
        if (snapshot.made == made && snapshot.thumbnail.isNull()) {
            snapshot.thumbnail = thumbnailOf(picture);
            emit listChanged();
        }
}

void Snapshots::rename(int index, const QString& name)
{
    QString& now = m_all.at(static_cast<size_t>(index)).name;
    const QString wanted = name.simplified();
    if (!wanted.isEmpty())
        now = wanted;
    emit listChanged();
    emit comparisonChanged();
}

void Snapshots::remove(int index)
{
    m_all.erase(m_all.begin() + index);
    if (m_chosen >= index)
        m_chosen = m_chosen > index || m_chosen == static_cast<int>(m_all.size()) ? m_chosen - 1 : m_chosen;
    emit listChanged();
    setComparison(m_comparison);
}

void Snapshots::choose(int index)
{
    m_chosen = index;
    emit listChanged();
    emit comparisonChanged();
}

void Snapshots::setComparison(Comparison comparison)
{
    m_comparison = compared() ? comparison : Comparison::Off;
    emit comparisonChanged();
}

void Snapshots::setError(const std::optional<PictureError>& error)
{
    if (error == m_error)
        return;
    m_error = error;
    emit errorChanged();
}

QString errorText(const std::optional<PictureError>& error)
{
    if (!error)
        return Snapshots::tr("measuring…");
    const QString psnr = std::isinf(error->psnr) ? QStringLiteral("∞") : QString::number(error->psnr, 'f', 1);
    return Snapshots::tr("rel_rms %1, PSNR %2 dB, SSIM %3")
        .arg(QString::number(error->relRms, 'g', 3), psnr, QString::number(error->ssim, 'f', 4));
}

Scene broughtBack(const Snapshot& snapshot, const Scene& now)
{
    Scene back = shownNow(snapshot.made->scene, now);
    back.exports = now.exports;
    return back;
}

} // namespace mirrorball::studio
