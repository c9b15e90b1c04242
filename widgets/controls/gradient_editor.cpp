#include "gradient_editor.h"

#include "screen_color.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double handleHalf = 6.0, barHeight = 24.0, pullDistance = 30.0;
constexpr size_t mostStops = 64;

} // namespace

GradientBar::GradientBar(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setObjectName(QStringLiteral("gradientBar"));
    setAccessibleName(tr("Gradient stops"));
    setToolTip(tr("Drag a stop to move it, pull it away to remove it; double-click for a new one"));
}

QRectF GradientBar::bar() const { return {handleHalf + 1.0, 2.0, std::max(1.0, width() - 2.0 * handleHalf - 2.0), barHeight}; }

double GradientBar::positionAt(double x) const
{
    return std::round(std::clamp((x - bar().left()) / bar().width(), 0.0, 1.0) * 1000.0) / 1000.0;
}

double GradientBar::placeOf(double position) const { return bar().left() + position * bar().width(); }

void GradientBar::setStops(const std::vector<GradientStop>& stops)
{
    if (stops == m_stops)
        return;
    m_stops = stops;
    choose(m_chosen);
    update();
    emit chosenChanged();
}

void GradientBar::choose(int index)
{
    const int wanted = std::clamp(index, 0, std::max(0, static_cast<int>(m_stops.size()) - 1));
    if (wanted == m_chosen)
        return;
    m_chosen = wanted;
    update();
    emit chosenChanged();
}

void GradientBar::addStop(double position)
{
    if (m_stops.size() >= mostStops)
        return;
    const GradientTable table(m_stops, ColorMixing::Oklab);
    const GradientTable::Entry here = table.at(static_cast<float>(position));
    const auto rounded = [](float x) { return std::round(static_cast<double>(x) * 1e5) / 1e5; };
    m_stops.push_back({position, {rounded(here.r), rounded(here.g), rounded(here.b)}, m_stops.empty() ? 1.0 : rounded(here.a)});
    m_chosen = static_cast<int>(m_stops.size()) - 1;
    update();
    emit edited(m_stops);
    emit finished();
    emit chosenChanged();
}

void GradientBar::removeChosen()
{
    if (m_stops.size() <= 1)
        return;
    m_stops.erase(m_stops.begin() + m_chosen);
    m_chosen = std::min(m_chosen, static_cast<int>(m_stops.size()) - 1);
    update();
    emit edited(m_stops);
    emit finished();
    emit chosenChanged();
}

void GradientBar::changeChosen(const std::function<void(GradientStop&)>& change)
{
    if (m_stops.empty())
        return;
    const GradientStop before = m_stops[static_cast<size_t>(m_chosen)];
    change(m_stops[static_cast<size_t>(m_chosen)]);
    if (m_stops[static_cast<size_t>(m_chosen)] == before)
        return;
    update();
    emit edited(m_stops);
    emit chosenChanged();
}

int GradientBar::handleAt(const QPointF& place) const
{
    int best = -1;
    double nearest = handleHalf + 3.0;
    for (size_t i = 0; i < m_stops.size(); ++i) {
        const double distance = std::abs(place.x() - placeOf(m_stops[i].position));
        if (distance < nearest || (distance == nearest && static_cast<int>(i) == m_chosen)) {
            nearest = distance;
            best = static_cast<int>(i);
        }
    }
    return best;
}

void GradientBar::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const int handle = handleAt(event->position());
    m_isDragging = handle >= 0;
    if (m_isDragging)
        choose(handle);
}

void GradientBar::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_isDragging)
        return;
    const bool pulled = event->position().y() < -pullDistance || event->position().y() > height() + pullDistance;
    if (pulled && m_beforePull.empty() && m_stops.size() > 1) {
        m_beforePull = m_stops;
        m_stops.erase(m_stops.begin() + m_chosen);
        update();
        emit edited(m_stops);
        return;
    }
    if (!pulled && !m_beforePull.empty()) {
        m_stops = std::move(m_beforePull);
        m_beforePull.clear();
    }
    if (m_beforePull.empty())
        changeChosen([&](GradientStop& stop) { stop.position = positionAt(event->position().x()); });
}

void GradientBar::mouseReleaseEvent(QMouseEvent*)
{
    if (!m_isDragging)
        return;
    m_isDragging = false;
    m_beforePull.clear();
    m_chosen = std::clamp(m_chosen, 0, std::max(0, static_cast<int>(m_stops.size()) - 1));
    emit finished();
    emit chosenChanged();
}

void GradientBar::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && handleAt(event->position()) < 0)
        addStop(positionAt(event->position().x()));
}

