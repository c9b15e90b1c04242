#include "sphere_map_canvas.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double margin = 10.0;

} // namespace

SphereMapCanvas::SphereMapCanvas(SphereMapEditor& editor, QWidget* parent)
    : QWidget(parent), m_editor(editor), m_handles(editor, {.placeOf = [this](const glm::dvec2& q) { return placeOf(q); },
                                                            .discAt = [this](const QPointF& place) { return discAt(place); }})
{
    setObjectName(QStringLiteral("sphereMapCanvas"));
    setAccessibleName(tr("Sphere map"));
    setMouseTracking(true);
    setTabletTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&m_editor, &SphereMapEditor::pictureChanged, this, &SphereMapCanvas::show);
    const auto redraw = [this] {
        updateCursor();
        update();
    };
    connect(&m_editor, &SphereMapEditor::mapChanged, this, redraw);
    connect(&m_editor, &SphereMapEditor::brushChanged, this, redraw);
    connect(&m_editor, &SphereMapEditor::toolChanged, this, redraw);
    connect(&m_editor, &SphereMapEditor::levelPictureChanged, this, qOverload<>(&QWidget::update));
    connect(&m_handles, &DiscHandles::changed, this, [this, redraw] {
        setAccessibleDescription(m_handles.chosen() < 0 ? QString() : m_handles.describe(m_handles.chosen()));
        redraw();
    });
    connect(&m_editor, &SphereMapEditor::chosenChanged, this, [this, redraw] {
        m_hint.clear();
        redraw();
    });
    updateCursor();
}

double SphereMapCanvas::scale() const { return std::max(20.0, 0.5 * std::min(width(), height()) - margin) * m_zoom; }

glm::dvec2 SphereMapCanvas::discAt(const QPointF& place) const
{
    return m_center + glm::dvec2(place.x() - 0.5 * width(), 0.5 * height() - place.y()) / scale();
}

QPointF SphereMapCanvas::placeOf(const glm::dvec2& q) const
{
    const glm::dvec2 d = (q - m_center) * scale();
    return {0.5 * width() + d.x, 0.5 * height() - d.y};
}

void SphereMapCanvas::fit()
{
    m_zoom = 1.0;
    m_center = glm::dvec2(0.0);
    update();
}

void SphereMapCanvas::show(const TexelRect& touched)
{
    const double n = m_editor.screen().size();
    const QPointF low = placeOf({touched.x0 / n * 2.0 - 1.0, 1.0 - touched.y0 / n * 2.0});
    const QPointF high = placeOf({touched.x1 / n * 2.0 - 1.0, 1.0 - touched.y1 / n * 2.0});
    update(QRectF(low, high).toAlignedRect().adjusted(-2, -2, 2, 2));
}

void SphereMapCanvas::press(const QPointF& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const PenTouch& touch)
{
    m_last = m_pressed = place;
    m_hint.clear();
    if (!m_editor.map() || m_drag != Drag::None)
        return;
    if (button == Qt::MiddleButton || (button == Qt::LeftButton && m_spaceIsDown)) {
        m_drag = Drag::Pan;
    } else if (button == Qt::RightButton) {
        m_drag = Drag::Brush;
        m_brushBefore = m_editor.brush();
    } else if (button == Qt::LeftButton && (m_editor.tool() == PaintTool::PickColor || modifiers.testFlag(Qt::AltModifier))) {
        m_drag = Drag::Pick;
        m_editor.pickColor(discAt(place));
    } else if (button == Qt::LeftButton && m_handles.isActive()) {
        if (m_handles.press(place))
            m_drag = Drag::Handle;
        else
            m_hint = m_handles.hint();
    } else if (button == Qt::LeftButton) {
        m_hint = m_editor.paintingProblem();
        if (m_hint.isEmpty()) {
            m_drag = Drag::Stroke;
            m_string = PulledString(m_editor.stabilizer(), {place.x(), place.y()});
            m_editor.beginStroke({discAt(place), touch.pressure, touch.tilt}, touch.end);
        }
    }
    updateCursor();
    update();
}

void SphereMapCanvas::move(const QPointF& place, const PenTouch& touch)
{
    switch (m_drag) {
    case Drag::None:
        m_handles.hover(place);
        break;
    case Drag::Handle:
        m_handles.move(place);
        break;
    case Drag::Stroke:
        m_string.pull({place.x(), place.y()});
        m_editor.moveStroke({discAt(brushPlace()), touch.pressure, touch.tilt});
        break;
    case Drag::Pick:
        m_editor.pickColor(discAt(place));
        break;
    case Drag::Pan:
        m_center -= glm::dvec2(place.x() - m_last.x(), m_last.y() - place.y()) / scale();
        m_center = glm::clamp(m_center, -1.5, 1.5);
        break;
    case Drag::Brush:
        m_editor.setBrush(draggedBrush(m_brushBefore, place - m_pressed));
        break;
    }
    m_last = place;
    m_cursor = place;
    update();
}

