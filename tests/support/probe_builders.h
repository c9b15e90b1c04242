#pragma once

#include "core/image/environment_map.h"

#include <cmath>
#include <cstdint>
#include <random>

/// Small probes with known properties, as latlong maps of N = height.
namespace mirrorball::test {

inline EnvironmentMap constantProbe(int height, float value = 1.0f)
{
    EnvironmentMap probe(MapLayout{Parameterization::Latlong, height, 0});
    for (float& t : probe.image.texels)
        t = value;
    return probe;
}

/// Log-normal noise, every texel independent: the worst a band-limited method can meet but for a sun.
inline EnvironmentMap noiseProbe(int height, std::uint32_t seed)
{
    EnvironmentMap probe(MapLayout{Parameterization::Latlong, height, 0});
    std::mt19937 generator(seed);
    for (float& t : probe.image.texels) {
        // Not std::normal_distribution, whose numbers differ between libraries.
        double sum = 0.0;
        for (int i = 0; i < 12; ++i)
            sum += static_cast<double>(generator()) / 4294967296.0;
        t = static_cast<float>(std::exp(sum - 6.0));
    }
    return probe;
}

/// Noise of 1e-3 with one texel of radiance `sun`.
inline EnvironmentMap sunProbe(int height, float sun, int x, int y)
{
    EnvironmentMap probe = noiseProbe(height, 7);
    for (float& t : probe.image.texels)
        t *= 1e-3f;
    for (int c = 0; c < 3; ++c)
        probe.image.texel(x, y)[c] = sun * (1.0f - 0.1f * static_cast<float>(c));
    return probe;
}

} // namespace mirrorball::test
