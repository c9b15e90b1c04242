#include "adjust.h"

#include "core/spheremap/math/fast_math.h"

#include <algorithm>
#include <array>
#include <memory>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array channelWords{"all"sv, "red"sv, "green"sv, "blue"sv};

inline float rooted(float x) { return std::sqrt(std::max(x, 0.0f)); }

} // namespace

std::span<const std::string_view> words(AdjustedChannels) { return channelWords; }

namespace {

/// With C = V - smallest, a hue H in [0, 6) and f(n) = V - C max(0, min(k, 4 - k, 1)), k = (n + H) mod 6: R = f(5), G = f(3), B = f(1).
MIRRORBALL_VECTOR_CLONES void turnHue(int count, float turn, float saturation, float factor, ColorSpan& c)
{
    for (int i = 0; i < count; ++i) {
        const float r = std::max(c.r[i], 0.0f), g = std::max(c.g[i], 0.0f), b = std::max(c.b[i], 0.0f);
        const float v = std::max(r, std::max(g, b)), chroma = v - std::min(r, std::min(g, b));
        const float inverse = 1.0f / std::max(chroma, 1e-20f);
        const float h = v == r ? (g - b) * inverse : v == g ? 2.0f + (b - r) * inverse : 4.0f + (r - g) * inverse;
        const float value = v * factor, wide = std::min(chroma * saturation, v) * factor;
        const auto channel = [&](float n) {
            float k = n + h + turn;
            k -= 6.0f * fast::floor(k * (1.0f / 6.0f));
            return value - wide * std::max(0.0f, std::min(std::min(k, 4.0f - k), 1.0f));
        };
        c.r[i] = channel(5.0f);
        c.g[i] = channel(3.0f);
        c.b[i] = channel(1.0f);
    }
}

} // namespace

SpanAdjustment prepare(const HueSaturationLayer& layer, const Level&)
{
    const auto turn = static_cast<float>(layer.hueDeg / 60.0), saturation = static_cast<float>(layer.saturation);
    const auto factor = static_cast<float>(layer.value);
    return [turn, saturation, factor](const DiscSpan& at, ColorSpan& below) { turnHue(at.count, turn, saturation, factor, below); };
}

SpanAdjustment prepare(const CurvesLayer& layer, const Level&)
{
    const auto table = std::make_shared<const CurveTable>(layer.points);
    return [table, which = layer.channels](const DiscSpan& at, ColorSpan& below) {
        const std::array<float*, 3> channels{below.r, below.g, below.b};
        for (size_t c = 0; c < 3; ++c) {
            if (which != AdjustedChannels::All && static_cast<size_t>(which) != c + 1)
                continue;
            for (int i = 0; i < at.count; ++i) {
                const float y = table->at(rooted(channels[c][i]));
                channels[c][i] = y * y;
            }
        }
    };
}

SpanAdjustment prepare(const PosterizeLayer& layer, const Level&)
{
    const auto steps = static_cast<float>(layer.tones - 1);
    const float slope = 1.0f / std::max(static_cast<float>(layer.softness), 1e-3f);
    return [steps, slope](const DiscSpan& at, ColorSpan& below) {
        for (float* channel : {below.r, below.g, below.b})
            for (int i = 0; i < at.count; ++i) {
                const float x = rooted(channel[i]) * steps, low = fast::floor(x);
                const float y = (low + smooth((x - low - 0.5f) * slope + 0.5f)) / steps;
                channel[i] = y * y;
            }
    };
}

SpanAdjustment prepare(const InvertLayer&, const Level&)
{
    return [](const DiscSpan& at, ColorSpan& below) {
        for (float* channel : {below.r, below.g, below.b})
            for (int i = 0; i < at.count; ++i) {
                const float y = std::max(1.0f - rooted(channel[i]), 0.0f);
                channel[i] = y * y;
            }
    };
}

} // namespace mirrorball
