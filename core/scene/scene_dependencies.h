#pragma once

#include "scene.h"

/// Which parts of a scene what is made of it depends on. Said once: whoever keeps something of a scene asks here whether it still holds.
namespace mirrorball {

/// The scene with all at its default that neither plan nor maps depend on. Scenes that are the same in this have the same maps; a field
/// that is not named in the .cpp counts as one that they depend on.
Scene mapsOf(Scene scene);

/// `made`, whose maps are at hand, as a picture of `now` shows it: what needs no map is of now.
Scene shownNow(Scene made, const Scene& now);

/// What a measurement of the filtering methods is of.
struct MeasuredWork {
    std::string probe{};
    std::filesystem::path folder{};
    std::optional<Parameterization> from{};
    Parameterization target = Parameterization::Cube;
    Lobe lobe{};
    bool operator==(const MeasuredWork&) const = default;
};
MeasuredWork measurementOf(const Scene& scene);

} // namespace mirrorball
