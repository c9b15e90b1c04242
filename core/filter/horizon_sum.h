#pragma once

#include "float_planes.h"
#include "horizon_split.h"
#include "ring_grid.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace mirrorball {

/// The sums over the texels just above the horizon of a HorizonSplit: sum w L n of R, G and B, and sum w n, with n the near part and texel
/// solid angles w.
///
/// In a row x = b + a cos(lon - lon_r), so that 0 < x < width holds in two runs of texels, one where the horizon goes up and one where it
/// goes down, or in one where it lies along the row. x is found in double, its power and the sums in float, eight side by side.
class HorizonSum {
public:
    /// @param changes  texels that are to count as others, see BrightTexels
    HorizonSum(const EnvironmentMap& latlong, std::span<const BrightTexels::Change> changes, const HorizonSplit& split,
               const JobControl& job = {});

    /// @param yaw  radians, as yawed(): added to the azimuths
    void at(std::span<const SpherePoint> places, double yaw, glm::dvec4* sums) const;

    /// Texels that at() looks at for each place, on average over the sphere, and runs of them.
    static double texels(double width, int latlongWidth);
    static double runs(int latlongWidth) { return latlongWidth; }

    /// What at() needs, as plain numbers.
    struct Tables {
        FloatPlanes planes{};
        std::vector<double> cosine{}, sine{};       ///< of each column's azimuth, the first ones again at the end
        std::vector<double> rowCosine{}, rowSine{}; ///< of each row's colatitude
        double exponent = 0.0, width = 1.0;
        double factor = 1.0; ///< k = factor s^n, s = x/width
    };

private:
    Tables m_tables;
};

} // namespace mirrorball
