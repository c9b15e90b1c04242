#pragma once

#include "scene.h"

#include "core/base/job.h"
#include "core/image/picture_levels.h"

#include <string>

/// Pictures that lie on a mesh by its texture coordinates: the color of the diffuse part, normals, the pattern of flecks. The coordinates
/// are (0, 0) at the picture's lower left and (1, 1) at its upper right corner; beyond, the picture repeats.
namespace mirrorball {

/// What of a picture is used.
enum class SurfacePictureUse {
    Color, ///< linear RGB, not below 0
    Share, ///< luminance, [0, 1]: one channel
    /// Vectors, each component in [-1, 1]: stored values x are 2 x - 1, whatever the file says of its colors. A file of floats may also
    /// hold the vectors themselves; it is taken as that in which their lengths are nearer to 1.
    Normal,
};

/// One picture to read.
struct SurfacePicturePlan {
    std::string name{};   ///< for stages: "diffuse picture"
    std::string field{};  ///< for messages: "material.diffuse.picture"
    std::string source{}; ///< as the scene names it
    SurfacePictureUse use = SurfacePictureUse::Color;
    bool operator==(const SurfacePicturePlan&) const = default;
};

inline constexpr int largestSurfacePicture = 8192; ///< texels along an edge

/// Reads a picture as any other (image_io.h): what its file says of its colors is heeded, opacity is left out.
/// @throws InvalidArgument in one line with field and file, for one that is missing, damaged or too large; Cancelled
PictureLevels readSurfacePicture(const Scene& scene, const SurfacePicturePlan& plan, const JobControl& job = {});

} // namespace mirrorball
