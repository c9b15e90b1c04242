#pragma once

#include "color.h"
#include "environment_map.h"
#include "mip_pyramid.h"

#include "core/base/job.h"

#include <glm/glm.hpp>

/// Pictures of maps for people to look at: any map in any parameterization, enlarged or reduced, in display or false colors, with what the
/// parameterization does drawn over it. In three steps, so that a change of colors samples nothing again: mapWindow() samples radiance,
/// windowColors() colors it, mapOverlay() draws what depends on the layout alone.
namespace mirrorball {

/// The part of a sheet (map_sheet.h) that a picture shows. Pixel (i, j) shows the sheet position origin + (i + 1/2, j + 1/2) / scale.
struct MapWindow {
    MapLayout layout{};     ///< in which the map is laid out here, whatever layout it has itself
    glm::dvec2 origin{0.0}; ///< sheet position of the picture's upper left corner, texels of `layout`
    double scale = 1.0;     ///< pixels a texel, above 0
    int width = 1;          ///< pixels
    int height = 1;
    bool operator==(const MapWindow&) const = default;
};

/// The sheet position that a picture position shows, and back.
inline glm::dvec2 sheetPosition(const MapWindow& window, const glm::dvec2& pixel) { return window.origin + pixel / window.scale; }
inline glm::dvec2 picturePosition(const MapWindow& window, const glm::dvec2& sheet) { return (sheet - window.origin) * window.scale; }

/// Linear RGB and coverage of the window. In the map's own layout at one pixel a texel or more, each pixel is the texel under it;
/// otherwise a trilinear lookup at the level whose texels are as large as the pixel's solid angle. Coverage is 0 beside the map, 1 on it,
/// and in between in a paraboloid's border.
/// @throws InvalidArgument for a scale or a layout out of range; Cancelled
Image mapWindow(const MipPyramid& map, const MapWindow& window, const JobControl& job = {});

enum class MapColors {
    Display,   ///< exposed, tone-mapped, sRGB
    Luminance, ///< falseColor() of log2(L / low) / log2(high / low)
    Signed,    ///< signedColor() of L / high: for differences
};

struct MapColoring {
    MapColors colors = MapColors::Display;
    double exposure = 0.0;              ///< EV, for Display
    ToneCurve tone = ToneCurve::Filmic; ///< for Display
    double low = 1e-3;                  ///< luminance at the lower end of the scale, above 0
    double high = 10.0;                 ///< at its upper end, above low
    bool operator==(const MapColoring&) const = default;
};

/// The display picture of a window: RGBA in [0, 1], sRGB; A is the coverage.
/// @throws InvalidArgument unless 0 < low < high; Cancelled
Image windowColors(const Image& window, const MapColoring& coloring, const JobControl& job = {});

enum class MapTint {
    None,
    SolidAngle, ///< log2 of a texel's solid angle over the mean one, from -tintStops to tintStops, in signedColor()
    Anisotropy, ///< log2 of the ratio of the axes of distortion.h, from 0 to tintStops, in falseColor()
};

/// Doublings from the middle of the solid angles' scale, or from the start of that of the anisotropy, to its end.
inline constexpr double tintStops = 3.0;

struct MapOverlays {
    MapTint tint = MapTint::None;
    bool grid = false;         ///< latitudes and longitudes every gridStepDeg; the planes x = 0, y = 0 and z = 0 are brighter
    bool seams = false;        ///< where charts meet or end
    double gridStepDeg = 15.0; ///< (0, 90]
    double lineWidth = 1.0;    ///< pixels
    bool operator==(const MapOverlays&) const = default;
};

/// What the overlays draw: RGBA in [0, 1], sRGB, not premultiplied; transparent where nothing is drawn.
/// @throws InvalidArgument, Cancelled
Image mapOverlay(const MapWindow& window, const MapOverlays& overlays, const JobControl& job = {});

/// a minus b in a's layout: b is looked up at a's texels. Zero outside a disc.
EnvironmentMap difference(const EnvironmentMap& a, const EnvironmentMap& b, const JobControl& job = {});

/// A range of luminance that shows a map well: all but the darkest 0.1 % and the brightest 0.01 % of its texels, at least one octave wide
/// and at most 2^24 wide; [1/2, 1] for a black map.
struct LuminanceRange {
    double low = 0.5;
    double high = 1.0;
};
LuminanceRange luminanceRange(const EnvironmentMap& map);

/// The largest |luminance| that all but 5 % of a difference's texels stay below; the end of its scale. 1e-6 at least.
double signedRange(const EnvironmentMap& difference);

} // namespace mirrorball
