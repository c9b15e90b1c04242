#include "lookup.h"

#include "latlong_positions.h"

#include "core/sphere/disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mirrorball {

std::array<float, 4> keysWeights(double f)
{
    return {static_cast<float>(f * (f * (1.0 - 0.5 * f) - 0.5)), static_cast<float>(1.0 + f * f * (1.5 * f - 2.5)),
            static_cast<float>(f * (0.5 + f * (2.0 - 1.5 * f))), static_cast<float>(0.5 * f * f * (f - 1.0))};
}

namespace {

/// Whether all 4 x 4 texels from (x, y) on lie in the chart of `at` and hold radiance.
bool fits(const MapLayout& layout, Texel at, int x, int y)
{
    const int n = layout.size, chartWidth = layout.chartWidth();
    const int left = at.x / chartWidth * chartWidth, top = at.y / n * n;
    if (x < left || x + 3 >= left + chartWidth || y < top || y + 3 >= top + n)
        return false;
    if (!mapping(layout.kind).hasDiscs() || layout.border >= 2)
        return true;
    const disc::Disc disc = disc::at(layout, at.x);
    return disc.holdsCenter(x, y) && disc.holdsCenter(x + 3, y) && disc.holdsCenter(x, y + 3) && disc.holdsCenter(x + 3, y + 3);
}

glm::vec3 cubic(const EnvironmentMap& map, const glm::dvec3& d)
{
    const MapLayout& layout = map.layout;
    const glm::dvec2 p = coordinate(layout, glm::normalize(d));
    const int x = static_cast<int>(std::floor(p.x - 0.5)) - 1, y = static_cast<int>(std::floor(p.y - 0.5)) - 1;
    const std::array<float, 4> wx = keysWeights(p.x - 1.5 - x), wy = keysWeights(p.y - 1.5 - y);
    const Texel chart{std::min(static_cast<int>(p.x), layout.width() - 1), std::min(static_cast<int>(p.y), layout.height() - 1)};
    const bool inside = fits(layout, chart, x, y);
    glm::vec3 sum(0.0f), least(std::numeric_limits<float>::max()), largest(-std::numeric_limits<float>::max());
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const Texel t = inside ? Texel{x + i, y + j} : acrossSeam(layout, chart, x + i, y + j);
            const float* texel = map.image.texel(t.x, t.y);
            const glm::vec3 value(texel[0], texel[1], texel[2]);
            sum += wx[static_cast<size_t>(i)] * wy[static_cast<size_t>(j)] * value;
            if ((i == 1 || i == 2) && (j == 1 || j == 2)) {
                least = glm::min(least, value);
                largest = glm::max(largest, value);
            }
        }
    return glm::clamp(sum, least, largest);
}

} // namespace

glm::vec3 lookUp(const EnvironmentMap& map, const glm::dvec3& d, Resample resample)
{
    return resample == Resample::Cubic && map.layout.size >= 4 ? cubic(map, d) : map.radiance(d);
}

void lookUp(const EnvironmentMap& map, size_t count, const double* x, const double* y, const double* z, Resample resample, float* rgb)
{
    const auto one = [&](size_t i) {
        const glm::vec3 value = lookUp(map, {x[i], y[i], z[i]}, resample);
        std::copy_n(&value.x, 3, rgb + 3 * i);
    };
    if (map.layout.kind != Parameterization::Latlong || resample != Resample::Linear) {
        for (size_t i = 0; i < count; ++i)
            one(i);
        return;
    }
    constexpr size_t atOnce = 64;
    const int n = map.layout.size;
    double px[atOnce], py[atOnce];
    for (size_t start = 0; start < count; start += atOnce) {
        const size_t block = std::min(atOnce, count - start);
        latlongCoordinates(n, block, x + start, y + start, z + start, px, py);
        for (size_t i = 0; i < block; ++i) {
            const double column = px[i] - 0.5, row = py[i] - 0.5;
            if (!(column >= 0.0 && row >= 0.0 && column < 2 * n - 1 && row < n - 1)) { // over an edge
                one(start + i);
                continue;
            }
            const int left = static_cast<int>(column), top = static_cast<int>(row);
            const float fx = static_cast<float>(column - left), fy = static_cast<float>(row - top);
            const float w00 = (1.0f - fx) * (1.0f - fy), w10 = fx * (1.0f - fy), w01 = (1.0f - fx) * fy, w11 = fx * fy;
            const float* upper = map.image.texel(left, top);
            const float* lower = map.image.texel(left, top + 1);
            for (size_t c = 0; c < 3; ++c)
                rgb[3 * (start + i) + c] = w00 * upper[c] + w10 * upper[c + 3] + w01 * lower[c] + w11 * lower[c + 3];
        }
    }
}

} // namespace mirrorball
