#include "compositing.h"

#include <cmath>

namespace mirrorball::compositing {

MIRRORBALL_VECTOR_CLONES void setPositions(DiscSpan& at, const Level& level)
{
    const float scale = 2.0f / static_cast<float>(level.size);
    const float y = 1.0f - (static_cast<float>(at.row) + 0.5f) * scale;
    at.texel = scale;
    for (int i = 0; i < at.count; ++i) {
        const float x = (static_cast<float>(at.column + i) + 0.5f) * scale - 1.0f;
        const float r2 = x * x + y * y, length = std::sqrt(r2);
        const float inward = 1.0f / std::max(length, 1.0f); // outside: the nearest point of the rim
        at.x[i] = x * inward;
        at.y[i] = y * inward;
        at.z[i] = std::sqrt(std::max(1.0f - r2, 0.0f));
        at.rho[i] = std::min(length, 1.0f);
    }
}

MIRRORBALL_VECTOR_CLONES void read(const float* __restrict texels, int count, ColorSpan& __restrict colors)
{
    for (int i = 0; i < count; ++i) {
        colors.r[i] = texels[4 * i];
        colors.g[i] = texels[4 * i + 1];
        colors.b[i] = texels[4 * i + 2];
        colors.a[i] = texels[4 * i + 3];
    }
}

MIRRORBALL_VECTOR_CLONES void write(const ColorSpan& __restrict colors, int count, float* __restrict texels)
{
    for (int i = 0; i < count; ++i) {
        texels[4 * i] = colors.r[i];
        texels[4 * i + 1] = colors.g[i];
        texels[4 * i + 2] = colors.b[i];
        texels[4 * i + 3] = colors.a[i];
    }
}

void clear(ColorSpan& colors, int count)
{
    fill(colors, count, 0.0f, 0.0f, 0.0f);
    std::fill_n(colors.a, count, 0.0f);
}

namespace {

/// How much of a layer shows at each texel: its opacity times its mask.
void setShare(const Layer& layer, const SpanGenerator& mask, const DiscSpan& at, ColorSpan& scratch, float* __restrict share)
{
    const auto opacity = static_cast<float>(layer.opacity);
    if (!mask) {
        std::fill_n(share, at.count, opacity);
        return;
    }
    mask(at, scratch);
    const float from = layer.mask->invert ? opacity : 0.0f, slope = layer.mask->invert ? -opacity : opacity;
    const bool luminance = layer.mask->channel == MaskChannel::Luminance;
    for (int i = 0; i < at.count; ++i) {
        const float y = luminance ? 0.2126f * scratch.r[i] + 0.7152f * scratch.g[i] + 0.0722f * scratch.b[i] : 1.0f;
        share[i] = from + slope * std::min(std::max(y * scratch.a[i], 0.0f), 1.0f);
    }
}

/// An adjusted picture over the one it was made from: mixed by the layer's share, opacities too, so that a share of 1 replaces.
MIRRORBALL_VECTOR_CLONES void blendAdjusted(BlendMode mode, int count, const ColorSpan& adjusted, const float* __restrict share,
                                            ColorSpan& backdrop)
{
    ColorSpan mixed = backdrop;
    if (mode == BlendMode::Normal) {
        for (int i = 0; i < count; ++i) {
            mixed.r[i] = adjusted.r[i] * adjusted.a[i];
            mixed.g[i] = adjusted.g[i] * adjusted.a[i];
            mixed.b[i] = adjusted.b[i] * adjusted.a[i];
            mixed.a[i] = adjusted.a[i];
        }
    } else {
        blend(mode, count, adjusted, mixed);
    }
    const auto mix = [&](float* __restrict to, const float* __restrict from) {
        for (int i = 0; i < count; ++i)
            to[i] += share[i] * (from[i] - to[i]);
    };
    mix(backdrop.r, mixed.r);
    mix(backdrop.g, mixed.g);
    mix(backdrop.b, mixed.b);
    mix(backdrop.a, mixed.a);
}

MIRRORBALL_VECTOR_CLONES void unmultiply(int count, ColorSpan& colors)
{
    for (int i = 0; i < count; ++i) {
        const float inverse = 1.0f / std::max(colors.a[i], 1e-20f);
        colors.r[i] *= inverse;
        colors.g[i] *= inverse;
        colors.b[i] *= inverse;
    }
}

/// Lets the share of a layer into its opacity. @return the largest of them
MIRRORBALL_VECTOR_CLONES float weigh(int count, const float* __restrict share, float* __restrict opacity)
{
    constexpr int lanes = 8;
    float most[lanes] = {};
    int i = 0;
    for (; i + lanes <= count; i += lanes)
        for (int k = 0; k < lanes; ++k) {
            opacity[i + k] *= share[i + k];
            most[k] = std::max(most[k], opacity[i + k]);
        }
    for (; i < count; ++i) {
        opacity[i] *= share[i];
        most[0] = std::max(most[0], opacity[i]);
    }
    return *std::max_element(most, most + lanes);
}

/// The brightest light that a layer gives, or that layers make together: what would be brighter is this bright. Even the product of two
/// such, through the strongest adjustment, stays far below the largest float, so that nothing overflows to infinity, whose products with 0
/// are no numbers; and a probe's sun does not come near it.
constexpr float brightest = 1e10f;

/// Colors that are not multiplied by their opacity.
MIRRORBALL_VECTOR_CLONES void bound(int count, ColorSpan& colors)
{
    for (int i = 0; i < count; ++i) {
        colors.r[i] = std::min(brightest, colors.r[i]);
        colors.g[i] = std::min(brightest, colors.g[i]);
        colors.b[i] = std::min(brightest, colors.b[i]);
    }
}

/// Lays what a step made of a picture over that picture. @param colors  not multiplied by their opacity
void layAdjusted(const Step& step, const DiscSpan& at, ColorSpan& colors, ColorSpan& result)
{
    ColorSpan scratch;
    alignas(64) float share[spanLength];
    setShare(*step.layer, step.mask, at, scratch, share);
    bound(at.count, colors);
    blendAdjusted(step.layer->blend, at.count, colors, share, result);
    boundMultiplied(at.count, result);
}

} // namespace

MIRRORBALL_VECTOR_CLONES void boundMultiplied(int count, ColorSpan& colors)
{
    for (int i = 0; i < count; ++i) {
        const float most = brightest * colors.a[i];
        colors.r[i] = std::min(most, colors.r[i]);
        colors.g[i] = std::min(most, colors.g[i]);
        colors.b[i] = std::min(most, colors.b[i]);
    }
}

void run(const Step& step, const DiscSpan& at, ColorSpan& result)
{
    ColorSpan colors;
    if (step.adjust) {
        colors = result;
        unmultiply(at.count, colors);
        step.adjust(at, colors);
        layAdjusted(step, at, colors, result);
        return;
    }
    alignas(64) float share[spanLength];
    setShare(*step.layer, step.mask, at, colors, share);
    step.generate(at, colors);
    if (weigh(at.count, share, colors.a) == 0.0f) // nothing of it here: most of a painted layer, the inside of a ring
        return;
    bound(at.count, colors);
    blend(step.layer->blend, at.count, colors, result);
    boundMultiplied(at.count, result);
}

void runMoved(const Step& step, const DiscSpan& at, ColorSpan& moved, ColorSpan& backdrop)
{
    unmultiply(at.count, moved);
    layAdjusted(step, at, moved, backdrop);
}

} // namespace mirrorball::compositing
