#include "color_wheel.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorball::studio {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Hue in turns, saturation as a fraction of the radius; y up.
QPointF placeOf(double hue, double saturation) { return {saturation * std::cos(turn * hue), -saturation * std::sin(turn * hue)}; }

} // namespace

ColorWheel::ColorWheel(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ColorWheel::setHsv(double hue, double saturation, double value)
{
    m_hue = hue;
    m_saturation = saturation;
    m_value = value;
    update();
}

QRectF ColorWheel::disc() const
{
    const double edge = std::min(width(), height()) - 8.0;
    return {0.5 * (width() - edge), 0.5 * (height() - edge), edge, edge};
}

void ColorWheel::paintEvent(QPaintEvent*)
{
    const QRectF area = disc();
    const double ratio = devicePixelRatioF();
    const int edge = std::max(1, static_cast<int>(std::ceil(area.width() * ratio)));
    if (m_image.width() != edge || m_imageValue != m_value) {
        m_image = QImage(edge, edge, QImage::Format_ARGB32_Premultiplied);
        m_image.fill(Qt::transparent);
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const double u = (2.0 * x + 1.0) / edge - 1.0, v = 1.0 - (2.0 * y + 1.0) / edge;
                const double radius = std::hypot(u, v), hue = std::atan2(v, u) / turn;
                const double cover = std::clamp((1.0 - radius) * 0.5 * edge + 0.5, 0.0, 1.0);
                if (cover > 0.0) {
                    QColor color = QColor::fromHsvF(static_cast<float>(hue - std::floor(hue)), static_cast<float>(std::min(radius, 1.0)),
                                                    static_cast<float>(m_value));
                    color.setAlphaF(static_cast<float>(cover));
                    m_image.setPixel(x, y, qPremultiply(color.rgba()));
                }
            }
        m_imageValue = m_value;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(area, m_image);
    const QPointF at = area.center() + 0.5 * area.width() * placeOf(m_hue, m_saturation);
    for (const auto& [color, width] : {std::pair{QColor(20, 20, 20), 3.5}, std::pair{QColor(240, 240, 240), 1.5}}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(at, 5.5, 5.5);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.drawEllipse(area.adjusted(-2.0, -2.0, 2.0, 2.0));
    }
}

void ColorWheel::chooseAt(const QPointF& position)
{
    const QPointF from = (position - disc().center()) / (0.5 * disc().width());
    const double hue = std::atan2(-from.y(), from.x()) / turn;
    m_saturation = std::min(1.0, std::hypot(from.x(), from.y()));
    m_hue = hue - std::floor(hue);
    update();
    emit edited(m_hue, m_saturation);
}

void ColorWheel::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        chooseAt(event->position());
}

void ColorWheel::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        chooseAt(event->position());
}

void ColorWheel::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit finished();
}

void ColorWheel::keyPressEvent(QKeyEvent* event)
{
    const double around = event->key() == Qt::Key_Left ? 1.0 : event->key() == Qt::Key_Right ? -1.0 : 0.0;
    const double out = event->key() == Qt::Key_Up ? 1.0 : event->key() == Qt::Key_Down ? -1.0 : 0.0;
    if (around == 0.0 && out == 0.0) {
        QWidget::keyPressEvent(event);
        return;
    }
    const double hue = m_hue + around / 72.0;
    m_hue = hue - std::floor(hue);
    m_saturation = std::clamp(m_saturation + 0.04 * out, 0.0, 1.0);
    update();
    emit edited(m_hue, m_saturation);
    emit finished();
}

} // namespace mirrorball::studio
