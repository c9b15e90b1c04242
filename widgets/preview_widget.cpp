#include "preview_widget.h"

#include "core/error.h"
#include "core/preview/scene_settings.h"

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr double degreesPerPixel = 0.4;
constexpr int wipeGrip = 6; ///< pixels to either side of the line
constexpr float differenceGain = 4.0f;

} // namespace

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
    setMouseTracking(true);
    setObjectName(QStringLiteral("preview"));
    setAccessibleName(tr("Preview"));
    setAccessibleDescription(tr("Drag to orbit, middle drag to pan, wheel to zoom, Shift and right drag to turn the environment"));
    m_rest.setSingleShot(true);
    m_rest.setInterval(400);
    m_pointing.setSingleShot(true);
    m_pointing.setInterval(40);
    connect(&m_rest, &QTimer::timeout, &m_workspace.document, &Document::finishEdit);
    connect(&m_pointing, &QTimer::timeout, this, &PreviewWidget::point);
    connect(&m_workspace.sphereMap, &SphereMapEditor::pictureChanged, this, [this](const TexelRect& touched) {
        // While nothing is drawn the scene's maps follow by themselves; what a stroke touched stays marked until they have.
        if (m_workspace.sphereMap.isPainting() || !m_strokeRect.empty()) {
            m_strokeRect = m_strokeRect.united(touched);
            m_freshRect = m_freshRect.united(touched);
            update();
        }
    });
    connect(&m_workspace.sphereMap, &SphereMapEditor::levelsChanged, this, [this](const std::vector<TexelRect>& touched) {
        for (std::vector<TexelRect>* rects : {&m_strokeLevels, &m_freshLevels}) {
            rects->resize(std::max(rects->size(), touched.size()));
            for (size_t i = 0; i < touched.size(); ++i)
                (*rects)[i] = (*rects)[i].united(touched[i]);
        }
    });
    connect(&m_workspace.live, &LiveScene::updated, this, [this] {
        if (!m_workspace.sphereMap.isPainting() && m_workspace.live.isUpToDate()) {
            m_strokeRect = m_freshRect = {};
            m_strokeLevels.clear();
            m_freshLevels.clear();
        }
    });
    connect(&m_workspace.live, &LiveScene::updated, this, qOverload<>(&QWidget::update));
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (parts & (Part::View | Part::Probe))
            update();
    });
    connect(&m_workspace.document, &Document::dragFinished, this, qOverload<>(&QWidget::update));
    connect(&m_workspace.cursor, &DirectionCursor::moved, this, [this] {
        if (!m_isPointing)
            update();
    });
}

namespace {

Image cutOut(const Image& picture, const TexelRect& rect)
{
    Image part(rect.width(), rect.height(), 4);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(picture.texel(rect.x0, rect.y0 + y), static_cast<size_t>(part.width) * 4, part.row(y));
    return part;
}

/// Every 2 x 2 texels become one.
Image averaged(const Image& finer)
{
    Image coarse(finer.width / 2, finer.height / 2, 4);
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
            for (int c = 0; c < 4; ++c)
                coarse.texel(x, y)[c] = 0.25f * (finer.texel(2 * x, 2 * y)[c] + finer.texel(2 * x + 1, 2 * y)[c] +
                                                 finer.texel(2 * x, 2 * y + 1)[c] + finer.texel(2 * x + 1, 2 * y + 1)[c]);
    return coarse;
}

} // namespace

PreviewWidget::~PreviewWidget()
{
    releaseGL();
}

void PreviewWidget::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &PreviewWidget::releaseGL);
    m_renderer = std::make_unique<preview::Renderer>();
}

void PreviewWidget::releaseGL()
{
    if (!m_renderer)
        return;
    makeCurrent();
    m_renderer.reset();
    m_shownSphereMap.reset();
    m_snapshotRenderer.reset();
    m_difference = {};
    doneCurrent();
}

QSize PreviewWidget::deviceSize() const
{
    const double ratio = devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(width() * ratio))), std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

// The maps are of the scene that was made; what needs no map is of this moment.
preview::RenderSettings PreviewWidget::settings(const PreparedScene& made) const
{
    const Scene& now = m_workspace.document.scene();
    Scene shown = made.scene;
    shown.view.camera = now.view.camera;
    shown.view.exposure = now.view.exposure;
    shown.view.toneCurve = now.view.toneCurve;
    if (shown.map.space == MapSpace::World)
        shown.probe.yawDeg = now.probe.yawDeg;
    const QSize size = deviceSize();
    shown.view.width = size.width();
    shown.view.height = size.height();
    preview::RenderSettings settings = preview::renderSettings(shown, made.plan, made.mesh, made.display);
    settings.pixelRatio = static_cast<float>(devicePixelRatioF());
    if (m_workspace.document.isDragging())
        settings.samples = 1; // smooth edges follow when the drag ends
    if (const auto& direction = m_workspace.cursor.direction(); direction && !m_isPointing)
        settings.marker = glm::vec3(*direction);
    return settings;
}

