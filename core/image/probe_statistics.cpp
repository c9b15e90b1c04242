#include "probe_statistics.h"

#include "color.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace mirrorball {

ProbeStatistics statistics(const EnvironmentMap& map)
{
    struct Bright {
        double luminance, energy;
    };
    const Image& image = map.image;
    std::vector<Bright> texels;
    texels.reserve(image.texels.size() / 3);
    ProbeStatistics s;
    s.minLuminance = std::numeric_limits<double>::infinity();
    s.maxLuminance = -std::numeric_limits<double>::infinity();
    double solidAngles = 0.0, energy = 0.0;
    Texel brightest;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double solidAngle = texelSolidAngle(map.layout, x, y);
            if (solidAngle <= 0.0)
                continue;
            const float* t = image.texel(x, y);
            const glm::dvec3 value(t[0], t[1], t[2]);
            const double l = luminance(value);
            for (int c = 0; c < 3; ++c) {
                s.largestValue = std::max(s.largestValue, value[c]);
                s.beyondHalf += value[c] > 65504.0 ? 1 : 0;
            }
            s.minLuminance = std::min(s.minLuminance, l);
            if (l > s.maxLuminance) {
                s.maxLuminance = l;
                brightest = {x, y};
            }
            s.meanRadiance += solidAngle * value;
            solidAngles += solidAngle;
            energy += solidAngle * l;
            texels.push_back({l, solidAngle * l});
        }
    s.meanRadiance /= solidAngles;
    s.meanLuminance = energy / solidAngles;
    s.brightestDirection = texelDirection(map.layout, brightest.x, brightest.y);
    const size_t few = std::max<size_t>(1, texels.size() / 10000);
    std::nth_element(texels.begin(), texels.begin() + static_cast<ptrdiff_t>(few - 1), texels.end(),
                     [](const Bright& a, const Bright& b) { return a.luminance > b.luminance; });
    double held = 0.0;
    for (size_t i = 0; i < few; ++i)
        held += texels[i].energy;
    s.sunShare = energy > 0.0 ? held / energy : 0.0;
    return s;
}

} // namespace mirrorball
