#include "sphere_map_canvas.h"

#include "brush_ring.h"

#include "core/spheremap/strokes/symmetry.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

// What the canvas shows.
namespace mirrorball::studio {

namespace {

QPixmap checkerboard()
{
    QPixmap tile(16, 16);
    tile.fill(QColor(72, 72, 72));
    QPainter painter(&tile);
    painter.fillRect(0, 0, 8, 8, QColor(88, 88, 88));
    painter.fillRect(8, 8, 8, 8, QColor(88, 88, 88));
    return tile;
}

/// Thin light and dark, so that it shows on every color.
void outline(QPainter& painter, const QPointF& center, double radius, int strength)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, strength), 2.6));
    painter.drawEllipse(center, radius, radius);
    painter.setPen(QPen(QColor(255, 255, 255, strength), 1.0));
    painter.drawEllipse(center, radius, radius);
}

} // namespace

void SphereMapCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    static const QPixmap checks = checkerboard();
    painter.fillRect(rect(), QColor(38, 38, 38));
    const QRectF square(placeOf({-1.0, 1.0}), placeOf({1.0, -1.0}));
    QPainterPath disc;
    disc.addEllipse(square);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_editor.map()) {
        painter.setPen(QPen(QColor(90, 90, 90), 1.5, Qt::DashLine));
        painter.drawPath(disc);
        painter.setPen(QColor(170, 170, 170));
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("This scene has no sphere map of its own"));
        return;
    }
    // Outside the disc the rim's color goes on, which a lookup may meet: shown, but faintly.
    // One level by itself shows its texels.
    const QImage& level = m_editor.levelPicture();
    const QImage& picture = level.isNull() ? m_editor.screen().forPixels(square.width() * devicePixelRatioF()) : level;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, level.isNull() || level.width() > square.width() * devicePixelRatioF());
    painter.setOpacity(0.22);
    painter.drawImage(square, picture);
    painter.setOpacity(1.0);
    painter.save();
    painter.setClipPath(disc);
    painter.drawTiledPixmap(square.toAlignedRect().intersected(rect()), checks);
    painter.drawImage(square, picture);
    painter.restore();
    painter.setPen(QPen(QColor(0, 0, 0, 140), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(disc);
    if (m_handles.isActive()) {
        m_handles.paint(painter, rect(), hasFocus() ? DiscHandles::Focus::Keys : DiscHandles::Focus::None);
    } else {
        paintSymmetry(painter);
        paintBrush(painter);
    }
    if (m_editor.onlyLevel())
        paintWords(painter, m_editor.onlyLevelText(), Qt::AlignHCenter | Qt::AlignTop, QColor(240, 240, 240));
    if (!m_hint.isEmpty())
        paintWords(painter, m_hint, Qt::AlignHCenter | Qt::AlignBottom, QColor(240, 200, 120));
}

void SphereMapCanvas::paintWords(QPainter& painter, const QString& words, Qt::Alignment where, const QColor& color) const
{
    const QRect box = rect().adjusted(8, 8, -8, -8);
    const QRect text = painter.boundingRect(box, static_cast<int>(where) | Qt::TextWordWrap, words).adjusted(-8, -5, 8, 5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 20, 20, 220));
    painter.drawRoundedRect(text, 4, 4);
    painter.setPen(color);
    painter.drawText(text, Qt::AlignCenter | Qt::TextWordWrap, words);
}

void SphereMapCanvas::paintBrush(QPainter& painter) const
{
    if (!m_cursor || m_drag == Drag::Pan || m_editor.tool() == PaintTool::PickColor)
        return;
    const Brush& brush = m_editor.brush();
    const double radius = brush.radius * scale();
    const QPointF at = m_drag == Drag::Brush ? m_pressed : m_drag == Drag::Stroke ? brushPlace() : *m_cursor;
    const glm::dvec2 q = discAt(at);
    if (m_drag == Drag::Stroke && at != *m_cursor)
        paintString(painter, {at, *m_cursor});
    const auto maps = symmetryMaps(m_editor.symmetry());
    for (size_t i = 1; i < maps.size(); ++i)
        outline(painter, placeOf(maps[i] * q), radius, 70);
    outline(painter, at, std::max(radius, 1.0), 220);
    if (brush.hardness > 0.0 && brush.hardness < 1.0)
        outline(painter, at, std::max(radius * brush.hardness, 1.0), m_drag == Drag::Brush ? 200 : 60);
    if (m_drag == Drag::Brush) {
        painter.setPen(Qt::white);
        painter.drawText(QRectF(at.x() - 100, at.y() + radius + 4, 200, 20), Qt::AlignHCenter,
                         tr("radius %1, hardness %2").arg(brush.radius, 0, 'f', 3).arg(brush.hardness, 0, 'f', 2));
    }
}

void SphereMapCanvas::paintSymmetry(QPainter& painter) const
{
    const Symmetry& symmetry = m_editor.symmetry();
    if (symmetry.radial <= 1 && !symmetry.mirror)
        return;
    const auto line = [&](double angle, bool through) {
        const glm::dvec2 d{std::cos(angle), std::sin(angle)};
        const QPointF from = placeOf(through ? -d : glm::dvec2(0.0)), to = placeOf(d);
        painter.setPen(QPen(QColor(0, 0, 0, 90), 1.0));
        painter.drawLine(from + QPointF(1, 1), to + QPointF(1, 1));
        painter.setPen(QPen(QColor(255, 255, 255, 130), 1.0, Qt::DashLine));
        painter.drawLine(from, to);
    };
    const double axis = symmetry.axisDeg * pi / 180.0;
    if (symmetry.mirror)
        for (int k = 0; k < symmetry.radial; ++k)
            line(axis + pi * k / symmetry.radial, true);
    else
        for (int k = 0; k < symmetry.radial; ++k)
            line(axis + 2.0 * pi * k / symmetry.radial, false);
}

} // namespace mirrorball::studio
