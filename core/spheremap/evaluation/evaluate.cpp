#include "evaluate.h"

#include "core/spheremap/layers/raster_generator.h"
#include "core/spheremap/layers/warp.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// A layer, or the content of a mask, as a function of runs of texels.
SpanGenerator preparedGenerator(const LayerContent& content, const Level& level, const TexelRect& rect, const Image* raster,
                                const JobControl& job);

/// A rectangle and what it becomes when it is scaled about the centre of the map, a little wider; itself where it does not reach the rim.
TexelRect unitedWithScaled(const TexelRect& rect, double scale, int size)
{
    const double c = 0.5 * size, x = std::max(c - rect.x0, rect.x1 - c), y = std::max(c - rect.y0, rect.y1 - c);
    if (rect.empty() || x * x + y * y < (c - 4.0) * (c - 4.0))
        return rect;
    const auto low = [&](int v) { return static_cast<int>(std::floor(c + (v - c) * scale)) - 3; };
    const auto high = [&](int v) { return static_cast<int>(std::ceil(c + (v - c) * scale)) + 3; };
    return rect.united(TexelRect{low(rect.x0), low(rect.y0), high(rect.x1), high(rect.y1)}).intersected({0, 0, size, size});
}

/// What outside the disc takes its colour from `rect`, and what `rect` takes its colour from outside itself: no texel of the square is
/// more than sqrt 2 times as far from the centre as the rim.
TexelRect outwards(const TexelRect& rect, int size) { return unitedWithScaled(rect, 1.4143, size); }
TexelRect inwards(const TexelRect& rect, int size) { return unitedWithScaled(rect, 0.7071, size); }

SpanGenerator preparedGenerator(const LayerContent& content, const Level& level, const TexelRect& rect, const Image* raster,
                                const JobControl& job)
{
    if (raster)
        return rasterGenerator(std::shared_ptr<const Image>(std::shared_ptr<void>(), raster), {0, 0, level.size, level.size}, level.size);
    return std::visit(
        [&](const auto& layer) -> SpanGenerator {
            if constexpr (requires { paintedRaster(layer, level, rect, job); }) {
                const std::vector<Stroke> strokes = strokesAt(layer, level);
                if (StrokeTiles::canPaint(strokes))
                    return rasterGenerator(std::make_shared<const StrokeTiles>(strokes, level.size, job));
                const TexelRect reads = inwards(rect, level.size);
                return rasterGenerator(std::make_shared<const Image>(paintedRaster(layer, level, reads, job)), reads, level.size);
            } else if constexpr (requires { SpanGenerator(prepare(layer, level)); } &&
                                 std::decay_t<decltype(layer)>::kind.role == LayerRole::Generator)
                return prepare(layer, level);
            else
                return {};
        },
        content);
}

/// What `make` makes of a layer, or of its mask. What is wrong with it is said of that layer, by its number and name.
template <typename Make>
auto naming(const SphereMapDocument& document, size_t index, const char* part, const Make& make)
{
    const Layer& layer = document.layers[index];
    const auto where = [&] {
        return "layers[" + std::to_string(index) + "]" + part + " " +
               inQuotes(layer.name.empty() ? std::string(kindOf(layer.content).title) : layer.name);
    };
    try {
        return make();
    } catch (const FileError& error) {
        throw FileError(where(), error.what());
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(where() + ": " + error.what());
    }
}

SpanAdjustment preparedAdjustment(const LayerContent& content, const Level& level)
{
    return std::visit(
        [&](const auto& layer) -> SpanAdjustment {
            if constexpr (std::decay_t<decltype(layer)>::kind.role == LayerRole::Adjustment)
                return prepare(layer, level);
            else
                return {};
        },
        content);
}

Warp preparedWarp(const LayerContent& content, const Level& level)
{
    return std::visit(
        [&](const auto& layer) -> Warp {
            if constexpr (std::decay_t<decltype(layer)>::kind.role == LayerRole::Warp)
                return prepare(layer, level);
            else
                return {};
        },
        content);
}

/// One visible layer, made ready.
struct Step {
    const Layer* layer = nullptr;
    SpanGenerator generate{};
    SpanAdjustment adjust{};
    SpanGenerator mask{};
};

/// Layers that work point by point, then perhaps one that works on the picture they make.
struct Pass {
    std::vector<size_t> layers{};
    std::optional<size_t> warpLayer{};
    Warp warp{};
    TexelRect rect{}; ///< of the picture before the warp
};

bool takesPart(const Layer& layer, const EvaluateOptions& options)
{
    return layer.visible && layer.opacity > 0.0 && options.level >= layer.firstLevel && options.level <= layer.lastLevel;
}

