#pragma once

#include <QImage>
#include <QPainter>
#include <QSize>

/// What the preview paints beside the picture itself.
namespace mirrorball::studio {

/// What stands for nothing: a chequer of two grays.
void paintChequer(QPainter& painter, const QSize& size);
/// The line between a snapshot and now. @param x  in the widget
void paintWipeLine(QPainter& painter, double x, int height);
/// A picture of another size, until the one of this size is drawn: as high as that will be, so that nothing is stretched and the object
/// stays in place.
void paintInPlaceOf(QPainter& painter, const QImage& picture, const QSize& size);

} // namespace mirrorball::studio
