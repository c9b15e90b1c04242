#include "preview_widget.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

// The mouse in the picture: what a drag moves.
namespace mirrorball::studio {

namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double pixelsPerE = 200.0; ///< of a drag that zooms by a factor of e
constexpr int wipeGrip = 6;          ///< pixels to either side of the line

} // namespace

bool PreviewWidget::isOnWipe(const QPointF& position) const
{
    return comparison() == Comparison::Wipe && std::abs(position.x() - m_wipe * width()) <= wipeGrip;
}

void PreviewWidget::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
    m_drag = event->button() == Qt::LeftButton && isOnWipe(m_last) ? Drag::Wipe : dragOf(*event);
}

// A gesture of more modifiers before one of less: one without any takes the button with all that is left.
PreviewWidget::Drag PreviewWidget::dragOf(const QMouseEvent& event) const
{
    if (isTurn(event))
        return Drag::TurnEnvironment;
    for (const auto& [gesture, drag] :
         {std::pair{m_mouse.zoom, Drag::Zoom}, std::pair{m_mouse.pan, Drag::Pan}, std::pair{m_mouse.orbit, Drag::Orbit}})
        if (gesture.button == event.button() && (event.modifiers() & gesture.modifiers) == gesture.modifiers)
            return drag;
    return Drag::None;
}

bool PreviewWidget::isTurn(const QMouseEvent& event) const
{
    switch (m_turnGesture) {
    case TurnGesture::ShiftRight:
        return event.button() == Qt::RightButton && event.modifiers().testFlag(Qt::ShiftModifier);
    case TurnGesture::ControlLeft:
        return event.button() == Qt::LeftButton && event.modifiers().testFlag(Qt::ControlModifier);
    case TurnGesture::ControlMiddle:
        return event.button() == Qt::MiddleButton && event.modifiers().testFlag(Qt::ControlModifier);
    }
    return false;
}

void PreviewWidget::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - m_last;
    m_last = event->position();
    if (m_drag != Drag::None) {
        drag(moved);
        return;
    }
    const bool paints = m_workspace.sphereMap.paintsOnModel() && m_workspace.sphereMap.map();
    setCursor(isOnWipe(m_last) ? Qt::SplitHCursor : paints ? Qt::CrossCursor : Qt::ArrowCursor);
    if (!m_pointing.isActive())
        m_pointing.start();
}

void PreviewWidget::drag(const QPointF& moved)
{
    Document& document = m_workspace.document;
    switch (m_drag) {
    case Drag::None:
        return;
    case Drag::Orbit:
        document.edit(tr("Orbit"), QStringLiteral("view.camera.orbit"), [&](Scene& scene) {
            CameraSettings& camera = scene.view.camera;
            camera.yawDeg = std::remainder(camera.yawDeg - degreesPerPixel * moved.x(), 360.0);
            camera.pitchDeg = std::clamp(camera.pitchDeg + degreesPerPixel * moved.y(), -90.0, 90.0);
        });
        return;
    case Drag::Pan: {
        const auto made = m_workspace.live.made();
        if (!made)
            return;
        const preview::Camera camera = settings(*made).camera;
        const double perPixel = 2.0 * static_cast<double>(camera.distance * camera.halfExtent(1.0f).y) / std::max(1, height());
        const glm::dmat3 axes(camera.cameraToWorld());
        document.edit(tr("Pan"), QStringLiteral("view.camera.pan"), [&](Scene& scene) {
            glm::dvec3& target = scene.view.camera.target;
            target = glm::clamp(target + perPixel * (-moved.x() * axes[0] + moved.y() * axes[1]), -1000.0, 1000.0);
        });
        return;
    }
    case Drag::Zoom: // up and to the right: nearer
        zoom(std::exp((moved.y() - moved.x()) / pixelsPerE));
        return;
    case Drag::TurnEnvironment:
        document.edit(tr("Turn the environment"), QStringLiteral("probe.yaw"),
                      [&](Scene& scene) { scene.probe.yawDeg = std::remainder(scene.probe.yawDeg + degreesPerPixel * moved.x(), 360.0); });
        return;
    case Drag::Wipe:
        setWipe(m_last.x() / std::max(1, width()));
        return;
    }
}

void PreviewWidget::mouseReleaseEvent(QMouseEvent*)
{
    if (m_drag == Drag::None)
        return;
    m_drag = Drag::None;
    m_workspace.document.finishEdit();
}

void PreviewWidget::zoom(double factor)
{
    m_workspace.document.edit(tr("Zoom"), QStringLiteral("view.camera.zoom"), [factor](Scene& scene) {
        double& distance = scene.view.camera.distance;
        distance = std::clamp(distance * factor, 0.05, 100.0);
    });
}

void PreviewWidget::wheelEvent(QWheelEvent* event)
{
    zoom(std::pow(0.9, event->angleDelta().y() / 120.0));
    m_rest.start();
    event->accept();
}

} // namespace mirrorball::studio
