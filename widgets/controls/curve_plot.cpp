#include "curve_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double handleRadius = 4.5, reach = 9.0, pullDistance = 30.0;
constexpr double rampWidth = 5.0; ///< of the bars from dark to bright along the axes
constexpr double least = 0.005;   ///< between neighbors
constexpr size_t fewest = 2, most = 32;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

QColor colorOf(AdjustedChannels channels)
{
    switch (channels) {
    case AdjustedChannels::Red:
        return {235, 105, 95};
    case AdjustedChannels::Green:
        return {110, 205, 110};
    case AdjustedChannels::Blue:
        return {110, 155, 245};
    case AdjustedChannels::All:
        break;
    }
    return {235, 235, 235};
}

} // namespace

double curveFieldHigh(std::string_view name)
{
    double high = 1.0;
    const CurvePoint point;
    CurvePoint::visitFields(point, [&](const Field& field, const auto&) {
        if (field.name == name)
            high = field.high;
    });
    return high;
}

CurvePlot::CurvePlot(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setObjectName(QStringLiteral("curvePlot"));
    setAccessibleName(tr("Tone curve"));
    setToolTip(tr(
        "<p>Across: what the layer gets; up: what it makes of it. Both are square roots of linear light, about as the eye sees it: "
        "0 is black, 1 is white. Brighter light keeps its ratios.</p>"
        "<p>Click for a new point, drag to move it, pull it away or press Delete to remove it; double-click a point to put it back on the "
        "diagonal. Arrow keys move it, with Shift finer; Ctrl and arrows go from point to point.</p>"));
}

QRectF CurvePlot::square() const
{
    const double left = 12.0 + rampWidth, below = 16.0 + rampWidth, right = handleRadius + 2.0, above = handleRadius + 3.0;
    const double edge = std::max(20.0, std::min(width() - left - right, height() - above - below));
    return {left + 0.5 * std::max(0.0, width() - left - right - edge), above, edge, edge};
}

QPointF CurvePlot::placeOf(double x, double y) const
{
    const QRectF area = square();
    return {area.left() + x * area.width(), area.bottom() - y / m_top * area.height()};
}

CurvePoint CurvePlot::pointAt(const QPointF& place) const
{
    const QRectF area = square();
    return {.x = rounded(std::clamp((place.x() - area.left()) / area.width(), 0.0, 1.0)),
            .y = rounded(std::clamp((area.bottom() - place.y()) / area.height(), 0.0, 1.0) * m_top)};
}

/// The plot reaches to white, or farther where points do; it stays as it is during a drag.
void CurvePlot::fitTop()
{
    double highest = 0.0;
    for (const CurvePoint& point : m_points)
        highest = std::max(highest, point.y);
    m_top = highest <= 1.0 ? 1.0 : highest <= 2.0 ? 2.0 : curveFieldHigh("y");
    update();
}

void CurvePlot::setPoints(const std::vector<CurvePoint>& points)
{
    std::vector<CurvePoint> sorted = points;
    std::stable_sort(sorted.begin(), sorted.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; });
    if (sorted == m_points)
        return;
    m_points = std::move(sorted);
    m_chosen = std::clamp(m_chosen, 0, std::max(0, static_cast<int>(m_points.size()) - 1));
    if (!m_isDragging)
        fitTop();
    update();
    emit chosenChanged();
}

void CurvePlot::setChannels(AdjustedChannels channels)
{
    m_channels = channels;
    update();
}

void CurvePlot::choose(int index)
{
    const int wanted = std::clamp(index, 0, std::max(0, static_cast<int>(m_points.size()) - 1));
    if (wanted == m_chosen)
        return;
    m_chosen = wanted;
    update();
    emit chosenChanged();
}

/// False where there are too many points already, or one is there.
bool CurvePlot::insert(const CurvePoint& point)
{
    const auto next = std::find_if(m_points.begin(), m_points.end(), [&](const CurvePoint& other) { return other.x > point.x; });
    const bool isClose =
        (next != m_points.end() && next->x - point.x < least) || (next != m_points.begin() && point.x - (next - 1)->x < least);
    if (m_points.size() >= most || isClose)
        return false;
    m_chosen = static_cast<int>(next - m_points.begin());
    m_points.insert(next, point);
    update();
    emit edited(m_points);
    emit chosenChanged();
    return true;
}

void CurvePlot::addPoint(const CurvePoint& point)
{
    if (insert(point))
        emit finished();
}

void CurvePlot::removeChosen()
{
    if (m_points.size() <= fewest)
        return;
    m_points.erase(m_points.begin() + m_chosen);
    m_chosen = std::min(m_chosen, static_cast<int>(m_points.size()) - 1);
    fitTop();
    emit edited(m_points);
    emit finished();
    emit chosenChanged();
}

