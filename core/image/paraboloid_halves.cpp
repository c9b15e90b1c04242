#include "paraboloid_halves.h"

#include "core/sphere/dual_paraboloid.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace mirrorball {

namespace {

/// The color and the weight of a half at a place of its picture, in texels: bilinear, weighted by the alpha.
glm::dvec4 believed(const ParaboloidHalf& half, const glm::dvec2& p)
{
    const int n = half.rgba.width;
    const int x = static_cast<int>(std::floor(p.x - 0.5)), y = static_cast<int>(std::floor(p.y - 0.5));
    const double fx = p.x - 0.5 - x, fy = p.y - 0.5 - y;
    glm::dvec4 sum(0.0);
    for (int k = 0; k < 4; ++k) {
        const float* t = half.rgba.texel(std::clamp(x + k % 2, 0, n - 1), std::clamp(y + k / 2, 0, n - 1));
        const double w = (k % 2 == 0 ? 1.0 - fx : fx) * (k / 2 == 0 ? 1.0 - fy : fy);
        sum += w * t[3] * glm::dvec4(t[0], t[1], t[2], 1.0);
    }
    return sum; // color times weight, weight
}

/// Alpha 1 for the texels whose centers lie in the circle.
void markCircle(Image& rgba, int border)
{
    const disc::Disc circle = dual_paraboloid::half(rgba.width, border, false);
    for (int y = 0; y < rgba.height; ++y)
        for (int x = 0; x < rgba.width; ++x)
            rgba.texel(x, y)[3] = circle.holdsCenter(x, y) ? 1.0f : 0.0f;
}

} // namespace

std::array<Image, 2> splitHalves(const EnvironmentMap& map)
{
    const int n = map.layout.size;
    std::array<Image, 2> halves{Image(n, n, 4), Image(n, n, 4)};
    for (int i = 0; i < 2; ++i) {
        Image& half = halves[static_cast<size_t>(i)];
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                std::copy_n(map.image.texel(i * n + x, y), 3, half.texel(x, y));
        markCircle(half, map.layout.border);
    }
    return halves;
}

Image joinHalves(const ParaboloidHalf& front, const ParaboloidHalf& back, int border)
{
    const int n = front.rgba.width;
    std::array<ParaboloidHalf, 2> halves{front, back};
    const bool complements = front.hasAlpha && !back.hasAlpha;
    for (ParaboloidHalf& half : halves)
        if (!half.hasAlpha)
            markCircle(half.rgba, border);
    if (complements)
        for (size_t i = 3; i < halves[1].rgba.texels.size(); i += 4)
            halves[1].rgba.texels[i] = 1.0f; // its weight is what the front leaves
    Image joined(2 * n, n, 3);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < 2 * n; ++x) {
            const bool isBack = x >= n;
            const glm::dvec2 own = dual_paraboloid::half(n, border, false).fromImage({x % n + 0.5, y + 0.5});
            const double rho2 = glm::dot(own, own);
            const glm::dvec2 here{x % n + 0.5, y + 0.5};
            const glm::dvec2 there = rho2 > 1e-12 ? dual_paraboloid::half(n, border, false).toImage(own / rho2) : glm::dvec2(-1.0);
            const bool sees = there.x >= 0.0 && there.y >= 0.0 && there.x <= n && there.y <= n;
            glm::dvec4 f = isBack ? (sees ? believed(halves[0], there) : glm::dvec4(0.0)) : believed(halves[0], here);
            glm::dvec4 b = isBack ? believed(halves[1], here) : (sees ? believed(halves[1], there) : glm::dvec4(0.0));
            if (complements)
                b *= 1.0 - std::min(f.w, 1.0);
            const glm::dvec4 sum = f + b;
            const float* kept = halves[isBack ? 1 : 0].rgba.texel(x % n, y);
            for (int c = 0; c < 3; ++c)
                joined.texel(x, y)[c] = sum.w > 1e-9 ? static_cast<float>(sum[c] / sum.w) : kept[c];
        }
    return joined;
}

void divideByAlpha(Image& rgba)
{
    for (size_t i = 0; i < rgba.texels.size(); i += 4)
        for (size_t c = 0; c < 3 && rgba.texels[i + 3] > 0.0f; ++c)
            rgba.texels[i + c] /= rgba.texels[i + 3];
}

int borderOf(const ImageFileInfo& info)
{
    const auto found = info.attributes.find("mirrorball:border");
    int border = 0;
    if (found != info.attributes.end())
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), border);
    return border;
}

} // namespace mirrorball
