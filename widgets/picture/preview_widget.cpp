#include "preview_widget.h"

#include "cut_out.h"
#include "picture_badges.h"
#include "preview_painting.h"
#include "widgets/spheremap/live_sphere_map.h"

#include "core/preview/scene_settings.h"
#include "core/scene/scene_dependencies.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirrorball::studio {

namespace {

constexpr int longestWaitForDisc = 12; ///< ms

/// What the places of lookups in a painted sphere map depend on.
preview::RenderSettings placesOnly(const preview::RenderSettings& settings)
{
    preview::RenderSettings only{
        .width = settings.width, .height = settings.height, .geometry = settings.geometry, .camera = settings.camera};
    only.windowDepths = settings.windowDepths;
    only.yaw = settings.yaw;
    only.material.paint.space = settings.material.paint.space;
    only.material.paint.lookup = settings.material.paint.lookup;
    return only;
}

} // namespace

PreviewWidget::PreviewWidget(Workspace& workspace, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_meter(workspace.snapshots, m_thread, this),
      m_labels(new ComparisonLabels(workspace.snapshots, *this)), m_inspector(new PictureInspector(m_thread, *this))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
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
            redraw();
        } else if (m_workspace.document.isDragging()) {
            redraw(); // it waited
        }
    });
    connect(&m_workspace.sphereMap, &SphereMapEditor::levelsChanged, this, [this](const std::vector<TexelRect>& touched) {
        for (std::vector<TexelRect>* rects : {&m_strokeLevels, &m_freshLevels}) {
            rects->resize(std::max(rects->size(), touched.size()));
            for (size_t i = 0; i < touched.size(); ++i)
                (*rects)[i] = (*rects)[i].united(touched[i]);
        }
        if (m_workspace.sphereMap.isPainting())
            redraw();
    });
    connect(&m_workspace.sphereMap, &SphereMapEditor::onlyLevelChanged, this, &PreviewWidget::redraw);
    connect(&m_workspace.live, &LiveScene::updated, this, [this] {
        if (!m_workspace.sphereMap.isPainting() && m_workspace.live.isUpToDate()) {
            m_strokeRect = m_freshRect = {};
            m_strokeLevels.clear();
            m_freshLevels.clear();
        }
    });
    connect(&m_workspace.live, &LiveScene::updated, this, [this] {
        // A dragged sphere map is shown on its disc first: that takes two milliseconds, unless a software renderer has all cores meanwhile.
        if (m_workspace.document.isDragging() && !m_workspace.sphereMap.isUpToDate())
            QTimer::singleShot(longestWaitForDisc, this, &PreviewWidget::redraw); // should it not come; a second order of the same is none
        else
            redraw();
    });
    connect(&m_workspace.document, &Document::changed, this, [this](Parts parts) {
        if (parts & (Part::View | Part::Probe))
            redraw();
    });
    connect(&m_workspace.document, &Document::dragFinished, this, &PreviewWidget::redraw);
    connect(&m_workspace.cursor, &DirectionCursor::moved, this, [this] {
        if (!m_isPointing)
            redraw();
    });
    connect(&m_workspace.snapshots, &Snapshots::comparisonChanged, this, [this] {
        redraw();
        emit comparisonChanged();
    });
    connect(&m_thread, &RenderThread::drawn, this, &PreviewWidget::show);
    connect(m_inspector, &PictureInspector::marksChanged, this, qOverload<>(&QWidget::update));
    new PictureBadges(m_workspace, *this);
}

QSize PreviewWidget::deviceSize() const
{
    const double ratio = devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(width() * ratio))), std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

/// Of one scene's picture in device pixels: side by side, two of them share the widget.
QSize PreviewWidget::sceneSize() const
{
    const QSize whole = deviceSize();
    return comparison() == Comparison::SideBySide ? QSize(std::max(1, whole.width() / 2), whole.height()) : whole;
}

/// The place in the picture of now, in device pixels; nothing where side by side the snapshot is shown.
std::optional<QPointF> PreviewWidget::nowPixel(const QPointF& position) const
{
    const QPointF pixel = position * devicePixelRatioF() - QPointF(deviceSize().width() - sceneSize().width(), 0.0);
    return pixel.x() < 0.0 ? std::nullopt : std::optional(pixel);
}

