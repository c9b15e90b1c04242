#include "map_view.h"

#include "widgets/controls/images.h"

#include "core/image/map_picture.h"
#include "core/sphere/map_sheet.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double largestZoom = 64.0; ///< pixels a texel
constexpr double margin = 8.0;

const std::array<std::pair<const char*, glm::dvec3>, 6> axes{
    {{"+X", {1, 0, 0}}, {"-X", {-1, 0, 0}}, {"+Y", {0, 1, 0}}, {"-Y", {0, -1, 0}}, {"+Z", {0, 0, 1}}, {"-Z", {0, 0, -1}}}};

} // namespace

/// What the worker made, with what it was made of.
struct MapView::Rendered {
    std::shared_ptr<const EnvironmentMap> map{};
    std::shared_ptr<const MipPyramid> pyramid{};
    MapWindow window{};
    std::shared_ptr<const Image> linear{};
    MapColoring coloring{};
    MapOverlays overlays{};
    QImage picture{}, overlay{};
};

MapView::MapView(DirectionCursor& cursor, QWidget* parent) : QWidget(parent), m_cursor(cursor), m_runner(this)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Map"));
    setToolTip(tr("Wheel or + and -: zoom. Drag or arrow keys: move. Double click or 0: fit. 1: a texel on a pixel. "
                  "Shift and arrow keys: point at a texel."));
    connect(&m_cursor, &DirectionCursor::moved, this, qOverload<>(&QWidget::update));
    connect(&m_runner, &JobRunner::failed, this, [this](const QString& message) {
        m_message = message;
        update();
    });
}

void MapView::showMap(std::shared_ptr<const EnvironmentMap> map, const MapLayout& layout)
{
    const MapLayout before = m_window.layout;
    const bool hadMap = m_map != nullptr;
    m_map = std::move(map);
    m_message.clear();
    m_window.layout = layout;
    if (!hadMap || before.kind != layout.kind || m_isFitted) {
        m_isFitted = true;
        fitNow();
    } else if (before.size != layout.size) { // another level of the same map: the same part of it
        const double factor = static_cast<double>(layout.size) / before.size;
        m_window.origin *= factor;
        m_window.scale = std::min(m_window.scale / factor, largestZoom * ratio());
    }
    request();
}

void MapView::showMessage(const QString& message)
{
    m_map.reset();
    m_message = message;
    m_picture = m_overlay = {};
    m_rendered.reset();
    setAccessibleDescription(message);
    update();
}

void MapView::setColoring(const MapColoring& coloring)
{
    if (coloring == m_coloring)
        return;
    m_coloring = coloring;
    request();
}

void MapView::setOverlays(const MapOverlays& overlays)
{
    if (overlays == m_overlays)
        return;
    m_overlays = overlays;
    request();
}

void MapView::setCaption(const QString& caption)
{
    if (caption.isEmpty() != m_caption.isEmpty() && m_isFitted) {
        m_caption = caption; // it has a line of its own above the map
        fit();
    }
    m_caption = caption;
    update();
}

std::optional<glm::dvec3> MapView::directionAt(const QPointF& position) const
{
    if (!m_map)
        return std::nullopt;
    const QPointF pixel = position * ratio();
    const auto p = imageFromSheet(m_window.layout, sheetPosition(m_window, {pixel.x(), pixel.y()}));
    if (!p || density(m_window.layout, *p) <= 0.0)
        return std::nullopt;
    return direction(m_window.layout, *p);
}

QPointF MapView::positionOf(const glm::dvec3& direction) const
{
    const glm::dvec2 pixel = picturePosition(m_window, sheetFromImage(m_window.layout, coordinate(m_window.layout, direction)));
    return QPointF(pixel.x, pixel.y) / ratio();
}

glm::vec3 MapView::valueAt(const glm::dvec3& d) const
{
    if (!m_map)
        return glm::vec3(0.0f);
    if (m_map->layout != m_window.layout)
        return m_map->radiance(d);
    const glm::dvec2 p = coordinate(m_map->layout, d);
    const float* t = m_map->image.texel(std::clamp(static_cast<int>(p.x), 0, m_map->image.width - 1),
                                        std::clamp(static_cast<int>(p.y), 0, m_map->image.height - 1));
    return {t[0], t[1], t[2]};
}

void MapView::fit()
{
    m_isFitted = true;
    fitNow();
    request();
}