/// Bottom to top. Rectangles are still empty.
std::vector<Pass> passesOf(const SphereMapDocument& document, const EvaluateOptions& options, const Level& level)
{
    std::vector<Pass> passes(1);
    for (size_t i = options.firstLayer; i < std::min(document.layers.size(), options.endLayer); ++i) {
        const Layer& layer = document.layers[i];
        if (!takesPart(layer, options))
            continue;
        const auto refuseUnknown = [&](const LayerContent& content, const std::string& path) {
            if (!std::holds_alternative<UnknownLayer>(content))
                return false;
            if (options.unknownLayers == UnknownLayers::Refuse)
                throw InvalidArgument("layers[" + std::to_string(i) + "]." + path + "content.kind: " + inQuotes(kindOf(content).name) +
                                      " is no kind of layer that this version knows; hide the layer or update Mirrorball");
            return true;
        };
        if (refuseUnknown(layer.content, "") || (layer.mask && refuseUnknown(layer.mask->content, "mask.")))
            continue;
        if (kindOf(layer.content).role == LayerRole::Warp) {
            passes.back().warpLayer = i;
            passes.back().warp = naming(document, i, "", [&] { return preparedWarp(layer.content, level); });
            passes.emplace_back();
        } else {
            passes.back().layers.push_back(i);
        }
    }
    return passes;
}

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

/// Colours that are not multiplied by their opacity.
MIRRORBALL_VECTOR_CLONES void bound(int count, ColorSpan& colors)
{
    for (int i = 0; i < count; ++i) {
        colors.r[i] = std::min(brightest, colors.r[i]);
        colors.g[i] = std::min(brightest, colors.g[i]);
        colors.b[i] = std::min(brightest, colors.b[i]);
    }
}

/// Colours that are.
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
    alignas(64) float share[spanLength];
    setShare(*step.layer, step.mask, at, colors, share);
    if (step.adjust) {
        colors = result;
        unmultiply(at.count, colors);
        step.adjust(at, colors);
        bound(at.count, colors);
        blendAdjusted(step.layer->blend, at.count, colors, share, result);
    } else {
        step.generate(at, colors);
        if (weigh(at.count, share, colors.a) == 0.0f) // nothing of it here: most of a painted layer, the inside of a ring
            return;
        bound(at.count, colors);
        blend(step.layer->blend, at.count, colors, result);
    }
    boundMultiplied(at.count, result);
}

/// Calls body(span) for the runs of a rectangle's rows, in parallel.
template <typename Body>
void forEachRun(const TexelRect& rect, const Level& level, const JobControl& job, const Body& body)
{
    parallelRows(rect.height(), job, [&](int first, int last) {
        DiscSpan at;
        for (at.row = rect.y0 + first; at.row < rect.y0 + last; ++at.row)
            for (at.column = rect.x0; at.column < rect.x1; at.column += spanLength) {
                at.count = std::min(spanLength, rect.x1 - at.column);
                setPositions(at, level);
                body(at);
            }
    });
}

Image cut(const Image& picture, const TexelRect& given, const TexelRect& wanted)
{
    Image part(wanted.width(), wanted.height(), 4);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(picture.texel(wanted.x0 - given.x0, wanted.y0 - given.y0 + y), 4 * static_cast<size_t>(part.width), part.row(y));
    return part;
}

class Evaluation {
public:
    Evaluation(const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job)
        : m_document(document), m_options(options), m_job(job)
    {
        m_assets = options.assets ? options.assets : std::make_shared<SphereMapAssets>();
        m_level = {.size = options.size,
                   .levelSize = options.levelSize > 0 ? options.levelSize : options.size,
                   .level = options.level,
                   .index = document.index,
                   .folder = document.folder,
                   .assets = m_assets.get()};
    }

    Image run(const TexelRect& region)
    {
        std::vector<Pass> passes = passesOf(m_document, m_options, m_level);
        TexelRect rect = region; // from the top down: what each pass must make
        for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass) {
            if (pass->warpLayer)
                rect = rect.united(pass->warp.needs(inwards(rect, m_level.size)));
            pass->rect = rect;
        }
        Image picture = m_options.below ? cut(*m_options.below, {0, 0, m_level.size, m_level.size}, passes.front().rect) : Image();
        for (size_t p = 0; p < passes.size(); ++p) {
            picture = points(passes[p], std::move(picture));
            if (passes[p].warpLayer)
                picture = warped(passes[p], std::move(picture), passes[p + 1].rect);
        }
        return picture;
    }

