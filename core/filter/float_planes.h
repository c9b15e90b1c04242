#pragma once

#include "bright_texels.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace mirrorball {

/// Eight floats side by side; loads need no alignment.
typedef float FloatLanes __attribute__((vector_size(32), aligned(4), may_alias));
typedef int IntLanes __attribute__((vector_size(32)));
inline constexpr int floatLanes = 8;

/// A latlong map as sums over its texels take it: one plane a channel, so that eight texels side by side are a load each.
struct FloatPlanes {
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0;         ///< floats from one row to the next; loads of eight go beyond the last texel
    std::vector<float> channels[3]{};  ///< R, G, B, scaled
    std::vector<double> solidAngles{}; ///< of each row's texels
    double scale = 1.0;                ///< of the planes, a power of two: so that rows of the largest floats do not overflow in a sum

    FloatPlanes() = default;
    /// @param changes  texels that are to count as others, see BrightTexels
    FloatPlanes(const EnvironmentMap& latlong, std::span<const BrightTexels::Change> changes, const JobControl& job);
};

/// Sums over texels of R, G, B and 1, side by side in lanes.
struct LaneSums {
    FloatLanes red{}, green{}, blue{}, one{};

    /// Over the lanes, in double; of channels that are scaled by `scale`, undone.
    [[gnu::always_inline]] inline glm::dvec4 total(double scale) const
    {
        const auto over = [](const FloatLanes& v) __attribute__((always_inline))
        {
            double sum = 0.0;
            for (int i = 0; i < floatLanes; ++i)
                sum += static_cast<double>(v[i]);
            return sum;
        };
        return {over(red) / scale, over(green) / scale, over(blue) / scale, over(one)};
    }
};

} // namespace mirrorball
