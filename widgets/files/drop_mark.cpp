#include "drop_mark.h"

#include <QPainter>

namespace mirrorball::studio {

DropMark::DropMark(QWidget& over) : QWidget(&over)
{
    setObjectName(QStringLiteral("dropMark"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void DropMark::showText(const QString& text, Light light)
{
    m_text = text;
    m_light = light;
    setGeometry(parentWidget()->rect());
    raise();
    show();
    update();
}

void DropMark::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor light = palette().color(QPalette::Highlight);
    light.setAlphaF(isBright() ? 1.0f : 0.45f);
    QColor ground = light;
    ground.setAlphaF(isBright() ? 0.22f : 0.05f);
    painter.setPen(QPen(light, isBright() ? 3.0 : 1.5, isBright() ? Qt::SolidLine : Qt::DashLine));
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0), 5.0, 5.0);

    constexpr int flags = Qt::AlignCenter | Qt::TextWordWrap;
    const QRect room = rect().adjusted(14, 14, -14, -14);
    QRect words = painter.boundingRect(room, flags, m_text).adjusted(-10, -6, 10, 6) & rect().adjusted(4, 4, -4, -4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x1c, 0x1c, 0x1c, isBright() ? 235 : 190));
    painter.drawRoundedRect(words, 4.0, 4.0);
    painter.setPen(palette().color(isBright() ? QPalette::BrightText : QPalette::Text));
    painter.drawText(words.adjusted(6, 2, -6, -2), flags, m_text);
}

} // namespace mirrorball::studio