// The maps are of the scene that was made; what needs no map is of this moment.
preview::RenderSettings PreviewWidget::settings(const PreparedScene& made) const
{
    Scene shown = shownNow(made.scene, m_workspace.document.scene());
    const QSize size = sceneSize();
    shown.view.width = size.width();
    shown.view.height = size.height();
    preview::RenderSettings settings = preview::renderSettings(shown, made.plan, made.mesh, made.display);
    settings.pixelRatio = static_cast<float>(devicePixelRatioF());
    settings.material.paint.onlyLevel = m_workspace.sphereMap.onlyLevel();
    if (auto& only = settings.material.paint.onlyLevel; only && !made.maps.sphereMaps.empty() && made.plan.sphereMaps.front().document)
        only = std::max(0, *only - levelsLeftOut(*made.maps.sphereMaps.front(), made.plan.sphereMaps.front().size));
    if (m_workspace.document.isDragging() || m_workspace.sphereMap.isPainting()) {
        settings.samples = m_dragSamples;
        settings.smoothEdges = false; // they come with the picture at rest
        if (m_dragSamples == 1)
            settings.material.paint.anisotropy = 1; // on a software renderer a third of the time
    }
    if (const auto& direction = m_workspace.cursor.direction(); direction && !m_isPointing)
        settings.marker = glm::vec3(*direction);
    return settings;
}

// Whatever changes in one moment - a value, its maps, the end of a drag - is drawn once.
void PreviewWidget::redraw()
{
    if (m_isDue)
        return;
    m_isDue = true;
    QMetaObject::invokeMethod(this, &PreviewWidget::order, Qt::QueuedConnection);
}

void PreviewWidget::order()
{
    m_isDue = false;
    const std::shared_ptr<const PreparedScene> made = m_workspace.live.made();
    if (!made || !isVisible())
        return; // the first maps, or being shown, ask again
    PictureOrder order{.made = made, .settings = settings(*made), .size = deviceSize(), .comparison = comparison()};
    if (order.comparison != Comparison::Off) {
        order.snapshot = m_workspace.snapshots.compared()->made;
        order.snapshotSettings = settings(*order.snapshot);
        order.wipe = static_cast<int>(std::lround(m_wipe * order.settings.width));
    }
    order.number = m_ordered.number;
    if (m_workspace.document.isDragging() || m_workspace.sphereMap.isPainting()) {
        m_meter.wait();
        m_inspector->wait();
    } else {
        m_meter.measure(order);
        m_inspector->inspect(order);
    }
    if (!patchSphereMap(*made) && order == m_ordered)
        return; // it is being drawn, or shown
    ++order.number;
    m_isDrawing = true;
    m_ordered = order;
    m_thread.draw(std::move(order));
}

void PreviewWidget::show(const Picture& picture)
{
    if (picture.order.number == m_ordered.number)
        m_isDrawing = false;
    if (!picture.problem.isEmpty()) {
        m_workspace.notices.set({.subject = QStringLiteral("preview"), .text = picture.problem});
        return;
    }
    m_workspace.notices.clear(QStringLiteral("preview"));
    m_picture = picture;
    m_picture.image.setDevicePixelRatio(devicePixelRatioF());
    m_inspector->setPicture(m_picture);
    if (underMouse() && m_inspector->inspections().testFlag(Inspect::Values) && !m_pointing.isActive())
        m_pointing.start(); // something else may be there now
    m_isNew = true;
    update();
}

void PreviewWidget::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (m_picture.image.isNull()) {
        painter.fillRect(rect(), QColor(0x26, 0x26, 0x26));
        return;
    }
    if (m_picture.image.hasAlphaChannel())
        paintChequer(painter, size());
    if (m_picture.image.size() == deviceSize()) {
        painter.drawImage(0, 0, m_picture.image);
        painter.drawImage(rect(), m_inspector->marks());
    } else {
        paintInPlaceOf(painter, m_picture.image, size());
        redraw();
    }
    if (comparison() == Comparison::Wipe)
        paintWipeLine(painter, m_wipe * width(), height());
    if (std::exchange(m_isNew, false))
        emit painted(m_picture.order.made, m_picture.seconds);
}

void PreviewWidget::resizeEvent(QResizeEvent*) { redraw(); }