void CurvePlot::moveChosen(double x, double y)
{
    if (m_points.empty())
        return;
    const auto index = static_cast<size_t>(m_chosen);
    const double low = index > 0 ? m_points[index - 1].x + least : 0.0;
    const double high = index + 1 < m_points.size() ? m_points[index + 1].x - least : curveFieldHigh("x");
    CurvePoint moved = m_points[index];
    moved.x = low <= high ? rounded(std::clamp(x, low, high)) : moved.x;
    moved.y = rounded(std::clamp(y, 0.0, curveFieldHigh("y")));
    if (moved == m_points[index])
        return;
    m_points[index] = moved;
    if (!m_isDragging)
        fitTop();
    update();
    emit edited(m_points);
    emit chosenChanged();
}

void CurvePlot::reset()
{
    const std::vector<CurvePoint> identity{{0.0, 0.0}, {1.0, 1.0}};
    if (m_points == identity)
        return;
    m_points = identity;
    m_chosen = 0;
    fitTop();
    emit edited(m_points);
    emit finished();
    emit chosenChanged();
}

int CurvePlot::handleAt(const QPointF& place) const
{
    int best = -1;
    double nearest = reach;
    for (size_t i = 0; i < m_points.size(); ++i) {
        const QPointF off = placeOf(m_points[i].x, m_points[i].y) - place;
        if (const double distance = std::hypot(off.x(), off.y()); distance < nearest) {
            nearest = distance;
            best = static_cast<int>(i);
        }
    }
    return best;
}

/// A press near the curve adds a point on it, so that nothing changes before it is dragged.
void CurvePlot::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_points.empty())
        return;
    m_isNew = false;
    int handle = handleAt(event->position());
    if (handle < 0) {
        if (!square().adjusted(-reach, -reach, reach, reach).contains(event->position()))
            return;
        CurvePoint point = pointAt(event->position());
        const double y = m_points.size() < fewest ? point.y : static_cast<double>(CurveTable(m_points).at(static_cast<float>(point.x)));
        if (std::abs(placeOf(point.x, y).y() - event->position().y()) < reach)
            point.y = rounded(y);
        m_isDragging = true; // what is added and then dragged is one step
        m_isNew = insert(point);
        if (!m_isNew) {
            m_isDragging = false;
            return;
        }
        handle = m_chosen;
    }
    choose(handle);
    m_isDragging = true;
    const CurvePoint& held = m_points[static_cast<size_t>(m_chosen)];
    m_grabbed = placeOf(held.x, held.y) - event->position();
}

void CurvePlot::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_isDragging)
        return;
    const bool pulled = !QRectF(rect()).adjusted(-pullDistance, -pullDistance, pullDistance, pullDistance).contains(event->position());
    if (pulled && m_beforePull.empty() && m_points.size() > fewest) {
        m_beforePull = m_points;
        m_points.erase(m_points.begin() + m_chosen);
        update();
        emit edited(m_points);
        return;
    }
    if (!pulled && !m_beforePull.empty()) {
        m_points = std::move(m_beforePull);
        m_beforePull.clear();
    }
    if (m_beforePull.empty()) {
        const CurvePoint wanted = pointAt(event->position() + m_grabbed);
        moveChosen(wanted.x, wanted.y);
    }
}

void CurvePlot::mouseReleaseEvent(QMouseEvent*)
{
    if (!m_isDragging)
        return;
    m_isDragging = false;
    m_beforePull.clear();
    m_chosen = std::clamp(m_chosen, 0, std::max(0, static_cast<int>(m_points.size()) - 1));
    fitTop();
    emit finished();
    emit chosenChanged();
}

void CurvePlot::mouseDoubleClickEvent(QMouseEvent* event)
{
    const bool wasNew = m_isNew;
    mousePressEvent(event);
    if (!m_isDragging || wasNew)
        return;
    moveChosen(m_points[static_cast<size_t>(m_chosen)].x, m_points[static_cast<size_t>(m_chosen)].x);
    m_isDragging = false;
    fitTop();
    emit finished();
}

