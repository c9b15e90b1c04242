#include "gradient.h"

#include "fast_math.h"
#include "light_direction.h"

#include <array>
#include <memory>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array shapeWords{"radial"sv, "linear"sv, "angular"sv, "shaded"sv};
constexpr std::array repeatWords{"clamp"sv, "repeat"sv, "mirror"sv};

/// t of every texel, into `t`.
MIRRORBALL_VECTOR_CLONES void gradientParameter(const GradientLayer& layer, const DiscSpan& at, float* __restrict t)
{
    const auto cx = static_cast<float>(layer.centerX), cy = static_cast<float>(layer.centerY);
    switch (layer.shape) {
    case GradientShape::Radial: {
        const auto scale = static_cast<float>(1.0 / layer.radius);
        for (int i = 0; i < at.count; ++i) {
            const float x = at.x[i] - cx, y = at.y[i] - cy;
            t[i] = std::sqrt(x * x + y * y) * scale;
        }
        break;
    }
    case GradientShape::Linear: {
        const double angle = layer.angleDeg * pi / 180.0;
        const auto dx = static_cast<float>(std::cos(angle) / (2.0 * layer.radius)),
                   dy = static_cast<float>(std::sin(angle) / (2.0 * layer.radius));
        for (int i = 0; i < at.count; ++i)
            t[i] = (at.x[i] - cx) * dx + (at.y[i] - cy) * dy + 0.5f;
        break;
    }
    case GradientShape::Angular: {
        const double angle = layer.angleDeg * pi / 180.0;
        const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
        for (int i = 0; i < at.count; ++i) {
            const float x = at.x[i] - cx, y = at.y[i] - cy;
            const float turn = fast::atan2(c * y - s * x, c * x + s * y) * static_cast<float>(0.5 / pi);
            t[i] = turn < 0.0f ? turn + 1.0f : turn;
        }
        break;
    }
    case GradientShape::Shaded: {
        const glm::vec3 l(lightDirection(layer.azimuthDeg, layer.polarDeg));
        for (int i = 0; i < at.count; ++i)
            t[i] = 0.5f * (at.x[i] * l.x + at.y[i] * l.y + at.z[i] * l.z) + 0.5f;
        break;
    }
    }
    if (layer.repeat == GradientRepeat::Repeat)
        for (int i = 0; i < at.count; ++i)
            t[i] -= fast::floor(t[i]);
    else if (layer.repeat == GradientRepeat::Mirror)
        for (int i = 0; i < at.count; ++i)
            t[i] = std::fabs(t[i] - 2.0f * fast::floor(0.5f * t[i] + 0.5f));
}

} // namespace

std::span<const std::string_view> words(GradientShape) { return shapeWords; }
std::span<const std::string_view> words(GradientRepeat) { return repeatWords; }

SpanGenerator prepare(const FillLayer& layer, const Level&)
{
    return [color = glm::vec3(layer.color)](const DiscSpan& at, ColorSpan& out) {
        fill(out, at.count, color.r, color.g, color.b);
        std::fill_n(out.a, at.count, 1.0f);
    };
}

SpanGenerator prepare(const GradientLayer& layer, const Level&)
{
    const auto table = std::make_shared<const GradientTable>(layer.stops, layer.mixing);
    return [layer, table](const DiscSpan& at, ColorSpan& out) {
        alignas(64) float t[spanLength];
        gradientParameter(layer, at, t);
        table->look(at.count, t, out);
    };
}

} // namespace mirrorball