void PreviewWidget::showEvent(QShowEvent*) { redraw(); }

void PreviewWidget::frame()
{
    m_workspace.document.edit(tr("Frame the object"), {}, [](Scene& scene) {
        const CameraSettings initial = initialCamera(scene.view.geometry);
        CameraSettings& camera = scene.view.camera;
        camera.distance = initial.distance;
        camera.target = initial.target;
        if (showsWindow(scene)) { // which is seen from the room alone
            camera.yawDeg = initial.yawDeg;
            camera.pitchDeg = initial.pitchDeg;
            camera.rollDeg = initial.rollDeg;
        }
    });
}

void PreviewWidget::resetView()
{
    m_workspace.document.edit(tr("Reset the view"), {}, [](Scene& scene) {
        const Projection projection = scene.view.camera.projection;
        scene.view.camera = initialCamera(scene.view.geometry);
        scene.view.camera.projection = projection;
    });
}

void PreviewWidget::changeExposure(double ev)
{
    m_workspace.document.edit(tr("Change exposure"), QStringLiteral("view.exposure"),
                              [&](Scene& scene) { scene.view.exposure = std::clamp(scene.view.exposure + ev, -64.0, 64.0); });
    m_rest.start();
}

void PreviewWidget::resetExposure()
{
    m_workspace.document.edit(tr("Reset exposure"), {}, [](Scene& scene) { scene.view.exposure = 0.0; });
}

void PreviewWidget::takeSnapshot()
{
    if (const auto made = m_workspace.live.made())
        m_workspace.snapshots.keep(made, comparison() == Comparison::Off ? m_picture.image : QImage()); // the meter draws it alone, else
}

void PreviewWidget::setComparison(Comparison comparison) { m_workspace.snapshots.setComparison(comparison); }

void PreviewWidget::setWipe(double fraction)
{
    m_wipe = std::clamp(fraction, 0.0, 1.0);
    m_labels->setWipe(m_wipe);
    redraw();
}

void PreviewWidget::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_B || event->modifiers() != Qt::NoModifier || !hasSnapshot()) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (!event->isAutoRepeat() && !m_beforeHold) {
        m_beforeHold = comparison();
        setComparison(Comparison::Hold);
    }
}

void PreviewWidget::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_B || event->isAutoRepeat() || !m_beforeHold) {
        QWidget::keyReleaseEvent(event);
        return;
    }
    setComparison(*m_beforeHold);
    m_beforeHold.reset();
}

void PreviewWidget::leaveEvent(QEvent*)
{
    m_pointing.stop();
    m_isPointing = false;
    m_inspector->point({}, {});
    m_workspace.cursor.set(std::nullopt);
}

std::optional<glm::dvec2> PreviewWidget::discPlaceAt(const QPointF& position, SphereMapIndex index)
{
    const auto made = m_workspace.live.made();
    if (!made)
        return std::nullopt;
    const std::pair wanted(placesOnly(settings(*made)), index);
    if (wanted != m_placesOf) {
        m_places = m_thread.discPlaces(wanted.first, index);
        m_placesOf = wanted;
    }
    const auto pixel = nowPixel(position);
    return m_places && pixel ? m_places->at(pixel->x(), pixel->y()) : std::nullopt;
}

// Where the reflection under the mouse comes from: the map shows it. The picture itself needs no mark there.
void PreviewWidget::point()
{
    const auto made = m_workspace.live.made();
    if (!made || m_drag != Drag::None || !underMouse() || m_workspace.sphereMap.isPainting())
        return;
    const QPointF whole = m_last * devicePixelRatioF(), pixel = nowPixel(m_last).value_or(whole); // both are seen from one place
    const auto use = [this, at = QPoint(static_cast<int>(whole.x()), static_cast<int>(whole.y()))](const PickedPixel& picked) {
        if (m_drag != Drag::None || !underMouse())
            return; // it has gone on
        m_inspector->point(at, picked);
        m_isPointing = true;
        m_workspace.cursor.set(picked.hit ? std::optional(glm::dvec3(picked.hit->lookup)) : std::nullopt);
        m_isPointing = picked.hit.has_value();
    };
    m_thread.pick({.made = made, .settings = settings(*made)}, static_cast<int>(pixel.x()), static_cast<int>(pixel.y()), use);
}

} // namespace mirrorball::studio