void CurvePlot::keyPressEvent(QKeyEvent* event)
{
    if (m_points.empty() || m_isDragging)
        return;
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
    const CurvePoint point = m_points[static_cast<size_t>(m_chosen)];
    const auto arrow = [&](double x, double y) {
        if (event->modifiers().testFlag(Qt::ControlModifier)) {
            choose(m_chosen + (x + y > 0.0 ? 1 : -1));
            return;
        }
        moveChosen(point.x + step * x, point.y + step * y);
        emit finished();
    };
    switch (event->key()) {
    case Qt::Key_Left:
        arrow(-1.0, 0.0);
        return;
    case Qt::Key_Right:
        arrow(1.0, 0.0);
        return;
    case Qt::Key_Up:
        arrow(0.0, 1.0);
        return;
    case Qt::Key_Down:
        arrow(0.0, -1.0);
        return;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        removeChosen();
        return;
    case Qt::Key_Insert: {
        const auto next = static_cast<size_t>(std::min(m_chosen + 1, static_cast<int>(m_points.size()) - 1));
        const auto last = next > 0 ? next - 1 : 0;
        const double x = rounded(0.5 * (m_points[last].x + m_points[next].x));
        if (m_points.size() >= fewest)
            addPoint({.x = x, .y = rounded(static_cast<double>(CurveTable(m_points).at(static_cast<float>(x))))});
        return;
    }
    default:
        QWidget::keyPressEvent(event);
    }
}

/// Grid, diagonal, numbers, and bars from black to white as a display shows square roots of light.
void CurvePlot::paintGround(QPainter& painter) const
{
    const QRectF area = square();
    painter.fillRect(area, palette().color(QPalette::Base));
    const QRectF across(area.left(), area.bottom() + 4.0, area.width(), rampWidth),
        up(area.left() - 4.0 - rampWidth, area.top(), rampWidth, area.height());
    QLinearGradient ramp(across.topLeft(), across.topRight());
    ramp.setColorAt(0.0, Qt::black);
    ramp.setColorAt(1.0, Qt::white);
    painter.fillRect(across, ramp);
    ramp.setStart(up.bottomLeft());
    ramp.setFinalStop(up.left(), up.bottom() - up.height() / m_top); // white stays white above 1
    painter.fillRect(up, ramp);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int i = 0; i <= 4; ++i) {
        painter.setPen(palette().color(i == 2 ? QPalette::Light : QPalette::Mid));
        const double x = area.left() + 0.25 * i * area.width(), y = area.top() + 0.25 * i * area.height();
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.0, Qt::DashLine));
    painter.setClipRect(area);
    painter.drawLine(placeOf(0.0, 0.0), placeOf(1.0, 1.0));
    painter.setClipping(false);
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    painter.setFont(small);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const double below = across.bottom() + 1.0;
    painter.drawText(QRectF(area.left() - 1.0, below, 30.0, 14.0), Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("0"));
    painter.drawText(QRectF(area.center().x() - 40.0, below, 80.0, 14.0), Qt::AlignCenter, tr("before"));
    painter.drawText(QRectF(area.right() - 30.0, below, 30.0, 14.0), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("1"));
    painter.drawText(QRectF(0.0, area.top() - 4.0, up.left() - 3.0, 14.0), Qt::AlignRight | Qt::AlignVCenter, QString::number(m_top));
    if (m_top > 1.0)
        painter.drawText(QRectF(0.0, placeOf(0.0, 1.0).y() - 7.0, up.left() - 3.0, 14.0), Qt::AlignRight | Qt::AlignVCenter,
                         QStringLiteral("1"));
}

void CurvePlot::paintCurve(QPainter& painter) const
{
    const QRectF area = square();
    const CurveTable table(m_points);
    const double ratio = devicePixelRatioF();
    const int columns = std::max(2, static_cast<int>(area.width() * ratio));
    QPainterPath path;
    for (int i = 0; i <= columns; ++i) {
        const double x = static_cast<double>(i) / columns;
        const QPointF place = placeOf(x, static_cast<double>(table.at(static_cast<float>(x))));
        i == 0 ? path.moveTo(place) : path.lineTo(place);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colorOf(m_channels), 1.6));
    painter.drawPath(path);
}

void CurvePlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGround(painter);
    if (m_points.size() < fewest)
        return;
    paintCurve(painter);
    const QColor color = colorOf(m_channels), amber = palette().color(QPalette::Highlight);
    for (size_t i = 0; i < m_points.size(); ++i) {
        const bool isChosen = static_cast<int>(i) == m_chosen && m_beforePull.empty();
        const QPointF place = placeOf(m_points[i].x, m_points[i].y);
        painter.setBrush(isChosen ? (hasFocus() ? amber : color) : palette().color(QPalette::Base));
        painter.setPen(QPen(isChosen && hasFocus() ? amber.lighter(140) : color, 1.6));
        painter.drawEllipse(place, isChosen ? handleRadius + 0.5 : handleRadius - 0.5, isChosen ? handleRadius + 0.5 : handleRadius - 0.5);
    }
}

} // namespace mirrorball::studio
