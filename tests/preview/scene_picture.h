#pragma once

#include "core/filter/filter_source.h"
#include "core/preview/renderer.h"
#include "core/preview/scene_settings.h"
#include "core/scene/scene_maps.h"

namespace mirrorball::test {

/// A scene as it is drawn, one sample a pixel, maps in floats.
struct ScenePicture {
    Image radiance;
    preview::GeometryBuffers buffers;
    glm::dvec3 toViewer;
};

inline ScenePicture drawScene(const Scene& scene, const EnvironmentMap& probe)
{
    const Plan plan = makePlan(scene, probe.layout);
    SceneProbe opened{.source = FilterSource(probe, {})};
    const SceneMaps maps = buildMaps(scene, plan, opened);
    preview::RenderSettings settings = preview::renderSettings(scene, plan);
    settings.samples = 1;
    preview::Renderer renderer(preview::TexelFormat::Float);
    return {renderer.renderRadiance(settings, preview::renderMaps(maps)), renderer.renderBuffers(settings),
            glm::normalize(glm::dmat3(settings.camera.cameraToWorld()) * glm::dvec3(0.0, 0.0, 1.0))};
}

} // namespace mirrorball::test
