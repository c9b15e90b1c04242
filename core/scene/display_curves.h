#pragma once

#include "scene.h"

/// Through which curves a scene's picture is displayed: the one place that knows what `view.tone: auto` means.
namespace mirrorball {

/// The curves of the object and of what stands behind it; they differ with `auto` alone.
struct DisplayCurves {
    ToneCurve object = ToneCurve::Filmic;
    ToneCurve behind = ToneCurve::Filmic;
    bool operator==(const DisplayCurves&) const = default;
};

/// Whether the picture shows a sphere map in place of the material, not light that was reflected: its colors are those that somebody chose.
bool showsPaint(const Scene& scene);

/// The curves that `view.tone` stands for. auto: what showsPaint() names is displayed as it was painted, ToneCurve::None; everything else
/// through filmic. Where the scene names an OpenColorIO display, that stands in for both.
DisplayCurves displayCurves(const Scene& scene);

} // namespace mirrorball