private:
    const Image* rasterOf(size_t layer, PaintTarget target) const
    {
        const Image* raster = m_options.raster ? m_options.raster(layer, target) : nullptr;
        if (raster && (raster->width != m_level.size || raster->height != m_level.size || raster->channels != 4))
            throw InvalidArgument("layers[" + std::to_string(layer) + "]: its raster must be " + std::to_string(m_level.size) +
                                  " texels square with four channels");
        return raster;
    }

    SpanGenerator maskOf(size_t i, const TexelRect& rect) const
    {
        const std::optional<Mask>& mask = m_document.layers[i].mask;
        if (!mask)
            return {};
        const Image* raster = rasterOf(i, PaintTarget::Mask);
        return naming(m_document, i, ".mask", [&] { return preparedGenerator(mask->content, m_level, rect, raster, m_job); });
    }

    /// The layers of a pass over the picture of the one before, which is empty at the bottom.
    Image points(const Pass& pass, Image below) const
    {
        std::vector<Step> steps;
        for (const size_t i : pass.layers) {
            const Layer& layer = m_document.layers[i];
            steps.push_back({.layer = &layer, .mask = maskOf(i, pass.rect)});
            if (kindOf(layer.content).role == LayerRole::Adjustment) {
                steps.back().adjust = naming(m_document, i, "", [&] { return preparedAdjustment(layer.content, m_level); });
            } else {
                const Image* raster = rasterOf(i, PaintTarget::Layer);
                steps.back().generate =
                    naming(m_document, i, "", [&] { return preparedGenerator(layer.content, m_level, pass.rect, raster, m_job); });
            }
        }
        if (steps.empty() && !below.empty())
            return below;
        const bool fresh = below.empty();
        if (fresh)
            below = Image(pass.rect.width(), pass.rect.height(), 4);
        forEachRun(pass.rect, m_level, m_job, [&](const DiscSpan& at) {
            ColorSpan colors;
            float* texels = below.texel(at.column - pass.rect.x0, at.row - pass.rect.y0);
            if (fresh) {
                clear(colors, at.count);
            } else {
                read(texels, at.count, colors);
                boundMultiplied(at.count, colors); // between texels a warp's spline overshoots
            }
            for (const Step& step : steps)
                mirrorball::run(step, at, colors);
            write(colors, at.count, texels);
        });
        return below;
    }

    Image warped(const Pass& pass, Image below, const TexelRect& wanted) const
    {
        const Layer& layer = m_document.layers[*pass.warpLayer];
        Image result = pass.warp.apply(below, pass.rect, wanted, m_job);
        if (!layer.mask && layer.opacity >= 1.0 && layer.blend == BlendMode::Normal)
            return result;
        const SpanGenerator mask = maskOf(*pass.warpLayer, wanted);
        Image mixed = pass.rect == wanted ? std::move(below) : cut(below, pass.rect, wanted);
        forEachRun(wanted, m_level, m_job, [&](const DiscSpan& at) {
            ColorSpan colors, backdrop;
            alignas(64) float share[spanLength];
            setShare(layer, mask, at, colors, share);
            read(result.texel(at.column - wanted.x0, at.row - wanted.y0), at.count, colors);
            unmultiply(at.count, colors);
            bound(at.count, colors);
            float* texels = mixed.texel(at.column - wanted.x0, at.row - wanted.y0);
            read(texels, at.count, backdrop);
            blendAdjusted(layer.blend, at.count, colors, share, backdrop);
            boundMultiplied(at.count, backdrop);
            write(backdrop, at.count, texels);
        });
        return mixed;
    }

    const SphereMapDocument& m_document;
    const EvaluateOptions& m_options;
    JobControl m_job;
    std::shared_ptr<SphereMapAssets> m_assets;
    Level m_level;
};

void checkOptions(const EvaluateOptions& options)
{
    if (options.size < 1 || options.size > largestSphereMap)
        throw InvalidArgument("size: must be from 1 to " + std::to_string(largestSphereMap) + " texels; it is " +
                              std::to_string(options.size));
    if (options.levelSize < 0 || options.levelSize > options.size)
        throw InvalidArgument("levelSize: must be from 0 to the size, " + std::to_string(options.size) + "; it is " +
                              std::to_string(options.levelSize));
    if (options.level < 0 || options.level > deepestLevel)
        throw InvalidArgument("level: must be from 0 to " + std::to_string(deepestLevel) + "; it is " + std::to_string(options.level));
    if (options.below && (options.below->width != options.size || options.below->height != options.size || options.below->channels != 4))
        throw InvalidArgument("below: must be " + std::to_string(options.size) + " texels square with four channels");
    const TexelRect all{0, 0, options.size, options.size};
    if (options.region && (options.region->empty() || options.region->intersected(all) != *options.region))
        throw InvalidArgument("region: must hold texels, and lie within the map of " + std::to_string(options.size) + " texels");
}

} // namespace

Image evaluate(const SphereMapDocument& document, const EvaluateOptions& options, const JobControl& job)
{
    validate(document);
    checkOptions(options);
    return Evaluation(document, options, job).run(options.region.value_or(TexelRect{0, 0, options.size, options.size}));
}

TexelRect touchedBy(const SphereMapDocument& document, size_t layer, const TexelRect& touched, const EvaluateOptions& options)
{
    checkOptions(options);
    SphereMapAssets none;
    const Level level{.size = options.size,
                      .levelSize = options.levelSize > 0 ? options.levelSize : options.size,
                      .level = options.level,
                      .index = document.index,
                      .assets = &none};
    TexelRect rect = outwards(touched.intersected({0, 0, options.size, options.size}), options.size);
    for (size_t i = layer + 1; i < document.layers.size() && !rect.empty(); ++i)
        if (takesPart(document.layers[i], options) && kindOf(document.layers[i].content).role == LayerRole::Warp)
            rect = rect.united(outwards(preparedWarp(document.layers[i].content, level).reaches(rect), options.size));
    return rect;
}

} // namespace mirrorball
