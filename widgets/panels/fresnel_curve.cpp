#include "fresnel_curve.h"

#include "core/shading/fresnel.h"
#include "core/sphere/direction.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball::studio {

namespace {

struct Curve {
    int channel;
    QColor color;
};

/// One gray curve where the channels agree.
std::vector<Curve> curves(const Fresnel& fresnel)
{
    if (fresnel.kind == FresnelKind::Conductor)
        return {{0, QColor(235, 96, 88)}, {1, QColor(110, 200, 110)}, {2, QColor(100, 150, 245)}};
    return {{1, QColor(225, 225, 225)}};
}

double reflectanceAt(const Fresnel& fresnel, int channel, double degrees)
{
    return reflectance(fresnel, std::cos(degrees * pi / 180.0))[channel];
}

} // namespace

FresnelCurve::FresnelCurve(Document& document, QWidget* parent) : QWidget(parent), m_document(document)
{
    setMouseTracking(true);
    setObjectName(QStringLiteral("fresnelCurve"));
    setAccessibleName(tr("Fresnel curve"));
    setToolTip(tr("How much of the light is mirrored (F), over the angle between the line of sight and the normal"));
    connect(&m_document, &Document::changed, this, [this](Parts parts) {
        if (parts.testFlag(Part::Material))
            update();
    });
}

QRectF FresnelCurve::plotArea() const
{
    const int text = fontMetrics().height();
    return QRectF(rect()).adjusted(fontMetrics().horizontalAdvance(QStringLiteral("100 %")) + 8, text + 4, -10, -text - 6);
}

void FresnelCurve::paintEvent(QPaintEvent*)
{
    const Fresnel fresnel = fresnelTerm(m_document.scene().material.fresnel);
    const QRectF plot = plotArea();
    const auto place = [&](double degrees, double f) {
        return QPointF(plot.left() + plot.width() * degrees / 90.0, plot.bottom() - plot.height() * std::clamp(f, 0.0, 1.0));
    };
    QPainter painter(this);
    painter.fillRect(plot, palette().color(QPalette::Base));
    const int text = fontMetrics().height();
    painter.setPen(palette().color(QPalette::PlaceholderText));
    for (const int percent : {0, 50, 100}) {
        const double y = place(0, percent / 100.0).y();
        painter.drawText(QRectF(0, y - text / 2.0, plot.left() - 6, text), Qt::AlignRight | Qt::AlignVCenter,
                         QStringLiteral("%1 %").arg(percent));
    }
    for (const int degrees : {0, 30, 60, 90})
        painter.drawText(QRectF(place(degrees, 0).x() - 30, plot.bottom() + 3, degrees == 90 ? 38 : 60, text),
                         degrees == 90 ? Qt::AlignRight : Qt::AlignHCenter, QStringLiteral("%1°").arg(degrees));
    painter.setPen(palette().color(QPalette::Mid));
    for (const double f : {0.25, 0.5, 0.75})
        painter.drawLine(place(0, f), place(90, f));
    for (const double degrees : {30.0, 60.0})
        painter.drawLine(place(degrees, 0), place(degrees, 1));

    painter.setRenderHint(QPainter::Antialiasing);
    for (const Curve& curve : curves(fresnel)) {
        QPainterPath path(place(0, reflectanceAt(fresnel, curve.channel, 0.0)));
        for (double degrees = 0.5; degrees <= 90.0; degrees += 0.5)
            path.lineTo(place(degrees, reflectanceAt(fresnel, curve.channel, degrees)));
        painter.setPen(QPen(curve.color, 1.6));
        painter.drawPath(path);
    }

    const double angle = m_angle < 0.0 ? 0.0 : m_angle;
    if (m_angle >= 0.0) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0, Qt::DashLine));
        painter.drawLine(place(angle, 0), place(angle, 1));
    }
    QStringList values;
    for (const Curve& curve : curves(fresnel))
        values << QString::number(100.0 * reflectanceAt(fresnel, curve.channel, angle), 'f', 1);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(plot.left(), 0, plot.width(), text + 2), Qt::AlignRight | Qt::AlignVCenter,
                     tr("F(%1°) = %2 %").arg(angle, 0, 'f', m_angle < 0.0 ? 0 : 1).arg(values.join(QStringLiteral(" / "))));
}

void FresnelCurve::mouseMoveEvent(QMouseEvent* event)
{
    const QRectF plot = plotArea();
    m_angle = std::clamp(90.0 * (event->position().x() - plot.left()) / plot.width(), 0.0, 90.0);
    update();
}

void FresnelCurve::leaveEvent(QEvent*)
{
    m_angle = -1.0;
    update();
}

} // namespace mirrorball::studio
