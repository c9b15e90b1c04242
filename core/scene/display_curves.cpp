#include "display_curves.h"

namespace mirrorball {

bool showsPaint(const Scene& scene)
{
    const SphereMapSettings& map = scene.material.sphereMap;
    return scene.view.shading == Shading::Material && !map.isNone() && map.use == SphereMapUse::Replace;
}

DisplayCurves displayCurves(const Scene& scene)
{
    switch (scene.view.tone) {
    case ToneChoice::None:
        return {ToneCurve::None, ToneCurve::None};
    case ToneChoice::Reinhard:
        return {ToneCurve::Reinhard, ToneCurve::Reinhard};
    case ToneChoice::Filmic:
        return {ToneCurve::Filmic, ToneCurve::Filmic};
    case ToneChoice::Auto:
        break;
    }
    return {showsPaint(scene) ? ToneCurve::None : ToneCurve::Filmic, ToneCurve::Filmic};
}

} // namespace mirrorball
