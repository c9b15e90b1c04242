#pragma once

#include "environment_map.h"
#include "image_io.h"

#include "core/base/job.h"

#include <optional>
#include <string>

namespace mirrorball {

/// How an image file lays out its map. Whole is the layout of parameterization.h as it stands; the others are foreign forms of a latlong or
/// a cube.
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
};

/// What a file was taken for, and why.
struct Detection {
    MapLayout layout{}; ///< of the map that toEnvironmentMap() makes of it
    Arrangement arrangement = Arrangement::Whole;
    std::string reason{}; ///< one clause for the user: "2:1, taken for a latlong"
    bool certain = true;  ///< false where the shape fits several kinds: say so, and offer --from
};

/// Finds out what map a file holds, from its header alone. In this order: a kind that the user forces, the OpenEXR envmap attribute,
/// Mirrorball's own attributes (mirrorball:parameterization, mirrorball:border; ignored when the shape does not fit them), the shape.
/// A square fits angular, sphere and octahedral maps: it is taken for an angular map, not certain. 2:1 is a latlong.
/// @param forced  the kind to read the file as; its cube may come in any of the cube arrangements
/// @throws FileError when the shape fits nothing, or not the forced kind: names the sizes that would
Detection detectLayout(const ImageFileInfo& info, std::optional<Parameterization> forced = {});

/// Turns a file's image into a map in our layout: cuts up strips, grids and crosses, resamples OpenEXR's edge-sampled maps, spreads a
/// constant. A cross is a picture from inside, like a latlong: its front is the latlong's centre, +Z, with -X on the right.
/// @param image  of the file that `detection` was made for, RGB
/// @throws InvalidArgument when the image does not have the size that was detected; Cancelled
EnvironmentMap toEnvironmentMap(Image image, const Detection& detection, const JobControl& job = {});

} // namespace mirrorball
