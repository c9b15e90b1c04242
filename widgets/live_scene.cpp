#include "live_scene.h"

namespace mirrorball::studio {

namespace {

/// Maps while a control is dragged: soft enough to be made between two frames, and near enough to judge by.
constexpr MapDetail coarse{.largestSize = 128, .tolerance = 1e-3};

/// The scene without what maps and plan do not depend on: a camera that moves makes nothing anew.
Scene mapsOnly(Scene scene)
{
    scene.view.camera = {};
    scene.view.exposure = 0.0;
    scene.view.toneCurve = {};
    if (scene.map.space == MapSpace::World)
        scene.probe.yawDeg = 0.0;
    scene.exports.clear();
    return scene;
}

} // namespace

LiveScene::LiveScene(Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_runner(this), m_maps(std::make_shared<LiveMaps>())
{
    connect(&m_document, &Document::changed, this, &LiveScene::follow);
    connect(&m_document, &Document::dragFinished, this, [this] { follow(Part::All); });
    connect(&m_runner, &JobRunner::failed, this, [this](const QString& message) {
        m_isUpToDate = false;
        emit failed(message);
    });
    request();
}

void LiveScene::follow(Parts)
{
    const MapDetail detail = m_document.isDragging() ? coarse : MapDetail{};
    const bool isFineEnough = m_requestedDetail == detail || m_requestedDetail == MapDetail{};
    if (isFineEnough && mapsOnly(m_requested) == mapsOnly(m_document.scene()) && (m_runner.isBusy() || m_made))
        return;
    request();
}

void LiveScene::refresh()
{
    request();
}

void LiveScene::request()
{
    const bool dragging = m_document.isDragging();
    // A coarse result of a moment ago is better than none; a full one would only be in the way.
    const Running running = dragging && m_requestedDetail == coarse ? Running::Finish : Running::Stop;
    m_requested = m_document.scene();
    m_requestedDetail = dragging ? coarse : MapDetail{};
    m_isUpToDate = false;
    m_runner.start(
        [maps = m_maps, scene = m_requested, detail = m_requestedDetail](const JobControl& job) {
            return std::make_shared<const MadeScene>(maps->update(scene, detail, job));
        },
        [this](std::shared_ptr<const MadeScene> made) {
            m_made = std::move(made);
            m_isUpToDate = m_made->detail == MapDetail{} && mapsOnly(m_made->scene) == mapsOnly(m_document.scene());
            emit updated();
        },
        running);
}

} // namespace mirrorball::studio
