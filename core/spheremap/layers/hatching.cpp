#include "hatching.h"

#include "core/spheremap/math/fast_math.h"
#include "core/spheremap/math/light_direction.h"

#include <array>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array toneWords{"silhouette"sv, "shade"sv};

/// One set of lines.
struct Lines {
    glm::vec2 across{0.0f}, along{0.0f};
    float perDisc = 1.0f; ///< lines a radius
    float curvature = 0.0f;
    float halfWidth = 0.0f; ///< of a full line, in spacings
    float from = 0.0f, slope = 1.0f, jitter = 0.0f;
    std::int32_t seed = 0;

    float coverage(float x, float y, float tone, float texel) const
    {
        const float v = x * along.x + y * along.y;
        const float scale = perDisc / std::sqrt(std::max(1.0f - curvature * v * v, 0.02f));
        // The pen wanders slowly along a line, neighbors much alike.
        const float wander = jitter * (fast::noise(3.0f * v, 0.15f * perDisc * (x * across.x + y * across.y), seed) - 0.5f);
        const float s = (x * across.x + y * across.y) * scale + wander;
        const float line = fast::floor(s + 0.5f);
        const auto i = static_cast<std::int32_t>(line);
        const float place = jitter * 0.4f * (fast::hash(i, 1, seed) - 0.5f);
        const float begins = from + jitter * 0.35f * (fast::hash(i, 2, seed) - 0.5f) / slope;
        const float pressure = 1.0f + jitter * (fast::hash(i, 3, seed) + fast::noise(7.0f * v, line, seed + 1) - 1.0f);
        const float h = std::min(halfWidth * pressure * smooth((tone - begins) * slope), 0.5f);
        const float d = s - line - place, t = texel * scale; // in spacings
        const float overlap = std::min(d + 0.5f * t, h) - std::max(d - 0.5f * t, -h);
        const float one = std::min(std::max(overlap / t, 0.0f), 1.0f);
        const float blend = smooth(2.0f * t - 1.0f); // texels as wide as the spacing see the average
        return one + blend * (2.0f * h - one);
    }
};

/// Adds the coverage of one set to what others cover. Texels whose tone is below every line's beginning are left alone.
MIRRORBALL_VECTOR_CLONES void cover(const Lines& lines, const DiscSpan& at, const float* __restrict tone, float* __restrict opacity)
{
    const float least = lines.from - 0.175f * lines.jitter / lines.slope;
    int first = 0, last = at.count;
    while (first < last && tone[first] <= least)
        ++first;
    while (last > first && tone[last - 1] <= least)
        --last;
    for (int i = first; i < last; ++i)
        opacity[i] = 1.0f - (1.0f - opacity[i]) * (1.0f - lines.coverage(at.x[i], at.y[i], tone[i], at.texel));
}

Lines lines(const HatchingLayer& layer, double angleDeg, double from, std::int32_t seed)
{
    const double angle = angleDeg * pi / 180.0;
    Lines set;
    set.along = glm::vec2(std::cos(angle), std::sin(angle));
    set.across = glm::vec2(-std::sin(angle), std::cos(angle));
    set.perDisc = static_cast<float>(layer.density / 2.0);
    set.curvature = static_cast<float>(layer.curvature);
    set.halfWidth = static_cast<float>(0.5 * layer.width);
    set.from = static_cast<float>(from);
    set.slope = static_cast<float>(1.0 / std::max(layer.to - from, 1e-3));
    set.jitter = static_cast<float>(layer.jitter);
    set.seed = seed;
    return set;
}

} // namespace

std::span<const std::string_view> words(HatchingTone) { return toneWords; }

SpanGenerator prepare(const HatchingLayer& layer, const Level&)
{
    const Lines first = lines(layer, layer.angleDeg, layer.from, 4 * layer.seed);
    const Lines second = lines(layer, layer.angleDeg + layer.crossAngleDeg, layer.crossFrom, 4 * layer.seed + 2);
    const bool shade = layer.tone == HatchingTone::Shade, cross = layer.cross;
    const glm::vec3 l(lightDirection(layer.azimuthDeg, layer.polarDeg)), color(layer.color);
    return [=](const DiscSpan& at, ColorSpan& out) {
        fill(out, at.count, color.r, color.g, color.b);
        alignas(64) float tone[spanLength];
        for (int i = 0; i < at.count; ++i)
            tone[i] = shade ? 0.5f - 0.5f * (at.x[i] * l.x + at.y[i] * l.y + at.z[i] * l.z) : at.rho[i];
        std::fill_n(out.a, at.count, 0.0f);
        cover(first, at, tone, out.a);
        if (cross)
            cover(second, at, tone, out.a);
    };
}

} // namespace mirrorball
