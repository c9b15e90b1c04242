#include "color_button.h"

#include "color_parts.h"
#include "color_picker.h"

#include <QApplication>
#include <QClipboard>
#include <QColorDialog>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>

namespace mirrorball::studio {

ColorButton::ColorButton(QWidget* parent) : QPushButton(parent)
{
    setMinimumWidth(64);
    connect(this, &QPushButton::clicked, this, &ColorButton::choose);
}

void ColorButton::setColor(const glm::dvec3& linear)
{
    if (linear == m_color)
        return;
    m_color = linear;
    update();
    emit colorChanged(linear);
}

void ColorButton::pick(const glm::dvec3& linear)
{
    setColor(linear);
    emit edited(linear);
}

void ColorButton::choose()
{
    if (ColorPicker* picker = ColorPicker::of(*this)) {
        picker->edit(*this);
        return;
    }
    const glm::dvec3 before = m_color;
    const ColorParts parts = colorParts(m_color);
    QColorDialog dialog(parts.shown, this);
    dialog.setWindowTitle(accessibleName());
    dialog.setOption(QColorDialog::DontUseNativeDialog);
    connect(&dialog, &QColorDialog::currentColorChanged, this, [this, ev = parts.ev](const QColor& color) {
        emit edited(linearColor({color, ev}));
    });
    if (dialog.exec() != QDialog::Accepted)
        emit edited(before);
    emit finished();
}

void ColorButton::contextMenuEvent(QContextMenuEvent* event)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("swatchMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const ColorParts parts = colorParts(m_color);
    menu->addAction(tr("Copy %1").arg(hexText(parts)), this, [parts] { QApplication::clipboard()->setText(hexText(parts)); });
    menu->addAction(tr("Copy as linear numbers"), this, [color = m_color] {
        QApplication::clipboard()->setText(QStringLiteral("%1 %2 %3").arg(color.r).arg(color.g).arg(color.b));
    });
    const std::optional<QColor> copied = colorOfHex(QApplication::clipboard()->text());
    QAction* paste = menu->addAction(copied ? tr("Paste %1").arg(copied->name()) : tr("Paste"), this, [this, copied] {
        pick(linearColor({*copied, colorParts(m_color).ev}));
        emit finished();
    });
    paste->setEnabled(copied.has_value());
    menu->popup(event->globalPos());
}

void ColorButton::paintEvent(QPaintEvent* event)
{
    QPushButton::paintEvent(event);
    const ColorParts parts = colorParts(m_color);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Shadow), 1.0));
    painter.setBrush(parts.shown);
    const QRectF swatch = QRectF(rect()).adjusted(5.5, 4.5, -5.5, -4.5);
    painter.drawRoundedRect(swatch, 2.0, 2.0);
    if (parts.ev > 0.0) {
        painter.setPen(parts.shown.lightnessF() > 0.5f ? Qt::black : Qt::white);
        painter.drawText(swatch, Qt::AlignCenter, QStringLiteral("+%1").arg(parts.ev, 0, 'f', 1));
    }
}

} // namespace mirrorball::studio
