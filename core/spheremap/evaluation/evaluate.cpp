#include "evaluate.h"

#include "compositing.h"

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

/// A rectangle and what it becomes when it is scaled about the center of the map, a little wider; itself where it does not reach the rim.
TexelRect unitedWithScaled(const TexelRect& rect, double scale, int size)
{
    const double c = 0.5 * size, x = std::max(c - rect.x0, rect.x1 - c), y = std::max(c - rect.y0, rect.y1 - c);
    if (rect.empty() || x * x + y * y < (c - 4.0) * (c - 4.0))
        return rect;
    const auto low = [&](int v) { return static_cast<int>(std::floor(c + (v - c) * scale)) - 3; };
    const auto high = [&](int v) { return static_cast<int>(std::ceil(c + (v - c) * scale)) + 3; };
    return rect.united(TexelRect{low(rect.x0), low(rect.y0), high(rect.x1), high(rect.y1)}).intersected({0, 0, size, size});
}

/// What outside the disc takes its color from `rect`, and what `rect` takes its color from outside itself: no texel of the square is
/// more than sqrt 2 times as far from the center as the rim.
TexelRect outwards(const TexelRect& rect, int size) { return unitedWithScaled(rect, 1.4143, size); }
TexelRect inwards(const TexelRect& rect, int size) { return unitedWithScaled(rect, 0.7071, size); }

