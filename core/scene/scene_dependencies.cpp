#include "scene_dependencies.h"

namespace mirrorball {

namespace {

/// What a picture takes from the scene as it is at this moment, without a map or a plan between.
void copyMomentary(Scene& to, const Scene& from)
{
    to.view.camera = from.view.camera;
    to.view.exposure = from.view.exposure;
    to.view.tone = from.view.tone;
    to.view.dither = from.view.dither;
    if (to.map.space == MapSpace::World) // the picture's lookups turn then; a map in eye space has the turn in it
        to.probe.yawDeg = from.probe.yawDeg;
}

} // namespace

Scene mapsOf(Scene scene)
{
    copyMomentary(scene, Scene{});
    scene.exports.clear();
    return scene;
}

Scene shownNow(Scene made, const Scene& now)
{
    copyMomentary(made, now);
    return made;
}

MeasuredWork measurementOf(const Scene& scene)
{
    return {.probe = scene.probe.source,
            .folder = scene.folder,
            .reading = scene.probe.reading,
            .target = scene.map.parameterization,
            .lobe = lobe(scene.material.specular)};
}

} // namespace mirrorball
