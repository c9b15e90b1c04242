#include "environment_map.h"

#include "core/sphere/disc.h"
#include "core/sphere/dual_paraboloid.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// The four texels around an image position and how much each counts. `base` is the upper left one; it may lie over an edge.
struct Taps {
    Texel base{};
    double fx = 0.0;
    double fy = 0.0;

    explicit Taps(const glm::dvec2& p)
    {
        const double x = std::floor(p.x - 0.5), y = std::floor(p.y - 0.5);
        base = {static_cast<int>(x), static_cast<int>(y)};
        fx = p.x - 0.5 - x;
        fy = p.y - 0.5 - y;
    }
    double weight(int i, int j) const { return (i == 0 ? 1.0 - fx : fx) * (j == 0 ? 1.0 - fy : fy); }
};

glm::vec3 texelAt(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

glm::vec3 interior(const Image& image, const Taps& taps)
{
    const float* top = image.texel(taps.base.x, taps.base.y);
    const float* bottom = image.texel(taps.base.x, taps.base.y + 1);
    const float w00 = static_cast<float>(taps.weight(0, 0)), w10 = static_cast<float>(taps.weight(1, 0));
    const float w01 = static_cast<float>(taps.weight(0, 1)), w11 = static_cast<float>(taps.weight(1, 1));
    const auto sum = [&](int c) { return w00 * top[c] + w10 * top[c + 3] + w01 * bottom[c] + w11 * bottom[c + 3]; };
    return {sum(0), sum(1), sum(2)};
}

bool fits(const Taps& taps, int x0, int y0, int width, int height)
{
    return taps.base.x >= x0 && taps.base.y >= y0 && taps.base.x + 1 < x0 + width && taps.base.y + 1 < y0 + height;
}

/// Latlong and octahedral: every address over an edge has its texel.
glm::vec3 onWholeSquare(const EnvironmentMap& map, const glm::dvec2& p)
{
    const Taps taps(p);
    if (fits(taps, 0, 0, map.image.width, map.image.height))
        return interior(map.image, taps);
    glm::vec3 sum(0.0f);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const Texel t = acrossSeam(map.layout, {0, 0}, taps.base.x + i, taps.base.y + j);
            sum += static_cast<float>(taps.weight(i, j)) * texelAt(map.image, t.x, t.y);
        }
    return sum;
}

/// Over a face's corner there is no fourth texel: the mean of the other three stands for it, so that the lookup meets at the corner
/// itself in the mean of the three texels around it, whichever face it comes from.
glm::vec3 onCubeFace(const EnvironmentMap& map, const glm::dvec2& p)
{
    const int n = map.layout.size;
    const int top = std::clamp(static_cast<int>(p.y / n), 0, 5) * n;
    const Taps taps(p);
    if (fits(taps, 0, top, n, n))
        return interior(map.image, taps);
    glm::vec3 sum(0.0f);
    std::array<glm::vec3, 4> colors{};
    int missing = -1;
    for (int k = 0; k < 4; ++k) {
        const int x = taps.base.x + k % 2, y = taps.base.y + k / 2;
        if ((x < 0 || x >= n) && (y < top || y >= top + n)) {
            missing = k;
            continue;
        }
        const Texel t = acrossSeam(map.layout, {0, top}, x, y);
        colors[static_cast<size_t>(k)] = texelAt(map.image, t.x, t.y);
        sum += colors[static_cast<size_t>(k)];
    }
    if (missing >= 0)
        colors[static_cast<size_t>(missing)] = sum / 3.0f;
    glm::vec3 result(0.0f);
    for (int k = 0; k < 4; ++k)
        result += static_cast<float>(taps.weight(k % 2, k / 2)) * colors[static_cast<size_t>(k)];
    return result;
}

/// Bilinear among those of the four texels whose centers the disc holds: the others may be anything, black in a foreign file.
glm::vec3 withinDisc(const EnvironmentMap& map, const glm::dvec2& p)
{
    const disc::Disc d = disc::at(map.layout, p.x);
    const Taps taps(p);
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (int k = 0; k < 4; ++k) {
        const int x = taps.base.x + k % 2, y = taps.base.y + k / 2;
        const double w = taps.weight(k % 2, k / 2);
        if (w > 0.0 && d.holdsCenter(x, y)) {
            sum += w * glm::dvec3(texelAt(map.image, x, y));
            total += w;
        }
    }
    if (total < 1e-6) {
        const Texel t = d.innerTexel(p);
        return texelAt(map.image, t.x, t.y);
    }
    return sum / total;
}

/// A tap past the rim is looked up where its continued direction lies: in the other half, or back inside on the far side. The texels of
/// a paraboloid's border are such values already and are read as they are.
glm::vec3 onDisc(const EnvironmentMap& map, const glm::dvec2& p)
{
    const disc::Disc d = disc::at(map.layout, p.x);
    const Taps taps(p);
    const int x = taps.base.x, y = taps.base.y;
    if (map.layout.border > 0 || (d.holdsCenter(x, y) && d.holdsCenter(x + 1, y) && d.holdsCenter(x, y + 1) && d.holdsCenter(x + 1, y + 1)))
        return interior(map.image, taps);
    glm::vec3 sum(0.0f);
    for (int k = 0; k < 4; ++k) {
        const double w = taps.weight(k % 2, k / 2);
        if (w <= 0.0)
            continue;
        const int tx = x + k % 2, ty = y + k / 2;
        if (d.holdsCenter(tx, ty)) {
            sum += static_cast<float>(w) * texelAt(map.image, tx, ty);
            continue;
        }
        // The center of the other half's disc keeps the tap's own half: continue the formula of the half that p lies in.
        glm::dvec2 q = d.fromImage({tx + 0.5, ty + 0.5});
        glm::dvec2 there;
        if (mapping(map.layout.kind).charts == Charts::Halves)
            there = dual_paraboloid::half(map.layout.size, 0, p.x < map.layout.size).toImage(q / glm::dot(q, q));
        else
            there = coordinate(map.layout, direction(map.layout, {tx + 0.5, ty + 0.5}));
        sum += static_cast<float>(w) * withinDisc(map, there);
    }
    return sum;
}

} // namespace

glm::vec3 EnvironmentMap::radiance(const glm::dvec3& d) const
{
    const glm::dvec2 p = coordinate(layout, glm::normalize(d));
    switch (mapping(layout.kind).charts) {
    case Charts::Whole:
        return onWholeSquare(*this, p);
    case Charts::Faces:
        return onCubeFace(*this, p);
    case Charts::Disc:
    case Charts::Halves:
        return onDisc(*this, p);
    }
    return {};
}

glm::dvec3 meanRadiance(const EnvironmentMap& map)
{
    const SolidAngles solidAngles(map.layout);
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (int y = 0; y < map.image.height; ++y) {
        const float* t = map.image.row(y);
        glm::dvec3 rowSum(0.0);
        double rowTotal = 0.0;
        for (int x = 0; x < map.image.width; ++x, t += 3) {
            const double w = solidAngles.at(x, y);
            if (w > 0.0) {
                rowSum += w * glm::dvec3(t[0], t[1], t[2]);
                rowTotal += w;
            }
        }
        sum += rowSum;
        total += rowTotal;
    }
    return sum / total;
}

} // namespace mirrorball