void SphereMapCanvas::release()
{
    if (m_drag == Drag::Stroke)
        m_editor.endStroke();
    if (m_drag == Drag::Handle)
        m_handles.release();
    m_drag = Drag::None;
    updateCursor();
    update();
}

void SphereMapCanvas::mousePressEvent(QMouseEvent* event)
{
    if (!m_penIsDown)
        press(event->position(), event->button(), event->modifiers(), {});
}

void SphereMapCanvas::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_penIsDown)
        move(event->position(), {});
}

void SphereMapCanvas::mouseReleaseEvent(QMouseEvent*)
{
    if (!m_penIsDown)
        release();
}

/// The second press of two that are near and quick: on an empty place of a list of lights it adds one.
void SphereMapCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
    mousePressEvent(event);
    const bool isPlain = event->button() == Qt::LeftButton && !event->modifiers().testFlag(Qt::AltModifier) && !m_spaceIsDown;
    if (isPlain && m_drag == Drag::None && m_handles.addAt(event->position())) {
        m_drag = Drag::Handle;
        m_hint.clear();
        updateCursor();
    }
}

void SphereMapCanvas::tabletEvent(QTabletEvent* event)
{
    switch (event->type()) {
    case QEvent::TabletPress:
        m_penIsDown = true;
        press(event->position(), event->button(), event->modifiers(), penTouch(*event));
        break;
    case QEvent::TabletMove:
        move(event->position(), penTouch(*event));
        break;
    case QEvent::TabletRelease:
        release();
        m_penIsDown = false;
        break;
    default:
        break;
    }
    event->accept(); // no mouse events besides
}

void SphereMapCanvas::wheelEvent(QWheelEvent* event)
{
    const glm::dvec2 before = discAt(event->position());
    m_zoom = std::clamp(m_zoom * std::pow(1.2, event->angleDelta().y() / 120.0), 0.5, 32.0);
    m_center = glm::clamp(m_center + before - discAt(event->position()), -1.5, 1.5);
    event->accept();
    update();
}

void SphereMapCanvas::keyPressEvent(QKeyEvent* event)
{
    if (m_drag == Drag::None && m_handles.isActive() && m_handles.pressKey(*event))
        return;
    switch (event->key()) {
    case Qt::Key_BracketLeft:
        m_editor.stepBrush(-1);
        return;
    case Qt::Key_BracketRight:
        m_editor.stepBrush(1);
        return;
    case Qt::Key_Space:
        if (!event->isAutoRepeat())
            m_spaceIsDown = true;
        updateCursor();
        return;
    case Qt::Key_Home:
        fit();
        return;
    case Qt::Key_Escape:
        if (m_drag == Drag::Stroke) {
            m_editor.cancelStroke();
            m_drag = Drag::None;
            return;
        }
        if (m_drag == Drag::Handle) {
            m_handles.cancel();
            m_drag = Drag::None;
            updateCursor();
            return;
        }
        if (m_editor.onlyLevel()) {
            m_editor.showOnly(std::nullopt);
            return;
        }
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void SphereMapCanvas::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        m_spaceIsDown = false;
    if (!event->isAutoRepeat())
        m_handles.releaseKey();
    updateCursor();
    QWidget::keyReleaseEvent(event);
}

void SphereMapCanvas::leaveEvent(QEvent*)
{
    m_cursor.reset();
    m_handles.hover(std::nullopt);
    update();
}

void SphereMapCanvas::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void SphereMapCanvas::focusOutEvent(QFocusEvent* event)
{
    m_spaceIsDown = false;
    m_handles.releaseKey();
    QWidget::focusOutEvent(event);
    update();
}

/// Tooltips of handles.
bool SphereMapCanvas::event(QEvent* event)
{
    const bool usesEscape = m_editor.onlyLevel() || m_drag == Drag::Stroke || m_drag == Drag::Handle;
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && usesEscape)
        event->accept(); // before the shortcut that stops work
    if (event->type() == QEvent::ToolTip && m_handles.isActive()) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int handle = m_handles.at(help->pos());
        if (handle >= 0 && m_drag == Drag::None)
            QToolTip::showText(help->globalPos(), m_handles.describe(handle), this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

void SphereMapCanvas::updateCursor()
{
    if (m_drag == Drag::Pan || m_spaceIsDown)
        setCursor(Qt::ClosedHandCursor);
    else if (!m_editor.map())
        unsetCursor();
    else if (m_drag == Drag::Handle)
        setCursor(Qt::ClosedHandCursor);
    else if (m_handles.isActive())
        m_handles.isHovered() ? setCursor(Qt::OpenHandCursor) : setCursor(Qt::ArrowCursor);
    else if (m_editor.tool() != PaintTool::PickColor && !m_editor.canPaint())
        setCursor(Qt::ForbiddenCursor);
    else
        setCursor(Qt::CrossCursor);
}

} // namespace mirrorball::studio
