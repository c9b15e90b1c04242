#include "method_chart.h"

#include "chart_style.h"

#include "widgets/controls/text.h"

#include "widgets/controls/color_scale_bar.h"

#include <QMouseEvent>
#include <QToolTip>
#include <QtCharts/QChart>
#include <QtCharts/QLegend>

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double leastError = 1e-12; ///< an error of 0 has no place on a logarithmic axis
constexpr double reach = 12.0;       ///< pixels around a point that take a click

bool isDrawn(const RacePoint& point) { return point.state == MeasurementState::Measured && point.setting.method != Method::Reference; }

QPointF valueOf(const RacePoint& point) { return {std::max(point.seconds, 1e-7), std::max(point.error.relRms, leastError)}; }

} // namespace

/// Nine hues that stay apart on dark gray, also for eyes that confuse red and green (after Okabe and Ito 2008).
QColor methodColor(Method method)
{
    constexpr std::array<QRgb, allMethods.size()> colors{0xfff0e442, 0xffaaaaaa, 0xff56b4e9, 0xff009e73, 0xffcc79a7,
                                                         0xffe69f00, 0xffd55e00, 0xff7a8cff, 0xffb6e3a1};
    static_assert(colors.back() != 0, "every method has its color");
    return QColor::fromRgb(colors[static_cast<size_t>(method)]);
}

MethodChart::MethodChart(QWidget* parent)
    : QChartView(parent), m_time(new QLogValueAxis(this)), m_error(new QLogValueAxis(this)), m_front(new QLineSeries(this)),
      m_ring(new QScatterSeries(this))
{
    setAccessibleName(tr("Error against run time"));
    setToolTip(tr("A point is a method with one setting: further left is faster, further down more accurate. Click one to pick it; the "
                  "table below does the same."));
    styleChart(*this);
    setMouseTracking(true);
    viewport()->setMouseTracking(true);
    QChart* c = chart();
    c->legend()->hide(); // the table beside it has the methods in their colors
    for (QLogValueAxis* axis : {m_time, m_error}) {
        axis->setBase(10.0);
        axis->setMinorTickCount(0);
        axis->setLabelFormat(QStringLiteral("%.0e"));
        styleAxis(*axis, font());
    }
    m_time->setTitleText(tr("seconds"));
    m_error->setTitleText(tr("rel_rms"));
    c->addAxis(m_time, Qt::AlignBottom);
    c->addAxis(m_error, Qt::AlignLeft);
    const auto add = [&](QXYSeries* series) {
        c->addSeries(series);
        series->attachAxis(m_time);
        series->attachAxis(m_error);
    };
    m_front->setName(tr("front"));
    m_front->setPen(QPen(QColor(0x88, 0x88, 0x88), 1.0, Qt::DashLine));
    add(m_front);
    for (const Method method : allMethods) {
        if (method == Method::Reference)
            continue;
        auto* series = new QScatterSeries(this);
        series->setName(fieldText(name(method)));
        series->setColor(methodColor(method));
        series->setBorderColor(QColor(0x1c, 0x1c, 0x1c));
        series->setMarkerSize(9.0);
        series->setVisible(false);
        m_series[method] = series;
        add(series);
    }
    m_ring->setMarkerSize(16.0);
    m_ring->setColor(Qt::transparent);
    m_ring->setBorderColor(Qt::white);
    add(m_ring);
    fitAxes();
}

void MethodChart::fitAxes()
{
    double low = 1e-4, high = 1.0, least = 1e-6, most = 1.0;
    bool isFirst = true;
    for (const RacePoint& point : m_points) {
        if (!isDrawn(point))
            continue;
        const QPointF at = valueOf(point);
        low = isFirst ? at.x() : std::min(low, at.x());
        high = isFirst ? at.x() : std::max(high, at.x());
        least = isFirst ? at.y() : std::min(least, at.y());
        most = isFirst ? at.y() : std::max(most, at.y());
        isFirst = false;
    }
    // Whole decades, with the points off the edges.
    const auto down = [](double x) { return std::pow(10.0, std::floor(std::log10(x) - 0.1)); };
    const auto up = [](double x) { return std::pow(10.0, std::ceil(std::log10(x) + 0.1)); };
    m_time->setRange(down(low), up(high));
    m_error->setRange(down(least), up(most));
    fitLabels();
}

