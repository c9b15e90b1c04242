#pragma once

#include "float_planes.h"
#include "kernel_split.h"
#include "ring_grid.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace mirrorball {

/// The sums over the texels within the reach of a split kernel: sum w L n of R, G and B, and sum w n, with n = k G and texel solid angles
/// w.
///
/// u = 1 - cos t, which a peak of t = 0.004 needs to 1e-7 of itself, is not taken from cosines. In a row
///   u = 2 sin^2((theta - theta')/2) + 2 sin theta sin theta' sin^2((j h - d)/2)
/// with j counted in columns of width h from the one nearest to r, and d what it is off by: the sines of j h/2 are tables, and both terms
/// are positive. Weights and sums are floats, eight sums side by side, which are added up in double.
class NearSum {
public:
    /// @param changes  texels that are to count as others, see BrightTexels
    NearSum(const EnvironmentMap& latlong, std::span<const BrightTexels::Change> changes, const KernelSplit& split,
            const JobControl& job = {});

    /// @param yaw  radians, as yawed(): added to the azimuths
    void at(std::span<const SpherePoint> places, double yaw, glm::dvec4* sums) const;

    /// Texels that at() looks at for each place, on average over the sphere.
    static double texels(double reachAngle, int latlongWidth);

    /// What at() needs, as plain numbers.
    struct Tables {
        FloatPlanes planes{};
        std::vector<float> sine{}, cosine{};                     ///< of j h/2, j = -width/2 .. width/2, from the first
        std::vector<double> rowSine{}, halfSine{}, halfCosine{}; ///< of each row's theta' and of half of it
        double peakOfLobe = 1.0;                                 ///< k(1)
        double reach = 0.0, reachAngle = 0.0;                    ///< of u, and of t
        double steepness = 0.0;                                  ///< k/k(1) = (1 - u)/(1 + steepness u)^2
        size_t terms = 0;                                        ///< of G: KernelSplit::fewPolynomialTerms or mostPolynomialTerms
        float share[KernelSplit::mostPolynomialTerms]{};         ///< G in powers of 1 - 2 u/reach
    };

private:
    Tables m_tables;
};

} // namespace mirrorball
