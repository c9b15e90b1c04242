#include "brush_ring.h"

namespace mirrorball::studio {

void paintString(QPainter& painter, const QLineF& string)
{
    painter.setPen(QPen(QColor(0, 0, 0, 160), 2.6));
    painter.drawLine(string);
    painter.setPen(QPen(QColor(255, 255, 255, 200), 1.0));
    painter.drawLine(string);
}

BrushRing::BrushRing(QWidget& over) : QWidget(&over)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setGeometry(over.rect());
    QWidget::hide();
}

void BrushRing::show(const QPolygonF& outline, const QString& note, const QLineF& string)
{
    if (outline == m_outline && note == m_note && string == m_string)
        return;
    m_outline = outline;
    m_note = note;
    m_string = string;
    setVisible(!outline.isEmpty());
    update();
}

void BrushRing::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (!m_string.isNull())
        paintString(painter, m_string);
    painter.setPen(QPen(QColor(0, 0, 0, 200), 2.6)); // dark and light, so that it shows on every color
    painter.drawPolygon(m_outline);
    painter.setPen(QPen(QColor(255, 255, 255, 220), 1.0));
    painter.drawPolygon(m_outline);
    if (m_note.isEmpty())
        return;
    const QRectF box = m_outline.boundingRect();
    const QRectF place(box.center().x() - 120.0, box.bottom() + 4.0, 240.0, 20.0);
    painter.setPen(QColor(0, 0, 0, 200));
    painter.drawText(place.translated(1, 1), Qt::AlignHCenter | Qt::AlignTop, m_note);
    painter.setPen(Qt::white);
    painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop, m_note);
}

} // namespace mirrorball::studio