void GradientBar::keyPressEvent(QKeyEvent* event)
{
    const bool along = event->modifiers().testFlag(Qt::ControlModifier);
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.001 : 0.01;
    const auto move = [&](double sign) {
        if (along) {
            // From left to right, whatever the order in the list.
            std::vector<int> order(m_stops.size());
            for (size_t i = 0; i < order.size(); ++i)
                order[i] = static_cast<int>(i);
            std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
                return m_stops[static_cast<size_t>(a)].position < m_stops[static_cast<size_t>(b)].position;
            });
            const auto here = std::find(order.begin(), order.end(), m_chosen) - order.begin();
            const auto next = std::clamp<std::ptrdiff_t>(here + (sign > 0 ? 1 : -1), 0, static_cast<std::ptrdiff_t>(order.size()) - 1);
            if (!order.empty())
                choose(order[static_cast<size_t>(next)]);
            return;
        }
        changeChosen(
            [&](GradientStop& stop) { stop.position = std::clamp(std::round((stop.position + sign * step) * 1e4) / 1e4, 0.0, 1.0); });
        emit finished();
    };
    switch (event->key()) {
    case Qt::Key_Left:
        move(-1.0);
        return;
    case Qt::Key_Right:
        move(1.0);
        return;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        removeChosen();
        return;
    case Qt::Key_Insert:
        addStop(0.5);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void GradientBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = bar();
    painter.fillRect(area, QColor(150, 150, 150));
    for (int x = 0; x * 6 < area.width(); ++x)
        for (int y = 0; y * 6 < area.height(); ++y)
            if ((x + y) % 2)
                painter.fillRect(QRectF(area.left() + 6.0 * x, area.top() + 6.0 * y, 6.0, 6.0).intersected(area), QColor(105, 105, 105));
    const GradientTable table(m_stops, ColorMixing::Oklab);
    const double ratio = devicePixelRatioF();
    const int columns = std::max(1, static_cast<int>(area.width() * ratio));
    for (int i = 0; i < columns; ++i) {
        const GradientTable::Entry entry = table.at((static_cast<float>(i) + 0.5f) / static_cast<float>(columns));
        QColor color = screenColor({static_cast<double>(entry.r), static_cast<double>(entry.g), static_cast<double>(entry.b)});
        color.setAlphaF(std::clamp(entry.a, 0.0f, 1.0f));
        painter.fillRect(QRectF(area.left() + i / ratio, area.top(), 1.0 / ratio + 0.01, area.height()), color);
    }
    painter.setPen(QPen(palette().color(QPalette::Shadow), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    for (size_t pass = 0; pass < 2; ++pass)
        for (size_t i = 0; i < m_stops.size(); ++i) {
            const bool isChosen = static_cast<int>(i) == m_chosen && m_beforePull.empty();
            if (isChosen != (pass == 1))
                continue;
            const double x = placeOf(m_stops[i].position), top = area.bottom() - 2.0;
            QPainterPath handle;
            handle.moveTo(x, top);
            handle.lineTo(x + handleHalf, top + 7.0);
            handle.lineTo(x + handleHalf, top + 17.0);
            handle.lineTo(x - handleHalf, top + 17.0);
            handle.lineTo(x - handleHalf, top + 7.0);
            handle.closeSubpath();
            painter.setBrush(screenColor(m_stops[i].color));
            const bool focused = isChosen && hasFocus();
            painter.setPen(QPen(isChosen ? (focused ? palette().color(QPalette::Highlight) : QColor(240, 240, 240)) : QColor(120, 120, 120),
                                isChosen ? 2.0 : 1.2));
            painter.drawPath(handle);
        }
}

GradientEditor::GradientEditor(QWidget* parent)
    : QWidget(parent), m_bar(new GradientBar(this)), m_color(new ColorButton(this)), m_position(new QDoubleSpinBox(this)),
      m_opacity(new QDoubleSpinBox(this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addWidget(m_bar);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    column->addLayout(row);
    row->addWidget(m_color, 1);
    for (QDoubleSpinBox* box : {m_position, m_opacity}) {
        box->setRange(0.0, 100.0);
        box->setDecimals(1);
        box->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        box->setSuffix(QStringLiteral(" %"));
        box->setKeyboardTracking(false);
        box->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(box, 1);
    }
    m_color->setAccessibleName(tr("Stop color"));
    m_color->setToolTip(tr("Color of the chosen stop"));
    m_color->setMinimumWidth(40);
    m_position->setAccessibleName(tr("Stop position"));
    m_position->setToolTip(tr("Where the chosen stop stands"));
    m_opacity->setAccessibleName(tr("Stop opacity"));
    m_opacity->setToolTip(tr("Opacity of the chosen stop: below 100 % what lies under the layer shows"));

    connect(m_bar, &GradientBar::edited, this, &GradientEditor::edited);
    connect(m_bar, &GradientBar::finished, this, &GradientEditor::finished);
    connect(m_bar, &GradientBar::chosenChanged, this, &GradientEditor::showChosen);
    connect(m_color, &ColorButton::edited, this,
            [this](const glm::dvec3& color) { m_bar->changeChosen([&](GradientStop& stop) { stop.color = color; }); });
    connect(m_color, &ColorButton::finished, this, &GradientEditor::finished);
    const auto connectBox = [this](QDoubleSpinBox* box, double GradientStop::*member) {
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, member](double percent) {
            m_bar->changeChosen([&](GradientStop& stop) { stop.*member = std::clamp(percent / 100.0, 0.0, 1.0); });
            emit finished();
        });
    };
    connectBox(m_position, &GradientStop::position);
    connectBox(m_opacity, &GradientStop::opacity);
    setFocusProxy(m_bar);
    showChosen();
}

void GradientEditor::setStops(const std::vector<GradientStop>& stops)
{
    m_bar->setStops(stops);
    showChosen();
}

void GradientEditor::showChosen()
{
    const bool any = !m_bar->stops().empty();
    for (QWidget* widget : {static_cast<QWidget*>(m_color), static_cast<QWidget*>(m_position), static_cast<QWidget*>(m_opacity)})
        widget->setEnabled(any);
    if (!any)
        return;
    const GradientStop& stop = m_bar->stops()[static_cast<size_t>(m_bar->chosen())];
    const QSignalBlocker quietPosition(m_position), quietOpacity(m_opacity);
    m_color->setColor(stop.color);
    m_position->setValue(100.0 * stop.position);
    m_opacity->setValue(100.0 * stop.opacity);
}

} // namespace mirrorball::studio
