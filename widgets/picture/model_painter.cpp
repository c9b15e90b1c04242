#include "model_painter.h"

#include <QMouseEvent>
#include <QTabletEvent>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {
/// Two samples farther apart on the disc than this are on different parts of the model.
constexpr double leap = 0.3;
/// Pixels from the cursor at which the ring looks how the disc lies on the model.
constexpr double probe = 4.0;
constexpr double largestRing = 600.0; ///< pixels: on what is nearly flat a brush has no end
} // namespace

ModelPainter::ModelPainter(PreviewWidget& preview, Workspace& workspace)
    : QObject(&preview), m_preview(preview), m_workspace(workspace), m_ring(new BrushRing(preview))
{
    m_preview.installEventFilter(this);
    m_ringTimer.setSingleShot(true);
    m_ringTimer.setInterval(16);
    connect(&m_ringTimer, &QTimer::timeout, this, &ModelPainter::showRing);
    const auto soon = [this] { m_ringTimer.start(); };
    connect(&m_workspace.sphereMap, &SphereMapEditor::brushChanged, this, soon);
    connect(&m_workspace.sphereMap, &SphereMapEditor::toolChanged, this, soon);
}

std::optional<glm::dvec2> ModelPainter::placeAt(const QPointF& position)
{
    const SphereMapDocument* map = m_workspace.sphereMap.map();
    return map ? m_preview.discPlaceAt(position, map->index) : std::nullopt;
}

/// The circle on the disc, seen on the model as far as the model bends like its tangent there: two differences of places make the matrix
/// from pixels to the disc, and its inverse takes the circle to an ellipse.
QPolygonF ModelPainter::outlineAt(const QPointF& position)
{
    const std::optional<glm::dvec2> here = placeAt(position);
    if (!here)
        return {};
    const auto change = [&](const QPointF& step) -> std::optional<glm::dvec2> {
        if (const auto ahead = placeAt(position + step))
            return (*ahead - *here) / probe;
        if (const auto behind = placeAt(position - step))
            return (*here - *behind) / probe;
        return std::nullopt;
    };
    const std::optional<glm::dvec2> across = change({probe, 0.0}), down = change({0.0, probe});
    if (!across || !down)
        return {};
    const glm::dmat2 toDisc(*across, *down);
    const double determinant = glm::determinant(toDisc), radius = m_workspace.sphereMap.brush().radius;
    QPolygonF outline;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2.0 * pi * i / 48;
        glm::dvec2 step = radius * glm::dvec2(std::cos(angle), std::sin(angle));
        if (std::abs(determinant) > 1e-12)
            step = glm::inverse(toDisc) * step;
        else
            step *= largestRing / radius;
        step *= std::min(1.0, largestRing / std::max(glm::length(step), 1e-9));
        outline << position + QPointF(step.x, step.y);
    }
    return outline;
}

void ModelPainter::showRing()
{
    const SphereMapEditor& editor = m_workspace.sphereMap;
    if (!isOn() || !m_cursor || editor.tool() == PaintTool::PickColor || m_workspace.document.isDragging()) { // the model turns
        m_ring->show({});
        return;
    }
    const Brush& brush = editor.brush();
    const QPointF hanging(m_string.brush().x, m_string.brush().y);
    m_ring->show(outlineAt(m_brushBefore  ? m_pressed
                           : m_isPainting ? hanging
                                          : *m_cursor),
                 m_brushBefore ? tr("radius %1, hardness %2").arg(brush.radius, 0, 'f', 3).arg(brush.hardness, 0, 'f', 2) : QString(),
                 m_isPainting ? QLineF(hanging, *m_cursor) : QLineF());
}

bool ModelPainter::press(const QPointF& position, Qt::KeyboardModifiers modifiers, const PenTouch& touch)
{
    SphereMapEditor& editor = m_workspace.sphereMap;
    if (modifiers.testFlag(Qt::AltModifier))
        return false;
    if (editor.tool() == PaintTool::PickColor) {
        m_isPicking = true;
        pick(position);
        return true;
    }
    if (!editor.canPaint()) {
        m_workspace.notices.set({.subject = QStringLiteral("painting"), .text = editor.paintingProblem()});
        return true;
    }
    m_workspace.notices.clear(QStringLiteral("painting"));
    m_isPainting = true;
    m_hasBegun = false;
    m_end = touch.end;
    m_string = PulledString(editor.stabilizer(), {position.x(), position.y()});
    move(position, touch);
    return true;
}