/// A label every so many decades that each has room.
void MethodChart::fitLabels()
{
    const QSize label = fontMetrics().size(Qt::TextSingleLine, QStringLiteral("1e-07  "));
    const auto fit = [](QLogValueAxis& axis, double labels) {
        const double decades = std::log10(axis.max() / axis.min());
        axis.setBase(std::pow(10.0, std::max(1.0, std::ceil(decades / std::max(1.0, labels)))));
    };
    fit(*m_time, (width() - 70.0) / label.width());
    fit(*m_error, (height() - 60.0) / label.height());
}

void MethodChart::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    fitLabels();
}

void MethodChart::setPoints(const std::vector<RacePoint>& points)
{
    m_points = points;
    fitAxes();
    std::map<Method, QList<QPointF>> values;
    for (const RacePoint& point : points)
        if (isDrawn(point))
            values[point.setting.method] << valueOf(point);
    for (const auto& [method, series] : m_series) {
        series->replace(values[method]);
        series->setVisible(!values[method].isEmpty());
    }
    QList<QPointF> front;
    const std::vector<bool> isFront = onFront(points);
    for (size_t i = 0; i < points.size(); ++i)
        if (isFront[i] && isDrawn(points[i]))
            front << valueOf(points[i]);
    std::sort(front.begin(), front.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
    m_front->replace(front);
    m_front->setVisible(!front.isEmpty());
    setPicked(m_picked);
}

void MethodChart::setPicked(int index)
{
    m_picked = index;
    QList<QPointF> ring;
    if (index >= 0 && index < static_cast<int>(m_points.size()) && isDrawn(m_points[static_cast<size_t>(index)]))
        ring << valueOf(m_points[static_cast<size_t>(index)]);
    m_ring->replace(ring);
    m_ring->setVisible(!ring.isEmpty());
}

std::optional<QPointF> MethodChart::positionOf(int index) const
{
    if (index < 0 || index >= static_cast<int>(m_points.size()) || !isDrawn(m_points[static_cast<size_t>(index)]))
        return std::nullopt;
    return mapFromScene(chart()->mapToPosition(valueOf(m_points[static_cast<size_t>(index)]), m_front));
}

int MethodChart::pointAt(const QPointF& position) const
{
    int best = -1;
    double nearest = reach;
    for (int i = 0; i < static_cast<int>(m_points.size()); ++i)
        if (const auto at = positionOf(i)) {
            const double distance = std::hypot(at->x() - position.x(), at->y() - position.y());
            if (distance < nearest) {
                nearest = distance;
                best = i;
            }
        }
    return best;
}

void MethodChart::mousePressEvent(QMouseEvent* event)
{
    if (const int index = pointAt(event->position()); index >= 0 && event->button() == Qt::LeftButton)
        emit picked(index);
}

void MethodChart::mouseMoveEvent(QMouseEvent* event)
{
    const int index = pointAt(event->position());
    if (index < 0) {
        viewport()->unsetCursor();
        QToolTip::hideText();
        return;
    }
    viewport()->setCursor(Qt::PointingHandCursor);
    const RacePoint& point = m_points[static_cast<size_t>(index)];
    QToolTip::showText(event->globalPosition().toPoint(),
                       tr("%1 %2\n%3 s, rel_rms %4")
                           .arg(toQString(name(point.setting.method)), toQString(point.setting.label), shortNumberText(point.seconds),
                                shortNumberText(point.error.relRms)),
                       this);
}

} // namespace mirrorball::studio
