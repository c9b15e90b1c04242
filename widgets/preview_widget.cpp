#include "preview_widget.h"

#include "core/error.h"
#include "core/preview/scene_settings.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

QSurfaceFormat previewFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(0); // the renderer has targets of its own
    format.setStencilBufferSize(0);
    return format;
}

PreviewWidget::PreviewWidget(Workspace& workspace, QWidget* parent) : QOpenGLWidget(parent), m_workspace(workspace)
{
    setFormat(previewFormat());
    setFocusPolicy(Qt::StrongFocus);
    setObjectName(QStringLiteral("preview"));
    setAccessibleName(tr("Preview"));
    m_rest.setSingleShot(true);
    m_rest.setInterval(400);
    connect(&m_rest, &QTimer::timeout, &m_workspace.document, &Document::finishEdit);
    connect(&m_workspace.live, &LiveScene::updated, this, qOverload<>(&QWidget::update));
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (parts & (Part::View | Part::Probe))
            update();
    });
}

PreviewWidget::~PreviewWidget()
{
    releaseGL();
}

void PreviewWidget::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &PreviewWidget::releaseGL);
    try {
        m_renderer = std::make_unique<preview::Renderer>();
        m_problem.clear();
    } catch (const Error& error) {
        m_problem = QString::fromUtf8(error.what());
        m_workspace.notices.set({.subject = QStringLiteral("preview"), .text = m_problem});
    }
}

void PreviewWidget::releaseGL()
{
    if (!m_renderer)
        return;
    makeCurrent();
    m_renderer.reset();
    doneCurrent();
}

// The maps are of the scene that was made; what needs no map is of this moment.
preview::RenderSettings PreviewWidget::settings(const MadeScene& made) const
{
    const Scene& now = m_workspace.document.scene();
    Scene shown = made.scene;
    shown.view.camera = now.view.camera;
    shown.view.exposure = now.view.exposure;
    shown.view.toneCurve = now.view.toneCurve;
    if (shown.map.space == MapSpace::World)
        shown.probe.yawDeg = now.probe.yawDeg;
    shown.view.width = std::max(1, static_cast<int>(std::lround(width() * devicePixelRatioF())));
    shown.view.height = std::max(1, static_cast<int>(std::lround(height() * devicePixelRatioF())));
    return preview::renderSettings(shown, made.plan);
}

void PreviewWidget::paintGL()
{
    const std::shared_ptr<const MadeScene> made = m_workspace.live.made();
    if (!m_renderer || !made)
        return;
    try {
        m_renderer->drawDisplay(settings(*made), preview::renderMaps(made->maps), {.framebuffer = defaultFramebufferObject()});
        m_workspace.notices.clear(QStringLiteral("preview"));
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("preview"), .text = QString::fromUtf8(error.what())});
        return;
    }
    emit painted(made);
}

void PreviewWidget::frame()
{
    m_workspace.document.edit(tr("Frame the object"), {}, [](Scene& scene) {
        const CameraSettings initial;
        scene.view.camera.distance = initial.distance;
        scene.view.camera.target = initial.target;
    });
}

void PreviewWidget::resetView()
{
    m_workspace.document.edit(tr("Reset the view"), {}, [](Scene& scene) {
        const Projection projection = scene.view.camera.projection;
        scene.view.camera = {};
        scene.view.camera.projection = projection;
    });
}

void PreviewWidget::changeExposure(double ev)
{
    m_workspace.document.edit(tr("Change exposure"), QStringLiteral("view.exposure"),
                              [&](Scene& scene) { scene.view.exposure = std::clamp(scene.view.exposure + ev, -64.0, 64.0); });
    m_rest.start();
}

void PreviewWidget::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
    if (event->button() == Qt::LeftButton)
        m_drag = Drag::Orbit;
    else if (event->button() == Qt::MiddleButton)
        m_drag = Drag::Pan;
    else if (event->button() == Qt::RightButton && event->modifiers().testFlag(Qt::ShiftModifier))
        m_drag = Drag::TurnEnvironment;
}

void PreviewWidget::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - m_last;
    m_last = event->position();
    Document& document = m_workspace.document;
    switch (m_drag) {
    case Drag::None:
        return;
    case Drag::Orbit:
        document.edit(tr("Orbit"), QStringLiteral("view.camera.orbit"), [&](Scene& scene) {
            CameraSettings& camera = scene.view.camera;
            camera.yawDeg = std::remainder(camera.yawDeg - 0.4 * moved.x(), 360.0);
            camera.pitchDeg = std::clamp(camera.pitchDeg + 0.4 * moved.y(), -90.0, 90.0);
        });
        return;
    case Drag::Pan: {
        const auto made = m_workspace.live.made();
        if (!made)
            return;
        const preview::Camera camera = settings(*made).camera;
        const double perPixel = 2.0 * camera.distance * static_cast<double>(camera.halfExtent(1.0f).y) / std::max(1, height());
        const glm::dmat3 axes(camera.cameraToWorld());
        document.edit(tr("Pan"), QStringLiteral("view.camera.pan"), [&](Scene& scene) {
            scene.view.camera.target =
                glm::clamp(scene.view.camera.target + perPixel * (-moved.x() * axes[0] + moved.y() * axes[1]), -1000.0, 1000.0);
        });
        return;
    }
    case Drag::TurnEnvironment:
        document.edit(tr("Turn the environment"), QStringLiteral("probe.yaw"), [&](Scene& scene) {
            scene.probe.yawDeg = std::remainder(scene.probe.yawDeg + 0.4 * moved.x(), 360.0);
        });
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

void PreviewWidget::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    m_workspace.document.edit(tr("Zoom"), QStringLiteral("view.camera.zoom"), [&](Scene& scene) {
        double& distance = scene.view.camera.distance;
        distance = std::clamp(distance * std::pow(0.9, notches), 0.05, 100.0);
    });
    m_rest.start();
    event->accept();
}

} // namespace mirrorball::studio
