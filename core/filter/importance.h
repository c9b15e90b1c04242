#pragma once

#include "lobe.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <vector>

namespace mirrorball {

/// Quasi-Monte-Carlo filtering with filtered samples, what today's engines do. The lobe is its own density, so that all samples weigh
/// the same:
///   E(r) = 1/N sum_i L(d_i; level_i),   d_i drawn with pdf k(r.d)
/// Radii are the lobe's quantiles at (i + 1/2)/N, azimuths multiples of the golden angle: Vogel's spiral, whose cells are as long as they
/// are wide everywhere. (Those of Hammersley's points, radical inverses for azimuths, are twelve times as long at the lobe's rim for
/// N = 1024, and have about 1.6 times the error.) The same samples stand about every r.
/// A sample stands for a cell of 1/(N pdf) and is looked up in the pyramid's level whose blur is twice as wide: four times its variance.
/// Source: H. Vogel, "A better way to construct the sunflower head", Mathematical Biosciences 44, 1979; M. Colbert and J. Krivanek,
/// "GPU-Based Importance Sampling", GPU Gems 3 chapter 20, 2007, with the level by variance (mip_blur.h) instead of by area and a bias by
/// hand.

/// One sample of a lobe about +Z.
struct LobeSample {
    double x, y, z;
    double level;    ///< trilinear level in a latlong pyramid
    double variance; ///< per axis, of that lookup: what the sample is blurred by
    double cell;     ///< solid angle it stands for
};
/// @param latlongHeight  rows of the probe; the samples' levels are those of its pyramid
std::vector<LobeSample> lobeSamples(const Lobe& lobe, int count, int latlongHeight);

/// A latlong map whose bilinear lookups, integrated over the sphere, give what the texels of the one passed in hold: sum_j L_j w_j. A plain
/// one's do not. The tent of a row integrates to t_i = 2 (1 - cos h)/h sin theta_i, h = pi/height, a little less than its area
/// w_i = 2 sin(h/2) sin theta_i; that of a row at a pole, folded back over it, to 1 - 2/h sin(h/2) more, 13/12 of its area. From the pole
/// inwards each row takes on as much of the next as sheds its surplus s:
///   L'_i = L_i + s_i/t_i (L_(i+1) - L_i),   s_i = t_i + s_(i-1) - w_i
/// and at the equator none is left. A constant stays that constant.
EnvironmentMap withInterpolatedEnergy(EnvironmentMap latlong);

/// A latlong probe's mip pyramid made ready for many quick lookups: rows near the poles smoothed to texels that are as wide as they are
/// high in every level, lookups that keep the energy, four floats a texel, a halo that carries over the seam and the poles.
class LookupPyramid {
public:
    explicit LookupPyramid(const EnvironmentMap& latlong, const JobControl& job = {});

    struct Level {
        int width = 0, height = 0;
        std::vector<float> texels{}; ///< (height + 2) rows of (width + 2) texels, R G B 0
        const float* at(int x, int y) const { return texels.data() + 4 * ((y + 1) * static_cast<ptrdiff_t>(width + 2) + x + 1); }
        float* at(int x, int y) { return texels.data() + 4 * ((y + 1) * static_cast<ptrdiff_t>(width + 2) + x + 1); }
    };
    const std::vector<Level>& levels() const { return m_levels; }

private:
    std::vector<Level> m_levels{};
};

/// The filtered map. Bytes do not depend on the number of threads; sums run in double, so that a million samples of a constant are
/// that constant.
/// @throws Cancelled
EnvironmentMap importanceSample(const LookupPyramid& pyramid, const Lobe& lobe, int samples, const MapLayout& target, double yaw,
                                const JobControl& job = {});

} // namespace mirrorball
