#pragma once

#include "core/base/job.h"

#include <libsharp/sharp.h>
#include <libsharp/sharp_almhelpers.h>

#include <complex>
#include <memory>
#include <span>
#include <vector>

/// Harmonic transforms of maps that lie on rings of colatitude, by libsharp.
namespace mirrorball::ring_transform {

struct GeometryDeleter {
    void operator()(sharp_geom_info* p) const { sharp_destroy_geom_info(p); }
};
struct CoefficientsDeleter {
    void operator()(sharp_alm_info* p) const { sharp_destroy_alm_info(p); }
};
using Geometry = std::unique_ptr<sharp_geom_info, GeometryDeleter>;
using Coefficients = std::unique_ptr<sharp_alm_info, CoefficientsDeleter>;

/// Colatitudes of the rows of a latlong map, from the top.
std::vector<double> ringColatitudes(int rings);

/// Rings of one length, stored one after the other, in blocks that are transformed each by itself: a ring and its mirror image beyond the
/// equator share one, as they share their Legendre functions.
/// @param weight  of each ring's samples; empty: 1. @param phi0  azimuth of a ring's first sample
std::vector<Geometry> ringBlocks(const std::vector<double>& theta, const std::vector<double>& weight, int ringLength, double phi0,
                                 size_t mostBlocks = 16);

/// Coefficients up to a band limit, at Spectrum::index().
Coefficients triangle(int bandLimit);

/// The rings of a map from coefficients.
void toRings(std::vector<std::complex<double>>& coefficients, std::vector<double>& map, const std::vector<Geometry>& blocks,
             const Coefficients& triangle, const JobControl& job);

/// Coefficients from the rings of maps. Small ones are shared out among threads by map and by two lots of blocks, which are added in
/// order, so that nothing depends on who was first; large ones, which would take that much more memory, by libsharp itself.
void fromRings(std::span<std::vector<std::complex<double>>> coefficients, std::span<std::vector<double>> maps,
               const std::vector<Geometry>& blocks, const Coefficients& triangle, const JobControl& job);

} // namespace mirrorball::ring_transform