SpanGenerator preparedGenerator(const LayerContent& content, const Level& level, const TexelRect& rect, const Image* raster,
                                const JobControl& job)
{
    if (raster)
        return rasterGenerator(std::shared_ptr<const Image>(std::shared_ptr<void>(), raster), {0, 0, level.size, level.size}, level.size);
    return std::visit(
        [&]<typename Kind>(const Kind& layer) -> SpanGenerator {
            if constexpr (requires { paintedRaster(layer, level, rect, job); }) {
                const std::vector<Stroke> strokes = strokesAt(layer, level);
                if (StrokeTiles::canPaint(strokes))
                    return rasterGenerator(std::make_shared<const StrokeTiles>(strokes, level.size, job));
                const TexelRect reads = inwards(rect, level.size);
                return rasterGenerator(std::make_shared<const Image>(paintedRaster(layer, level, reads, job)), reads, level.size);
            } else if constexpr (Kind::kind.role == LayerRole::Generator && !std::is_same_v<Kind, UnknownLayer>)
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

    /// What one layer, or its mask, gives by itself.
    Image drawn(size_t i, PaintTarget target) const
    {
        const TexelRect whole{0, 0, m_level.size, m_level.size};
        const SpanGenerator generate = generatorOf(i, target, whole);
        Image picture(m_level.size, m_level.size, 4);
        compositing::forEachRun(whole, m_level, m_job, [&](const DiscSpan& at) {
            ColorSpan colors;
            generate(at, colors);
            compositing::write(colors, at.count, picture.texel(at.column, at.row));
        });
        return picture;
    }

private:
    /// The picture of a layer that is at hand; null where there is none.
    const Image* atHand(const std::function<const Image*(size_t, PaintTarget)>& pictures, size_t layer, PaintTarget target) const
    {
        const Image* picture = pictures ? pictures(layer, target) : nullptr;
        if (picture && (picture->width != m_level.size || picture->height != m_level.size || picture->channels != 4))
            throw InvalidArgument("layers[" + std::to_string(layer) + "]: its raster must be " + std::to_string(m_level.size) +
                                  " texels square with four channels");
        return picture;
    }

    SpanGenerator generatorOf(size_t i, PaintTarget target, const TexelRect& rect) const
    {
        const Layer& layer = m_document.layers[i];
        const bool isMask = target == PaintTarget::Mask;
        const LayerContent& content = isMask ? layer.mask->content : layer.content;
        if (const Image* drawn = atHand(m_options.drawn, i, target))
            return [drawn](const DiscSpan& at, ColorSpan& out) { compositing::read(drawn->texel(at.column, at.row), at.count, out); };
        const Image* raster = atHand(m_options.raster, i, target);
        return naming(m_document, i, isMask ? ".mask" : "", [&] { return preparedGenerator(content, m_level, rect, raster, m_job); });
    }

    SpanGenerator maskOf(size_t i, const TexelRect& rect) const
    {
        return m_document.layers[i].mask ? generatorOf(i, PaintTarget::Mask, rect) : SpanGenerator();
    }

    /// The layers of a pass over the picture of the one before, which is empty at the bottom.
    Image points(const Pass& pass, Image below) const
    {
        std::vector<compositing::Step> steps;
        for (const size_t i : pass.layers) {
            const Layer& layer = m_document.layers[i];
            steps.push_back({.layer = &layer, .mask = maskOf(i, pass.rect)});
            if (kindOf(layer.content).role == LayerRole::Adjustment) {
                steps.back().adjust = naming(m_document, i, "", [&] { return preparedAdjustment(layer.content, m_level); });
            } else {
                steps.back().generate = generatorOf(i, PaintTarget::Layer, pass.rect);
            }
        }
        if (steps.empty() && !below.empty())
            return below;
        const bool fresh = below.empty();
        if (fresh)
            below = Image(pass.rect.width(), pass.rect.height(), 4);
        compositing::forEachRun(pass.rect, m_level, m_job, [&](const DiscSpan& at) {
            ColorSpan colors;
            float* texels = below.texel(at.column - pass.rect.x0, at.row - pass.rect.y0);
            if (fresh) {
                compositing::clear(colors, at.count);
            } else {
                compositing::read(texels, at.count, colors);
                compositing::boundMultiplied(at.count, colors); // between texels a warp's spline overshoots
            }
            for (const compositing::Step& step : steps)
                compositing::run(step, at, colors);
            compositing::write(colors, at.count, texels);
        });
        return below;
    }

    Image warped(const Pass& pass, Image below, const TexelRect& wanted) const
    {
        const Layer& layer = m_document.layers[*pass.warpLayer];
        Image result = pass.warp.apply(below, pass.rect, wanted, m_job);
        if (!layer.mask && layer.opacity >= 1.0 && layer.blend == BlendMode::Normal)
            return result;
        const compositing::Step step{.layer = &layer, .mask = maskOf(*pass.warpLayer, wanted)};
        Image mixed = pass.rect == wanted ? std::move(below) : cut(below, pass.rect, wanted);
        compositing::forEachRun(wanted, m_level, m_job, [&](const DiscSpan& at) {
            ColorSpan colors, backdrop;
            compositing::read(result.texel(at.column - wanted.x0, at.row - wanted.y0), at.count, colors);
            float* texels = mixed.texel(at.column - wanted.x0, at.row - wanted.y0);
            compositing::read(texels, at.count, backdrop);
            compositing::runMoved(step, at, colors, backdrop);
            compositing::write(backdrop, at.count, texels);
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
    if (options.levelSize < 0 || options.levelSize > largestSphereMap)
        throw InvalidArgument("levelSize: must be from 0 to " + std::to_string(largestSphereMap) + " texels; it is " +
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

Image drawnLayer(const SphereMapDocument& document, size_t layer, PaintTarget target, const EvaluateOptions& options, const JobControl& job)
{
    validate(document);
    checkOptions(options);
    const auto makesColors = [](const LayerContent& content) {
        return kindOf(content).role == LayerRole::Generator && !std::holds_alternative<UnknownLayer>(content);
    };
    const bool isMask = target == PaintTarget::Mask;
    if (layer >= document.layers.size() || (isMask && !document.layers[layer].mask) ||
        !makesColors(isMask ? document.layers[layer].mask->content : document.layers[layer].content))
        throw InvalidArgument("layers[" + std::to_string(layer) + "]: makes no colors of its own");
    return Evaluation(document, options, job).drawn(layer, target);
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