void PreviewWidget::draw(preview::Renderer& renderer, const PreparedScene& made, const preview::Destination& destination)
{
    renderer.drawDisplay(settings(made), preview::renderMaps(made.maps), destination);
}

// A stroke that is being drawn goes straight into the texture, only where it touched; when it is done, the scene's maps hold it.
void PreviewWidget::patchSphereMap(const PreparedScene& made)
{
    const SphereMapChain chain = made.maps.sphereMaps.empty() ? nullptr : made.maps.sphereMaps.front();
    const Image& picture = m_workspace.sphereMap.picture();
    if (!chain || m_strokeRect.empty() || chain->levels.front().width != picture.width) {
        m_shownSphereMap = chain;
        return;
    }
    if (chain != m_shownSphereMap) { // a new texture: it is made by drawing, and knows nothing of the stroke
        draw(*m_renderer, made, {.framebuffer = defaultFramebufferObject(), .clip = preview::PixelRectangle{0, 0, 1, 1}});
        m_shownSphereMap = chain;
        m_freshRect = m_strokeRect;
        m_freshLevels = m_strokeLevels;
    }
    if (m_freshRect.empty())
        return;
    m_renderer->patchSphereMap(cutOut(picture, m_freshRect), m_freshRect.x0, m_freshRect.y0, 0);
    patchLevels(*chain, m_freshRect);
    m_freshRect = {};
    m_freshLevels.clear();
}

void PreviewWidget::patchLevels(const SphereMapTexels& chain, const TexelRect& fresh)
{
    if (chain.hasAuthoredLevels) {
        const std::vector<Image>& levels = m_workspace.sphereMap.coarserLevels();
        for (size_t i = 0; i < std::min(m_freshLevels.size(), levels.size()); ++i)
            if (const TexelRect& rect = m_freshLevels[i];
                !rect.empty() && i + 1 < chain.levels.size() && levels[i].width == chain.levels[i + 1].width)
                m_renderer->patchSphereMap(cutOut(levels[i], rect), rect.x0, rect.y0, static_cast<int>(i) + 1);
        return;
    }
    const Image& picture = m_workspace.sphereMap.picture();
    TexelRect rect = fresh;
    Image part;
    for (int level = 1; level < static_cast<int>(chain.levels.size()); ++level) {
        const TexelRect even{rect.x0 & ~1, rect.y0 & ~1, (rect.x1 + 1) & ~1, (rect.y1 + 1) & ~1};
        const Image finer = level == 1 ? cutOut(picture, even.intersected({0, 0, picture.width, picture.height})) : std::move(part);
        if (level > 1 && even != rect)
            break; // the coarsest levels wait for the end of the stroke
        rect = {even.x0 / 2, even.y0 / 2, even.x1 / 2, even.y1 / 2};
        if (rect.x1 > chain.levels[static_cast<size_t>(level)].width || rect.y1 > chain.levels[static_cast<size_t>(level)].width)
            break;
        part = averaged(finer);
        m_renderer->patchSphereMap(part, rect.x0, rect.y0, level);
    }
}

void PreviewWidget::paintComparison(const PreparedScene& made)
{
    const QSize size = deviceSize();
    const unsigned screen = defaultFramebufferObject();
    if (!m_snapshotRenderer)
        m_snapshotRenderer = std::make_unique<preview::Renderer>();
    switch (m_comparison) {
    case Comparison::Off:
        break;
    case Comparison::Hold:
        draw(*m_snapshotRenderer, *m_snapshot, {.framebuffer = screen});
        break;
    case Comparison::Wipe: {
        const int line = static_cast<int>(std::lround(m_wipe * size.width()));
        draw(*m_snapshotRenderer, *m_snapshot, {.framebuffer = screen, .clip = preview::PixelRectangle{0, 0, line, size.height()}});
        draw(*m_renderer, made, {.framebuffer = screen, .clip = preview::PixelRectangle{line, 0, size.width() - line, size.height()}});
        break;
    }
    case Comparison::Difference:
        draw(*m_renderer, made, {.framebuffer = m_difference.target(0, size.width(), size.height())});
        draw(*m_snapshotRenderer, *m_snapshot, {.framebuffer = m_difference.target(1, size.width(), size.height())});
        m_difference.draw(screen, differenceGain);
        break;
    }
}

