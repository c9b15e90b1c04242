#pragma once

#include "reproject.h"

namespace mirrorball {

/// Conservative remapping: each target texel is the mean of the source over it,
///   T_i = sum_j omega_ij S_j / sum_j omega_ij,
/// with omega_ij the solid angle that target texel i and source texel j have in common. Energy is kept, since the omega_ij of a source
/// texel add up to its own, and so is a constant. Source rows go by once, in bands; the common solid angles are integrals along the
/// outlines of target texels (row_sums.h, texel_outline.h). Source: P. W. Jones, First- and Second-Order Conservative Remapping Schemes for
/// Grids in Spherical Coordinates, Mon. Wea. Rev. 127 (1999), eqs. 3 and 4.
///
/// Texels smaller than the source's are lookups at their centers instead, as reproject() says; whole maps of them are reproject()'s.
/// @throws Cancelled
EnvironmentMap remap(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job);

/// The same of a source whose rows are read as they are needed. The target must nowhere be finer than the source.
/// @throws Cancelled; what `readRows` throws
EnvironmentMap remapRows(const MapLayout& source, const RowReader& readRows, const ReprojectOptions& options, const JobControl& job);

/// The angle that a texel subtends in direction d, as the side of a square of its solid angle. For a latlong its height, and for an angular
/// map its radial length: the slivers at the poles and the rim are no finer than that in the other direction.
double texelAngle(const MapLayout& layout, const glm::dvec3& d);

/// How much larger target texels are than the source's, by the angle of their longer side.
struct Magnification {
    double smallest = 0.0;
    double largest = 0.0;
};
Magnification magnification(const MapLayout& source, const ReprojectOptions& options);

/// Below this ratio a target texel is the lookup at its center, from it on the mean over it. Near 1 the two are nearly the same: the mean
/// of square patches over a square of their size is the bilinear interpolation.
inline constexpr double magnifiedBelow = 1.05;

} // namespace mirrorball
