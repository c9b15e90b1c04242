#pragma once

#include "environment_map.h"

#include "core/base/job.h"

namespace mirrorball {

struct ReprojectOptions {
    MapLayout target{};
    double yaw = 0.0;     ///< radians; turns the environment about +Y, from +Z towards +X: L'(d) = L(yawed(d, -yaw))
    glm::dmat3 turn{1.0}; ///< rotation or mirroring of the environment before that: L'(d) = L(turn^-1 d)
};

/// Resamples a map to another parameterization, size or yaw.
///
/// Where a target texel is no larger than the source's, the value is the bilinear lookup at its centre. Where it is larger, it is the mean
/// over the texel, weighted by solid angle, of sub-samples. When all are larger, those read a level of the source's mip pyramid whose
/// texels are at most three quarters of the target's smallest, smoothed by a cubic B-spline and spaced by half a texel of that level.
/// Texels outside a disc continue it. The same layout without yaw or turn returns the source as it is. A constant map stays constant; the
/// mean radiance is kept to about 1e-3 when minifying, even of a single bright texel.
/// @throws InvalidArgument for a layout out of range; Cancelled
EnvironmentMap reproject(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job = {});

/// A latlong image whose first and last texels lie *on* the seam and the poles, as OpenEXR's envmap "latlong" (ImfEnvmap.h: longitude
/// pi - 2 pi x/(W-1), latitude pi/2 - pi y/(H-1)), resampled to texel centres by bilinear interpolation: a map of size H.
/// @throws InvalidArgument when the image is narrower or lower than 2 texels
EnvironmentMap fromEdgeSampledLatlong(const Image& image, const JobControl& job = {});

/// A cube image of OpenEXR's envmap "cube" (ImfEnvmap.h): six faces +X -X +Y -Y +Z -Z stacked, drawn as seen from outside relative to
/// OpenGL's (X and Z faces mirrored left to right, Y faces top to bottom), the outer texels *on* the edges. Resampled to the cube
/// map of the same size.
/// @throws InvalidArgument unless the image is N x 6N with N at least 2
EnvironmentMap fromOpenExrCube(const Image& image, const JobControl& job = {});

} // namespace mirrorball