void MapView::fitNow()
{
    if (m_window.layout.size < 1)
        return;
    const SheetSize sheet = sheetSize(m_window.layout);
    const glm::dvec2 view(width() * ratio(), height() * ratio());
    const glm::dvec2 above(0.0, m_caption.isEmpty() ? 0.0 : ratio() * (fontMetrics().height() + 4.0));
    const glm::dvec2 room = glm::max(view - above - 2.0 * margin * ratio(), glm::dvec2(1.0));
    m_window.scale = std::min({room.x / sheet.width, room.y / sheet.height, largestZoom * ratio()});
    m_window.origin = 0.5 * (glm::dvec2(sheet.width, sheet.height) - (view + above) / m_window.scale);
    emit zoomChanged();
}

void MapView::actualSize() { zoomBy(1.0 / m_window.scale); }

void MapView::zoomBy(double factor) { zoomAt(QRectF(rect()).center(), factor); }

void MapView::zoomAt(const QPointF& position, double factor)
{
    if (!m_map)
        return;
    const SheetSize sheet = sheetSize(m_window.layout);
    const double least = 0.25 * std::min(width() * ratio() / sheet.width, height() * ratio() / sheet.height);
    const double scale = std::clamp(m_window.scale * factor, std::min(least, 1.0), largestZoom * ratio());
    const glm::dvec2 pixel(position.x() * ratio(), position.y() * ratio());
    const glm::dvec2 kept = sheetPosition(m_window, pixel);
    m_window.scale = scale;
    m_window.origin = kept - pixel / scale;
    m_isFitted = false;
    emit zoomChanged();
    request();
}

void MapView::pan(const QPointF& pixels)
{
    const SheetSize sheet = sheetSize(m_window.layout);
    m_window.origin -= glm::dvec2(pixels.x(), pixels.y()) * ratio() / m_window.scale;
    // A corner of the map stays in sight.
    const glm::dvec2 view = glm::dvec2(width(), height()) * ratio() / m_window.scale;
    m_window.origin = glm::clamp(m_window.origin, -0.8 * view, glm::dvec2(sheet.width, sheet.height) - 0.2 * view);
    m_isFitted = false;
    request();
}

void MapView::moveCursor(int right, int down)
{
    if (!m_map)
        return;
    const glm::dvec3 from = m_cursor.direction().value_or(directionAt(QRectF(rect()).center()).value_or(glm::dvec3(0.0, 0.0, 1.0)));
    const MapLayout& layout = m_window.layout;
    const glm::dvec2 p = coordinate(layout, from);
    const Texel here{std::clamp(static_cast<int>(p.x), 0, layout.width() - 1), std::clamp(static_cast<int>(p.y), 0, layout.height() - 1)};
    const Texel there = acrossSeam(layout, here, here.x + right, here.y + down);
    m_cursor.set(texelDirection(layout, there.x, there.y));
}

void MapView::request()
{
    update();
    if (!m_map || width() < 1 || height() < 1)
        return;
    m_isStale = true;
    if (!isVisible()) // a dock that is not seen makes nothing; paintEvent() comes back here
        return;
    m_isStale = false;
    m_window.width = std::max(1, static_cast<int>(std::lround(width() * ratio())));
    m_window.height = std::max(1, static_cast<int>(std::lround(height() * ratio())));
    m_runner.start(
        [last = m_rendered, map = m_map, window = m_window, coloring = m_coloring, overlays = m_overlays](const JobControl& job) {
            Rendered next{.map = map, .window = window, .coloring = coloring, .overlays = overlays};
            const bool isSameMap = last && last->map == map, isSameWindow = isSameMap && last->window == window;
            const bool needsLevels = !(map->layout == window.layout && window.scale >= 1.0);
            if (isSameMap && (last->pyramid->levels.size() > 1 || !needsLevels))
                next.pyramid = last->pyramid;
            else
                next.pyramid = std::make_shared<const MipPyramid>(needsLevels ? buildMipPyramid(*map, job) : MipPyramid{{*map}});
            next.linear = isSameWindow ? last->linear : std::make_shared<const Image>(mapWindow(*next.pyramid, window, job));
            next.picture = isSameWindow && last->coloring == coloring ? last->picture : toQImage(windowColors(*next.linear, coloring, job));
            const bool drawsOverlay = overlays.grid || overlays.seams || overlays.tint != MapTint::None;
            if (last && last->window == window && last->overlays == overlays)
                next.overlay = last->overlay;
            else if (drawsOverlay)
                next.overlay = toQImage(mapOverlay(window, overlays, job));
            return std::make_shared<const Rendered>(std::move(next));
        },
        [this](std::shared_ptr<const Rendered> rendered) {
            if (!m_map)
                return;
            m_rendered = std::move(rendered);
            m_picture = m_rendered->picture;
            m_overlay = m_rendered->overlay;
            m_pictureWindow = m_rendered->window;
            update();
        },
        Running::Finish);
}

