#include "toon.h"

#include "core/spheremap/math/fast_math.h"
#include "core/spheremap/math/light_direction.h"
#include "core/spheremap/math/oklab.h"

#include <algorithm>

namespace mirrorball {

namespace {

std::vector<ToonBand> bandsOf(const ToonLayer& layer)
{
    std::vector<ToonBand> bands = layer.bands;
    if (bands.empty())
        for (int i = 0; i < layer.count; ++i) {
            const double last = std::max(layer.count - 1, 1);
            bands.push_back({.from = i == 0 ? 0.0 : layer.shadeEnd + (1.0 - layer.shadeEnd) * (i - 1) / last,
                             .color = oklab::mixed(layer.shadeColor, layer.lightColor, layer.count == 1 ? 1.0 : i / last)});
        }
    std::stable_sort(bands.begin(), bands.end(), [](const ToonBand& a, const ToonBand& b) { return a.from < b.from; });
    return bands;
}

/// n.d and how fast it changes over the disc: its gradient is d.xy - d.z q / z.
struct Facing {
    alignas(64) float value[spanLength];
    alignas(64) float slope[spanLength];
};

MIRRORBALL_VECTOR_CLONES void face(const glm::vec3& d, const DiscSpan& at, Facing& facing)
{
    for (int i = 0; i < at.count; ++i) {
        facing.value[i] = at.x[i] * d.x + at.y[i] * d.y + at.z[i] * d.z;
        const float k = d.z / std::max(at.z[i], 0.02f);
        const float sx = d.x - k * at.x[i], sy = d.y - k * at.y[i];
        facing.slope[i] = std::sqrt(sx * sx + sy * sy);
    }
}

/// What part of each texel faces d by more than `edge`; softness is that of n.d.
MIRRORBALL_VECTOR_CLONES void facingPart(const Facing& facing, const DiscSpan& at, float edge, float softness, float* __restrict share)
{
    for (int i = 0; i < at.count; ++i)
        share[i] = Edge(softness, at.texel * facing.slope[i])(facing.value[i] - edge);
}

MIRRORBALL_VECTOR_CLONES void mix(int count, const float* __restrict share, const glm::vec3& color, ColorSpan& out)
{
    for (int i = 0; i < count; ++i) {
        out.r[i] += share[i] * (color.r - out.r[i]);
        out.g[i] += share[i] * (color.g - out.g[i]);
        out.b[i] += share[i] * (color.b - out.b[i]);
    }
}

} // namespace

SpanGenerator prepare(const ToonLayer& layer, const Level&)
{
    const glm::dvec3 l = lightDirection(layer.azimuthDeg, layer.polarDeg);
    const glm::dvec3 half = l + glm::dvec3(0, 0, 1);
    const bool isBehind = glm::length(half) < 1e-6; // no point of the ball mirrors it
    const glm::vec3 h(isBehind ? half : glm::normalize(half));
    const double highlightDeg = isBehind ? 0.0 : layer.highlightDeg;
    const double turn = (layer.azimuthDeg + layer.rimTurnDeg) * pi / 180.0;
    const glm::vec2 rimSide(std::cos(turn), std::sin(turn));
    return [layer, bands = bandsOf(layer), light = glm::vec3(l), h, highlightDeg, rimSide](const DiscSpan& at, ColorSpan& out) {
        alignas(64) float share[spanLength];
        const glm::vec3 base(bands.front().color);
        fill(out, at.count, base.r, base.g, base.b);
        std::fill_n(out.a, at.count, 1.0f);
        Facing facing;
        face(light, at, facing);
        const auto softness = static_cast<float>(layer.softness);
        for (size_t k = 1; k < bands.size(); ++k) {
            facingPart(facing, at, 2.0f * static_cast<float>(bands[k].from) - 1.0f, 2.0f * softness, share); // t = (n.l + 1)/2
            mix(at.count, share, glm::vec3(bands[k].color), out);
        }
        if (highlightDeg > 0.0) {
            face(h, at, facing);
            const auto edge = static_cast<float>(std::cos(highlightDeg * pi / 180.0));
            facingPart(facing, at, edge, softness * (1.0f - edge), share);
            mix(at.count, share, glm::vec3(layer.highlightColor), out);
        }
        if (layer.rim > 0.0) {
            const auto width = static_cast<float>(layer.rim);
            const Edge edge(softness * width, at.texel);
            for (int i = 0; i < at.count; ++i) {
                const float side = (at.x[i] * rimSide.x + at.y[i] * rimSide.y) / std::max(at.rho[i], 1e-6f);
                share[i] = edge(at.rho[i] - 1.0f + width * std::max(side, 0.0f));
            }
            mix(at.count, share, glm::vec3(layer.rimColor), out);
        }
    };
}

} // namespace mirrorball
