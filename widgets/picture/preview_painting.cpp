#include "preview_painting.h"

#include <algorithm>

namespace mirrorball::studio {

void paintChequer(QPainter& painter, const QSize& size)
{
    constexpr int square = 12;
    painter.fillRect(QRect(QPoint(), size), QColor(0x2e, 0x2e, 0x2e));
    for (int y = 0; y < size.height(); y += square)
        for (int x = y / square % 2 * square; x < size.width(); x += 2 * square)
            painter.fillRect(x, y, square, square, QColor(0x38, 0x38, 0x38));
}

void paintWipeLine(QPainter& painter, double x, int height)
{
    painter.setPen(QPen(QColor(20, 20, 20, 160), 3.0));
    painter.drawLine(QPointF(x, 0), QPointF(x, height));
    painter.setPen(QPen(QColor(235, 235, 235), 1.0));
    painter.drawLine(QPointF(x, 0), QPointF(x, height));
}

void paintInPlaceOf(QPainter& painter, const QImage& picture, const QSize& size)
{
    painter.fillRect(QRect(QPoint(), size), QColor(0x26, 0x26, 0x26));
    const double wide = static_cast<double>(picture.width()) * size.height() / std::max(1, picture.height());
    painter.drawImage(QRectF(0.5 * (size.width() - wide), 0.0, wide, size.height()), picture);
}

} // namespace mirrorball::studio