void ModelPainter::pick(const QPointF& position)
{
    if (const auto q = placeAt(position))
        m_workspace.sphereMap.pickColor(*q);
}

void ModelPainter::move(const QPointF& position, const PenTouch& touch)
{
    if (m_isPicking) {
        pick(position);
        return;
    }
    SphereMapEditor& editor = m_workspace.sphereMap;
    const glm::dvec2& brush = m_string.pull({position.x(), position.y()});
    const auto q = placeAt({brush.x, brush.y});
    if (!q) {
        editor.liftStroke();
    } else if (!m_hasBegun) {
        m_hasBegun = true;
        editor.beginStroke({*q, touch.pressure, touch.tilt}, m_end, leap);
    } else {
        editor.moveStroke({*q, touch.pressure, touch.tilt});
    }
}

void ModelPainter::release()
{
    if (m_isPainting)
        m_workspace.sphereMap.endStroke();
    m_isPainting = m_isPicking = false;
}

bool ModelPainter::handleMouse(QEvent* event)
{
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (m_penIsDown)
        return true;
    m_cursor = mouse->position();
    if (!m_ringTimer.isActive())
        m_ringTimer.start();
    const bool isBusy = m_isPainting || m_isPicking || m_brushBefore;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        if (isBusy)
            return true;
        if (mouse->button() == Qt::RightButton && !mouse->modifiers().testFlag(Qt::ShiftModifier)) { // with Shift it turns the environment
            m_brushBefore = m_workspace.sphereMap.brush();
            m_pressed = mouse->position();
            return true;
        }
        return mouse->button() == Qt::LeftButton && press(mouse->position(), mouse->modifiers(), {});
    case QEvent::MouseMove:
        if (m_brushBefore)
            m_workspace.sphereMap.setBrush(draggedBrush(*m_brushBefore, mouse->position() - m_pressed));
        else if (isBusy)
            move(mouse->position(), {});
        return isBusy;
    default:
        if (m_brushBefore)
            m_brushBefore.reset();
        else if (isBusy)
            release();
        return isBusy;
    }
}

bool ModelPainter::handlePen(QEvent* event)
{
    auto* pen = static_cast<QTabletEvent*>(event);
    m_cursor = pen->position();
    if (!m_ringTimer.isActive())
        m_ringTimer.start();
    bool isTaken = m_penIsDown;
    switch (event->type()) {
    case QEvent::TabletPress:
        isTaken = m_penIsDown = press(pen->position(), pen->modifiers(), penTouch(*pen));
        break;
    case QEvent::TabletMove:
        if (m_penIsDown)
            move(pen->position(), penTouch(*pen));
        break;
    default:
        if (m_penIsDown)
            release();
        m_penIsDown = false;
        break;
    }
    pen->setAccepted(isTaken); // then no mouse event follows
    return isTaken;
}

bool ModelPainter::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        m_ring->setGeometry(m_preview.rect());
    if (event->type() == QEvent::Leave) {
        m_cursor.reset();
        m_ringTimer.start();
    }
    if (!isOn() && !m_isPainting && !m_isPicking && !m_brushBefore)
        return QObject::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        return handleMouse(event) || QObject::eventFilter(watched, event);
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        return handlePen(event);
    case QEvent::KeyPress: {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (m_isPainting && key == Qt::Key_Escape) {
            m_workspace.sphereMap.cancelStroke();
            m_isPainting = false;
            return true;
        }
        if (key == Qt::Key_BracketLeft || key == Qt::Key_BracketRight) {
            m_workspace.sphereMap.stepBrush(key == Qt::Key_BracketLeft ? -1 : 1);
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
    default:
        return QObject::eventFilter(watched, event);
    }
}

} // namespace mirrorball::studio