void PreviewWidget::paintGL()
{
    const std::shared_ptr<const PreparedScene> made = m_workspace.live.made();
    if (!m_renderer || !made)
        return;
    QElapsedTimer clock;
    clock.start();
    try {
        patchSphereMap(*made);
        if (m_comparison == Comparison::Off)
            draw(*m_renderer, *made, {.framebuffer = defaultFramebufferObject()});
        else
            paintComparison(*made);
        m_workspace.notices.clear(QStringLiteral("preview"));
    } catch (const Error& error) {
        m_workspace.notices.set({.subject = QStringLiteral("preview"), .text = QString::fromUtf8(error.what())});
        return;
    }
    if (m_comparison == Comparison::Wipe) {
        QPainter painter(this);
        const double x = m_wipe * width();
        painter.setPen(QPen(QColor(20, 20, 20, 160), 3.0));
        painter.drawLine(QPointF(x, 0), QPointF(x, height()));
        painter.setPen(QPen(QColor(235, 235, 235), 1.0));
        painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    }
    emit painted(made, static_cast<double>(clock.nsecsElapsed()) * 1e-9);
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

void PreviewWidget::takeSnapshot()
{
    m_snapshot = m_workspace.live.made();
    if (m_comparison != Comparison::Off)
        update();
    emit comparisonChanged();
}

void PreviewWidget::setComparison(Comparison comparison)
{
    m_comparison = m_snapshot ? comparison : Comparison::Off;
    update();
    emit comparisonChanged();
}

void PreviewWidget::setWipe(double fraction)
{
    m_wipe = std::clamp(fraction, 0.0, 1.0);
    update();
}

bool PreviewWidget::isOnWipe(const QPointF& position) const
{
    return m_comparison == Comparison::Wipe && std::abs(position.x() - m_wipe * width()) <= wipeGrip;
}

void PreviewWidget::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
    if (event->button() == Qt::LeftButton)
        m_drag = isOnWipe(m_last) ? Drag::Wipe : Drag::Orbit;
    else if (event->button() == Qt::MiddleButton)
        m_drag = Drag::Pan;
    else if (event->button() == Qt::RightButton && event->modifiers().testFlag(Qt::ShiftModifier))
        m_drag = Drag::TurnEnvironment;
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
    case Drag::TurnEnvironment:
        document.edit(tr("Turn the environment"), QStringLiteral("probe.yaw"), [&](Scene& scene) {
            scene.probe.yawDeg = std::remainder(scene.probe.yawDeg + degreesPerPixel * moved.x(), 360.0);
        });
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

void PreviewWidget::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_B || event->modifiers() != Qt::NoModifier || !m_snapshot) {
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    if (!event->isAutoRepeat() && !m_beforeHold) {
        m_beforeHold = m_comparison;
        setComparison(Comparison::Hold);
    }
}

void PreviewWidget::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_B || event->isAutoRepeat() || !m_beforeHold) {
        QOpenGLWidget::keyReleaseEvent(event);
        return;
    }
    setComparison(*m_beforeHold);
    m_beforeHold.reset();
}

void PreviewWidget::leaveEvent(QEvent*)
{
    m_pointing.stop();
    m_isPointing = false;
    m_workspace.cursor.set(std::nullopt);
}

std::optional<preview::SurfaceHit> PreviewWidget::pick(const QPointF& position)
{
    const auto made = m_workspace.live.made();
    if (!made || !m_renderer)
        return std::nullopt;
    const double ratio = devicePixelRatioF();
    std::optional<preview::SurfaceHit> hit;
    makeCurrent();
    try {
        hit = m_renderer->pick(settings(*made), static_cast<int>(position.x() * ratio), static_cast<int>(position.y() * ratio));
    } catch (const Error&) {
        // the next picture says what is wrong
    }
    doneCurrent();
    return hit;
}

// Where the reflection under the mouse comes from: the map shows it. The picture itself needs no mark there.
void PreviewWidget::point()
{
    if (m_drag != Drag::None || !underMouse() || m_workspace.sphereMap.isPainting())
        return;
    std::optional<glm::dvec3> direction;
    if (const auto hit = pick(m_last))
        direction = glm::dvec3(hit->lookup);
    m_isPointing = true;
    m_workspace.cursor.set(direction);
    m_isPointing = direction.has_value();
}

} // namespace mirrorball::studio
