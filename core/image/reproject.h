#pragma once

#include "environment_map.h"
#include "lookup.h"

#include "core/base/job.h"

#include <functional>

namespace mirrorball {

struct ReprojectOptions {
    MapLayout target{};
    double yaw = 0.0;                     ///< radians; turns the environment about +Y, from +Z towards +X: L'(d) = L(yawed(d, -yaw))
    glm::dmat3 turn{1.0};                 ///< rotation or mirroring of the environment before that: L'(d) = L(turn^-1 d)
    Resample resample = Resample::Linear; ///< where texels become smaller
};

/// Resamples a map to another parameterization, size or yaw.
///
/// A target texel is the mean, by solid angle, of the source over it, each texel of the source taken as a patch of its radiance: what sums
/// of ever finer samples converge to (remap.h). So a constant stays constant and, where all texels become larger, so does the mean: of
/// one bright texel to 1e-4, of sphere, angular and octahedral maps to 6e-4. A texel smaller in both is the lookup at its center.
/// Texels at a disc's rim stand for their part inside, those outside continue the map. The same layout without yaw or turn returns the
/// source as it is.
/// @throws InvalidArgument for a layout out of range; Cancelled
EnvironmentMap reproject(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job = {});

/// Reads rows [firstRow, firstRow + rows) as RGB; asked for in order from the top.
using RowReader = std::function<void(int firstRow, int rows, float* rgb)>;

/// Whether reprojectRows() can make that target: a source whose rows stand for themselves (no disc), and no texel smaller than its.
bool canReprojectRows(const MapLayout& source, const ReprojectOptions& options);
/// reproject() of a source that is read once, row by row, and never held.
/// @throws InvalidArgument for a layout out of range, or where canReprojectRows() is false; Cancelled; what `readRows` throws
EnvironmentMap reprojectRows(const MapLayout& source, const RowReader& readRows, const ReprojectOptions& options,
                             const JobControl& job = {});

/// A latlong image whose first and last texels lie *on* the seam and the poles, as OpenEXR's envmap "latlong" (ImfEnvmap.h: longitude
/// pi - 2 pi x/(W-1), latitude pi/2 - pi y/(H-1)), resampled to texel centers by bilinear interpolation: a map of size H.
/// @throws InvalidArgument when the image is narrower or lower than 2 texels
EnvironmentMap fromEdgeSampledLatlong(const Image& image, const JobControl& job = {});

/// A cube image of OpenEXR's envmap "cube" (ImfEnvmap.h): six faces +X -X +Y -Y +Z -Z stacked, drawn as seen from outside relative to
/// OpenGL's (X and Z faces mirrored left to right, Y faces top to bottom), the outer texels *on* the edges. Resampled to the cube
/// map of the same size.
/// @throws InvalidArgument unless the image is N x 6N with N at least 2
EnvironmentMap fromOpenExrCube(const Image& image, const JobControl& job = {});

} // namespace mirrorball
