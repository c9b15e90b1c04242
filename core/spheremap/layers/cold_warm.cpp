#include "cold_warm.h"

#include "core/spheremap/math/fast_math.h"

#include "core/sphere/direction.h"

namespace mirrorball {

namespace {

/// erf, to 5e-7. Source: Abramowitz and Stegun 7.1.26.
inline float erf(float x)
{
    const float a = std::fabs(x), t = 1.0f / (1.0f + 0.3275911f * a);
    const float p = t * (0.254829592f + t * (-0.284496736f + t * (1.421413741f + t * (-1.453152027f + t * 1.061405429f))));
    return std::copysign(1.0f - p * fast::exp(-a * a), x);
}

} // namespace

SpanGenerator prepare(const ColdWarmLayer& layer, const Level& level)
{
    const double angle = layer.angleDeg * pi / 180.0;
    const glm::vec2 d(std::cos(angle), std::sin(angle));
    const auto balance = static_cast<float>(layer.balance), radius = static_cast<float>(layer.highlight);
    const glm::vec2 spot = d * static_cast<float>(layer.highlightDistance);
    // A texel's own extent blurs too: a box of one texel has a standard deviation of 1/sqrt(12).
    const auto scale = static_cast<float>(1.0 / (std::sqrt(2.0) * std::hypot(layer.blur, level.texel() / std::sqrt(12.0))));
    const glm::vec3 cold(layer.coldColor), warm(layer.warmColor), highlight(layer.highlightColor);
    return [=](const DiscSpan& at, ColorSpan& out) {
        for (int i = 0; i < at.count; ++i) {
            const float half = 0.5f + 0.5f * erf((at.x[i] * d.x + at.y[i] * d.y + balance) * scale);
            const float x = at.x[i] - spot.x, y = at.y[i] - spot.y, far = std::sqrt(x * x + y * y);
            const float disc = 0.5f * (erf((radius - far) * scale) + erf((radius + far) * scale));
            const auto mixed = [&](float c, float w, float h) {
                const float base = c + half * (w - c);
                return base + disc * (h - base);
            };
            out.r[i] = mixed(cold.r, warm.r, highlight.r);
            out.g[i] = mixed(cold.g, warm.g, highlight.g);
            out.b[i] = mixed(cold.b, warm.b, highlight.b);
            out.a[i] = 1.0f;
        }
    };
}

} // namespace mirrorball
