#include "model_painter.h"

#include "core/spheremap/paint_position.h"

#include <QMouseEvent>
#include <QTabletEvent>

namespace mirrorball::studio {

namespace {
/// Two samples farther apart on the disc than this are on different parts of the model.
constexpr double leap = 0.3;
} // namespace

ModelPainter::ModelPainter(PreviewWidget& preview, Workspace& workspace)
    : QObject(&preview), m_preview(preview), m_workspace(workspace)
{
    m_preview.installEventFilter(this);
}

std::optional<glm::dvec2> ModelPainter::placeAt(const QPointF& position)
{
    const SphereMapDocument* map = m_workspace.sphereMap.map();
    const std::optional<preview::SurfaceHit> hit = m_preview.pick(position);
    if (!map || !hit)
        return std::nullopt;
    return map->index == SphereMapIndex::Normal ? glm::dvec2(hit->eyeNormal) : sphere_map::discFromDirection(glm::dvec3(hit->eyeReflected));
}

bool ModelPainter::press(const QPointF& position, Qt::KeyboardModifiers modifiers, double pressure, PenEnd end)
{
    SphereMapEditor& editor = m_workspace.sphereMap;
    if (modifiers.testFlag(Qt::AltModifier))
        return false;
    if (editor.tool() == PaintTool::PickColor) {
        m_isPicking = true;
        if (const auto q = placeAt(position))
            editor.pickColor(*q);
        return true;
    }
    if (!editor.canPaint()) {
        m_workspace.notices.set({.subject = QStringLiteral("painting"), .text = editor.paintingProblem()});
        return true;
    }
    m_workspace.notices.clear(QStringLiteral("painting"));
    m_isPainting = true;
    m_hasBegun = false;
    m_end = end;
    move(position, pressure);
    return true;
}

void ModelPainter::move(const QPointF& position, double pressure)
{
    SphereMapEditor& editor = m_workspace.sphereMap;
    const auto q = placeAt(position);
    if (m_isPicking) {
        if (q)
            editor.pickColor(*q);
        return;
    }
    if (!q) {
        editor.liftStroke();
    } else if (!m_hasBegun) {
        m_hasBegun = true;
        editor.beginStroke({*q, pressure}, m_end, leap);
    } else {
        editor.moveStroke({*q, pressure});
    }
}

void ModelPainter::release()
{
    if (m_isPainting)
        m_workspace.sphereMap.endStroke();
    m_isPainting = m_isPicking = false;
}

bool ModelPainter::eventFilter(QObject* watched, QEvent* event)
{
    const bool isBusy = m_isPainting || m_isPicking;
    if (!isBusy && !(m_workspace.sphereMap.paintsOnModel() && m_workspace.sphereMap.map()))
        return QObject::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        return m_penIsDown || (mouse->button() == Qt::LeftButton && press(mouse->position(), mouse->modifiers(), 1.0, PenEnd::Tip));
    }
    case QEvent::MouseMove:
        if (isBusy && !m_penIsDown)
            move(static_cast<QMouseEvent*>(event)->position(), 1.0);
        return isBusy;
    case QEvent::MouseButtonRelease:
        if (isBusy && !m_penIsDown)
            release();
        return isBusy;
    case QEvent::TabletPress: {
        auto* pen = static_cast<QTabletEvent*>(event);
        const bool isEraser = pen->pointerType() == QPointingDevice::PointerType::Eraser;
        m_penIsDown = press(pen->position(), pen->modifiers(), pen->pressure(), isEraser ? PenEnd::Eraser : PenEnd::Tip);
        pen->setAccepted(m_penIsDown);
        return m_penIsDown;
    }
    case QEvent::TabletMove: {
        auto* pen = static_cast<QTabletEvent*>(event);
        if (m_penIsDown)
            move(pen->position(), pen->pressure());
        pen->setAccepted(m_penIsDown);
        return m_penIsDown;
    }
    case QEvent::TabletRelease: {
        const bool wasDown = m_penIsDown;
        if (wasDown)
            release();
        m_penIsDown = false;
        event->setAccepted(wasDown);
        return wasDown;
    }
    case QEvent::KeyPress:
        if (m_isPainting && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            m_workspace.sphereMap.cancelStroke();
            m_isPainting = false;
            return true;
        }
        return QObject::eventFilter(watched, event);
    default:
        return QObject::eventFilter(watched, event);
    }
}

} // namespace mirrorball::studio