void MapView::paintEvent(QPaintEvent*)
{
    if (m_isStale && m_map)
        request();
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0x1c, 0x1c, 0x1c));
    if (!m_map) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_message);
    } else if (!m_picture.isNull()) {
        // Where the picture at hand lies in the window of now.
        const bool isSameLayout = m_pictureWindow.layout == m_window.layout;
        const double scale = isSameLayout ? m_window.scale / m_pictureWindow.scale : 1.0;
        const glm::dvec2 corner = isSameLayout ? picturePosition(m_window, m_pictureWindow.origin) : glm::dvec2(0.0);
        const QRectF target(corner.x / ratio(), corner.y / ratio(), m_picture.width() * scale / ratio(),
                            m_picture.height() * scale / ratio());
        painter.setRenderHint(QPainter::SmoothPixmapTransform, scale != 1.0);
        painter.drawImage(target, m_picture);
        if (!m_overlay.isNull())
            painter.drawImage(target, m_overlay);
        paintMarks(painter);
    }
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void MapView::paintMarks(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const auto label = [&](const QPointF& at, const QString& text) {
        const QRectF box = QFontMetricsF(font()).boundingRect(text).adjusted(-4, -1, 4, 1);
        const QRectF place = box.translated(at - box.center());
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 150));
        painter.drawRoundedRect(place, 3, 3);
        painter.setPen(QColor(0xff, 0xd9, 0x73));
        painter.drawText(place, Qt::AlignCenter, text);
    };
    if (m_overlays.grid)
        for (const auto& [name, axis] : axes) {
            const QPointF at = positionOf(axis);
            if (rect().contains(at.toPoint()))
                label({std::clamp(at.x(), 16.0, width() - 16.0), std::clamp(at.y(), 10.0, height() - 10.0)}, QString::fromLatin1(name));
        }
    if (m_cursor.direction())
        paintMarker(painter, positionOf(*m_cursor.direction()));
    if (!m_caption.isEmpty()) {
        const QRectF box = QFontMetricsF(font()).boundingRect(m_caption).adjusted(-6, -2, 6, 2);
        const QRectF place = box.translated(QPointF(6, 6) - box.topLeft());
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 150));
        painter.drawRoundedRect(place, 3, 3);
        painter.setPen(QColor(0xe6, 0xe6, 0xe6));
        painter.drawText(place, Qt::AlignCenter, m_caption);
    }
}

/// A ring that is seen on any ground.
void MapView::paintMarker(QPainter& painter, const QPointF& at) const
{
    painter.setBrush(Qt::NoBrush);
    for (const auto& [width, color] : {std::pair{3.5, QColor(0, 0, 0, 200)}, {1.5, QColor(Qt::white)}}) {
        painter.setPen(QPen(color, width));
        painter.drawEllipse(at, 6.0, 6.0);
    }
}

void MapView::resizeEvent(QResizeEvent*)
{
    if (m_isFitted)
        fitNow();
    request();
}

void MapView::wheelEvent(QWheelEvent* event)
{
    zoomAt(event->position(), std::exp2(event->angleDelta().y() / 360.0));
    event->accept();
}

void MapView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return;
    m_isPanning = true;
    m_last = event->position();
}

void MapView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_isPanning) {
        setCursor(Qt::ClosedHandCursor);
        pan(event->position() - m_last);
        m_last = event->position();
        return;
    }
    const auto direction = directionAt(event->position());
    direction ? setCursor(Qt::CrossCursor) : unsetCursor();
    m_cursor.set(direction);
}

void MapView::mouseReleaseEvent(QMouseEvent* event)
{
    m_isPanning = false;
    directionAt(event->position()) ? setCursor(Qt::CrossCursor) : unsetCursor();
}

void MapView::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void MapView::keyPressEvent(QKeyEvent* event)
{
    const bool points = event->modifiers().testFlag(Qt::ShiftModifier);
    const auto arrow = [&](int right, int down) { points ? moveCursor(right, down) : pan(QPointF(-40.0 * right, -40.0 * down)); };
    switch (event->key()) {
    case Qt::Key_Left:
        return arrow(-1, 0);
    case Qt::Key_Right:
        return arrow(1, 0);
    case Qt::Key_Up:
        return arrow(0, -1);
    case Qt::Key_Down:
        return arrow(0, 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomBy(1.25);
    case Qt::Key_Minus:
        return zoomBy(0.8);
    case Qt::Key_0:
        return fit();
    case Qt::Key_1:
        return actualSize();
    default:
        QWidget::keyPressEvent(event);
    }
}

void MapView::leaveEvent(QEvent*) { m_cursor.set(std::nullopt); }

void MapView::focusInEvent(QFocusEvent*) { update(); }

void MapView::focusOutEvent(QFocusEvent*) { update(); }

} // namespace mirrorball::studio
