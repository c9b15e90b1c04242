#pragma once

#include "core/filter/lobe.h"
#include "core/filter/spectrum.h"
#include "core/image/environment_map.h"

#include <vector>

/// Which lobe a map shows a probe through, measured degree by degree.
namespace mirrorball {

/// The squared difference of a map and a filtered probe as a quadratic form of the factors k_l of the filter:
///   |map - s sum_l k_l f_l|^2 = s^2 k'Gk - 2 s h'k + q,   f_l the probe's part of degree l
/// over the sphere and the three channels.
struct LobeProblem {
    int bandLimit = 0;
    std::vector<double> gram{};     ///< G: (bandLimit + 1)^2, or its diagonal alone
    std::vector<double> cross{};    ///< h
    double power = 0.0;             ///< q, up to the band limit
    std::vector<double> sampling{}; ///< what the map's texels take off k_l by themselves
};

/// The problem of one level in the probe's orientation. Large cubes are analyzed into degrees; of small maps every texel is compared with
/// the probe's parts at its center, so that nothing is interpolated.
/// @param probe  of a latlong; known at least to lobeBandLimit
LobeProblem lobeProblem(const EnvironmentMap& level, const Spectrum& probe, const JobControl& job = {});
inline constexpr int lobeBandLimit = 96;

/// The lobe that fits best.
struct LobeFit {
    Lobe lobe = ggxLobe(0.0);                        ///< ggx, or phong where that fits clearly better
    double alpha = 0.0;                              ///< of the best ggx lobe
    double scale = 1.0;                              ///< the map's radiance over that of the filtered probe
    double residual = 1.0;                           ///< rms that is left, relative to the map's
    double ggxResidual = 1.0;                        ///< of the best ggx lobe
    double phongExponent = 0.0, phongResidual = 1.0; ///< of the best phong lobe
    bool unfiltered = false;                         ///< narrower than the level's texels can show
};

/// @param size  texels of a quarter turn in the level, which say what is unresolved
LobeFit fitLobe(const LobeProblem& problem, int size);

/// Below this ggx lobes cannot be told from none in a level of this many texels a quarter turn.
double unresolvedAlpha(int size);

/// Texels of a quarter turn on a great circle, about.
int quarterTexels(const MapLayout& layout);

/// The parts of degree 0 .. bandLimit of a probe at a direction: sum_m a_lm Y_lm(d), three channels each.
std::vector<glm::dvec3> degreeParts(const Spectrum& probe, const glm::dvec3& d, int bandLimit);

} // namespace mirrorball
