#include "handle_glyphs.h"

#include "widgets/controls/screen_color.h"

#include <QGuiApplication>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

const QColor edge(0, 0, 0, 190);
const QColor plain(235, 235, 235);

/// Draws a path twice: dark and wide, then in a color.
void stroke(QPainter& painter, const QPainterPath& path, const QColor& color, double width, Qt::PenStyle style = Qt::SolidLine)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(edge, width + 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(color, width, style, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

void knob(QPainter& painter, const QPointF& place, double radius, const QColor& fill, const QColor& line)
{
    painter.setPen(QPen(edge, 4.0));
    painter.setBrush(fill);
    painter.drawEllipse(place, radius, radius);
    painter.setPen(QPen(line, 1.8));
    painter.drawEllipse(place, radius, radius);
}

/// A disc in the light's color with rays around it; behind the ball an empty one.
void paintSun(QPainter& painter, const HandleGlyph& glyph, const QColor& fill, const QColor& line)
{
    const double radius = glyph.isChosen ? 6.0 : 4.5;
    QPainterPath rays;
    const int count = 8;
    for (int i = 0; i < count; ++i) {
        const double angle = (i + 0.5) * 2.0 * pi / count;
        const QPointF d(std::cos(angle), std::sin(angle));
        rays.moveTo(glyph.place + d * (radius + 3.2));
        rays.lineTo(glyph.place + d * (radius + (glyph.isChosen ? 7.2 : 5.2)));
    }
    stroke(painter, rays, line, glyph.isChosen ? 2.0 : 1.5);
    knob(painter, glyph.place, radius, glyph.isBehind || glyph.isOfMask ? QColor(0, 0, 0, 110) : fill, line);
}

void paintCenter(QPainter& painter, const HandleGlyph& glyph, const QColor& line)
{
    const double radius = glyph.isChosen ? 6.5 : 5.5, arm = 4.0;
    QPainterPath cross;
    for (const QPointF& d : {QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0), QPointF(0, -1)}) {
        cross.moveTo(glyph.place + d * radius);
        cross.lineTo(glyph.place + d * (radius + arm));
    }
    cross.addEllipse(glyph.place, radius, radius);
    stroke(painter, cross, line, 1.6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(line);
    painter.drawEllipse(glyph.place, 1.6, 1.6);
}

void paintCorner(QPainter& painter, const HandleGlyph& glyph, const QColor& line)
{
    const double half = glyph.isChosen ? 5.0 : 4.0;
    const QRectF box(glyph.place - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
    painter.setBrush(QColor(60, 60, 60));
    painter.setPen(QPen(edge, 4.0));
    painter.drawRect(box);
    painter.setPen(QPen(line, 1.8));
    painter.drawRect(box);
}

} // namespace

void paintHandle(QPainter& painter, const HandleGlyph& glyph)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor amber = QGuiApplication::palette().color(QPalette::Highlight).lighter(125);
    const QColor line = glyph.isHovered || (glyph.isChosen && glyph.hasFocus) ? amber : glyph.isChosen ? QColor(Qt::white) : plain;
    const QColor fill = glyph.color                       ? screenColor(*glyph.color)
                        : glyph.kind == HandleKind::Light ? QColor(255, 236, 180)
                                                          : QColor(60, 60, 60);
    const double radius = glyph.isChosen ? 5.5 : 4.5;
    const Qt::PenStyle style = glyph.isOfMask ? Qt::DashLine : Qt::SolidLine;
    QPainterPath guide;
    switch (glyph.kind) {
    case HandleKind::Light:
        paintSun(painter, glyph, fill, line);
        break;
    case HandleKind::Place:
        paintCenter(painter, glyph, line);
        break;
    case HandleKind::Corner:
        paintCorner(painter, glyph, line);
        break;
    case HandleKind::Arm:
        guide.moveTo(glyph.from);
        guide.lineTo(glyph.place);
        stroke(painter, guide, plain, 1.2, style);
        knob(painter, glyph.place, radius, fill, line);
        break;
    case HandleKind::Ring: {
        const QPointF way = glyph.place - glyph.from;
        const double around = std::hypot(way.x(), way.y());
        guide.addEllipse(glyph.from, around, around);
        stroke(painter, guide, plain, 1.2, style);
        knob(painter, glyph.place, radius, fill, line);
        break;
    }
    }
    painter.restore();
}

void paintHandleNote(QPainter& painter, const QPointF& place, const QString& note, const QRectF& area)
{
    const QRectF text = painter.boundingRect(QRectF(0, 0, 1000, 100), Qt::AlignLeft | Qt::AlignTop, note).adjusted(-7, -3, 7, 3);
    const QPointF corner(std::clamp(place.x() - 0.5 * text.width(), 4.0, std::max(4.0, area.width() - text.width() - 4.0)),
                         place.y() + 20.0 + text.height() > area.height() ? place.y() - 20.0 - text.height() : place.y() + 20.0);
    const QRectF box(corner, text.size());
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 20, 20, 210));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(QColor(240, 240, 240));
    painter.drawText(box, Qt::AlignCenter, note);
}

} // namespace mirrorball::studio
