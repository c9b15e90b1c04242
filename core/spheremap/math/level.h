#pragma once

#include "core/base/fields.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace mirrorball {

class SphereMapAssets;

/// What a map is looked up by: the surface normal (a matcap) or the mirror direction (a mirror ball), both in eye space. In an
/// orthographic view along -Z they are the same lookup, because the disc is the picture of a mirror ball, whose normal at a point is the
/// point; so a document means the same under both, and this says how a perspective view reads it.
enum class SphereMapIndex { Normal, Reflection };
std::span<const std::string_view> words(SphereMapIndex); // normal reflection

/// The unit of a line's width. Disc: the line is part of the picture, and is as wide at every size. Pixels: of the level that is looked
/// up; since the level is chosen so that its pixels are about as large as the screen's, such a line keeps its width on the screen, whatever
/// the curvature. Source: 000 section 4.
enum class WidthUnit { Disc, Pixels };
std::span<const std::string_view> words(WidthUnit); // disc pixels

/// What a layer is made ready for.
struct Level {
    int size = 512;      ///< texels along an edge of what is evaluated
    int levelSize = 512; ///< of the level that it stands for: smaller than `size` where a level is evaluated finer and then averaged
    int level = 0;       ///< of the chain
    SphereMapIndex index = SphereMapIndex::Normal;
    std::filesystem::path folder{};    ///< relative paths start here
    SphereMapAssets* assets = nullptr; ///< never null while layers are made ready

    /// Edge of a texel in radii of the disc.
    double texel() const { return 2.0 / size; }
    /// A width in radii of the disc.
    double width(double value, WidthUnit unit) const { return unit == WidthUnit::Pixels ? value * 2.0 / levelSize : value; }
};

} // namespace mirrorball
