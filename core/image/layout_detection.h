#pragma once

#include "environment_map.h"
#include "image_io.h"
#include "picture_fit.h"

#include "core/base/job.h"

#include <optional>
#include <string>
#include <vector>

namespace mirrorball {

/// How an image file lays out its map. Whole is the layout of parameterization.h as it stands; the others are foreign forms of it.
enum class Arrangement {
    Whole,
    Constant,           ///< 1 x 1: one radiance for every direction
    EdgeSampledLatlong, ///< OpenEXR's envmap "latlong"
    OpenExrCube,        ///< OpenEXR's envmap "cube"
    HorizontalStrip,    ///< 6:1, the faces of the stacked cube side by side
    Grid3x2,            ///< 3:2, +X -X +Y above -Y +Z -Z
    Grid2x3,            ///< 2:3, +X -X, +Y -Y, +Z -Z
    HorizontalCross,    ///< 4:3, top; left front right back; bottom
    VerticalCross,      ///< 3:4, top; left front right; bottom; back, turned by 180 degrees
    BorderedFaces,      ///< faces stacked, each with a border of its neighbors' texels
    Partial,            ///< a picture that lies somewhere on a latlong, or a fisheye's on an angular map
    NotSquare,          ///< of a map that is square
    Ball,               ///< a photograph with a mirror ball in it
};

/// What a file was taken for, and why.
struct Detection {
    MapLayout layout{}; ///< of the map that toEnvironmentMap() makes of it
    Arrangement arrangement = Arrangement::Whole;
    std::string reason{};              ///< one clause for the user: "2:1, taken for a latlong"
    bool certain = true;               ///< false where the shape fits several kinds: say so, and offer --from
    bool said = false;                 ///< by the file itself, not by its shape
    ViewOnSphere view{};               ///< Partial
    Fit fit = Fit::None;               ///< NotSquare
    int faceBorder = 0;                ///< BorderedFaces: texels
    std::string faces{};               ///< in what order, see ProbeReading
    glm::dmat3 orientation{1.0};       ///< see orientation()
    std::vector<Assumption> assumed{}; ///< parameterization, handedness
    std::vector<std::string> notes{};  ///< what a user should know, a clause each
};

/// Finds out what map a file holds, from its header alone. In this order: a kind that the user forces, the OpenEXR envmap attribute,
/// Mirrorball's own attributes (mirrorball:parameterization, mirrorball:border; ignored when the shape does not fit them), the shape.
/// A square fits angular, sphere and octahedral maps: it is taken for an angular map, not certain. 2:1 is a latlong, and so is what is so
/// to 5 percent, stretched and not certain. Other shapes become a latlong where reading.fit or an angle of view says so; where a square map
/// is asked for, they are brought to a square, and a sphere map that is to be cropped is the ball found in the picture.
/// @throws FileError when the shape fits nothing, or not the forced kind: names the sizes that would; InvalidArgument for options that the
///         kind has no use for
Detection detectLayout(const ImageFileInfo& info, const ProbeReading& reading);
/// The same with nothing but a forced kind.
Detection detectLayout(const ImageFileInfo& info, std::optional<Parameterization> forced = {});

/// Turns a file's image into a map in our layout: cuts up strips, grids and crosses, resamples OpenEXR's edge-sampled maps, spreads a
/// constant, places what is partial, and turns and mirrors it all. A cross is a picture from inside, like a latlong: its front is the
/// latlong's center, +Z, with -X on the right.
/// @param image  of the file that `detection` was made for, RGB
/// @throws InvalidArgument when the image does not have the size that was detected; Cancelled
EnvironmentMap toEnvironmentMap(Image image, const Detection& detection, const JobControl& job = {});

} // namespace mirrorball
