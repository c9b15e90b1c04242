#include "blend.h"

#include <array>
#include <cmath>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array blendWords{"normal"sv, "multiply"sv, "screen"sv, "add"sv, "overlay"sv, "soft-light"sv, "darken"sv, "lighten"sv};

inline float positive(float x) { return std::max(x, 0.0f); }

struct Normal {
    float operator()(float, float s) const { return s; }
};
struct Multiply {
    float operator()(float b, float s) const { return positive(b) * positive(s); }
};
struct Screen {
    float operator()(float b, float s) const
    {
        b = positive(b);
        s = positive(s);
        return b + s - std::min(b, 1.0f) * std::min(s, 1.0f);
    }
};
struct Add {
    float operator()(float b, float s) const { return b + s; }
};
struct Overlay {
    float operator()(float b, float s) const
    {
        const float x = std::sqrt(positive(b)), y = std::sqrt(positive(s));
        const float bright = 2.0f * x - 1.0f;
        const float m = x < 0.5f ? 2.0f * x * y : bright + y - std::min(positive(bright), 1.0f) * std::min(y, 1.0f);
        return m * m;
    }
};
struct SoftLight {
    float operator()(float b, float s) const
    {
        b = positive(b);
        const float x = std::sqrt(std::min(b, 1.0f)), y = std::sqrt(std::min(positive(s), 1.0f));
        const float d = x <= 0.25f ? ((16.0f * x - 12.0f) * x + 4.0f) * x : std::sqrt(x);
        const float m = y <= 0.5f ? x - (1.0f - 2.0f * y) * x * (1.0f - x) : x + (2.0f * y - 1.0f) * (d - x);
        return m * m + std::max(b - 1.0f, 0.0f);
    }
};
struct Darken {
    float operator()(float b, float s) const { return std::min(positive(b), positive(s)); }
};
struct Lighten {
    float operator()(float b, float s) const { return std::max(positive(b), positive(s)); }
};

template <typename Visit>
auto withMode(BlendMode mode, Visit&& visit)
{
    switch (mode) {
    case BlendMode::Multiply:
        return visit(Multiply{});
    case BlendMode::Screen:
        return visit(Screen{});
    case BlendMode::Add:
        return visit(Add{});
    case BlendMode::Overlay:
        return visit(Overlay{});
    case BlendMode::SoftLight:
        return visit(SoftLight{});
    case BlendMode::Darken:
        return visit(Darken{});
    case BlendMode::Lighten:
        return visit(Lighten{});
    case BlendMode::Normal:
        break;
    }
    return visit(Normal{});
}

template <typename Mix>
void blendChannel(int count, const float* __restrict source, const float* __restrict as, float* __restrict backdrop,
                  const float* __restrict ab, Mix mix)
{
    for (int i = 0; i < count; ++i) {
        const float both = as[i] * ab[i];
        const float below = backdrop[i] / std::max(ab[i], 1e-20f);
        backdrop[i] = (1.0f - as[i]) * backdrop[i] + (as[i] - both) * source[i] + both * mix(below, source[i]);
    }
}

} // namespace

std::span<const std::string_view> words(BlendMode) { return blendWords; }

float blended(BlendMode mode, float backdrop, float source)
{
    return withMode(mode, [&](auto mix) { return mix(backdrop, source); });
}

MIRRORBALL_VECTOR_CLONES void blend(BlendMode mode, int count, const ColorSpan& source, ColorSpan& backdrop)
{
    if (mode == BlendMode::Normal) {
        // as ab s + as (1 - ab) s is as s: no division.
        const auto over = [&](const float* __restrict s, const float* __restrict as, float* __restrict b) {
            for (int i = 0; i < count; ++i)
                b[i] = (1.0f - as[i]) * b[i] + as[i] * s[i];
        };
        over(source.r, source.a, backdrop.r);
        over(source.g, source.a, backdrop.g);
        over(source.b, source.a, backdrop.b);
    } else {
        withMode(mode, [&](auto mix) {
            blendChannel(count, source.r, source.a, backdrop.r, backdrop.a, mix);
            blendChannel(count, source.g, source.a, backdrop.g, backdrop.a, mix);
            blendChannel(count, source.b, source.a, backdrop.b, backdrop.a, mix);
        });
    }
    for (int i = 0; i < count; ++i)
        backdrop.a[i] += source.a[i] * (1.0f - backdrop.a[i]);
}

} // namespace mirrorball
