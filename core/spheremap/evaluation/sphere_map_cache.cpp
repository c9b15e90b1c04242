#include "sphere_map_cache.h"

#include <algorithm>

namespace mirrorball {

namespace {

/// What of the picture is different between two states of a layer.
struct Change {
    bool isOther = false; ///< more than strokes
    std::vector<PaintTarget> strokes{};
    std::vector<PaintTarget> drawn{}; ///< what drawnLayer() gives
    bool any() const { return isOther || !strokes.empty(); }
};

/// Pictures of layers are kept as far as they stay near the processor: larger ones take as long to read as to make.
constexpr int largestDrawn = 512;
constexpr size_t mostDrawn = 12;

const PaintLayer* painted(const Layer& layer, PaintTarget target)
{
    if (target == PaintTarget::Layer)
        return std::get_if<PaintLayer>(&layer.content);
    return layer.mask ? std::get_if<PaintLayer>(&layer.mask->content) : nullptr;
}

bool sameMaskButContent(const Layer& a, const Layer& b)
{
    if (a.mask.has_value() != b.mask.has_value())
        return false;
    return !a.mask || (a.mask->channel == b.mask->channel && a.mask->invert == b.mask->invert && a.mask->unknown == b.mask->unknown);
}

Change changeOf(const Layer& a, const Layer& b)
{
    Change change{.isOther = a.visible != b.visible || a.opacity != b.opacity || a.blend != b.blend || a.firstLevel != b.firstLevel ||
                             a.lastLevel != b.lastLevel || !sameMaskButContent(a, b)};
    const auto compare = [&](PaintTarget target, const LayerContent& from, const LayerContent& to) {
        if (from != to)
            change.drawn.push_back(target);
        const PaintLayer *strokesA = painted(a, target), *strokesB = painted(b, target);
        if (!strokesA || !strokesB || !sameButStrokes(*strokesA, *strokesB))
            change.isOther = change.isOther || from != to;
        else if (strokesA->strokes != strokesB->strokes)
            change.strokes.push_back(target);
    };
    compare(PaintTarget::Layer, a.content, b.content);
    if (a.mask && b.mask)
        compare(PaintTarget::Mask, a.mask->content, b.mask->content);
    else if (a.mask || b.mask)
        change.drawn.push_back(PaintTarget::Mask);
    return change;
}

TexelRect whole(int size) { return {0, 0, size, size}; }

/// Then a stroke reads or reaches more than it touches, and what lies below it is worth keeping.
bool holdsWarp(const SphereMapDocument& document)
{
    return std::any_of(document.layers.begin(), document.layers.end(),
                       [](const Layer& layer) { return layer.visible && kindOf(layer.content).role == LayerRole::Warp; });
}

} // namespace

SphereMapCache::SphereMapCache(const EvaluateOptions& options) : m_options(options)
{
    m_options.region.reset();
    m_options.raster = {};
    m_options.drawn = {};
    m_options.firstLayer = 0;
    m_options.endLayer = SIZE_MAX;
    m_options.below = nullptr;
    if (!m_options.assets)
        m_options.assets = std::make_shared<SphereMapAssets>();
    evaluate({}, {.size = m_options.size,
                  .level = m_options.level,
                  .levelSize = m_options.levelSize,
                  .region = TexelRect{0, 0, 1, 1}}); // checks the options
}

TexelRect SphereMapCache::update(const SphereMapDocument& document, const JobControl& job)
{
    try {
        validate(document);
        const TexelRect dirty = advance(document, job);
        m_document = document;
        return dirty;
    } catch (...) {
        *this = SphereMapCache(m_options);
        throw;
    }
}

TexelRect SphereMapCache::advance(const SphereMapDocument& document, const JobControl& job)
{
    const size_t count = document.layers.size();
    const bool sameFrame = m_document && m_document->layers.size() == count && m_document->index == document.index &&
                           m_document->folder == document.folder && !m_image.empty();
    if (!sameFrame) {
        m_belowLayer = 0;
        m_lastChanged = SIZE_MAX;
        m_drawn.clear();
        keepCanvases(document, job);
        m_image = Image(m_options.size, m_options.size, 4);
        evaluateInto(document, whole(m_options.size), job);
        return whole(m_options.size);
    }
    size_t lowest = SIZE_MAX;
    std::vector<Painted> strokes, redrawn;
    bool onlyStrokes = true;
    for (size_t i = 0; i < count; ++i) {
        const Change change = changeOf(m_document->layers[i], document.layers[i]);
        if (change.any())
            lowest = std::min(lowest, i);
        for (const PaintTarget target : change.strokes)
            strokes.emplace_back(i, target);
        for (const PaintTarget target : change.drawn) {
            m_drawn.erase({i, target});
            redrawn.emplace_back(i, target);
        }
        onlyStrokes = onlyStrokes && !change.isOther;
    }
    if (lowest == SIZE_MAX)
        return {};
    if (m_belowLayer > lowest)
        m_belowLayer = 0;
    const bool isDragged = m_lastChanged == lowest;
    if (lowest > 0 && m_belowLayer != lowest && isDragged && (!onlyStrokes || holdsWarp(document)))
        keepBelow(document, lowest, job);
    m_lastChanged = lowest;
    if (!onlyStrokes) {
        keepCanvases(document, job);
        if (isDragged)
            keepDrawn(document, lowest, redrawn, job);
        evaluateInto(document, whole(m_options.size), job);
        return whole(m_options.size);
    }

    TexelRect dirty;
    for (const Painted& which : strokes) {
        const auto canvas = m_canvases.find(which);
        if (canvas == m_canvases.end())
            continue; // hidden
        const TexelRect touched = canvas->second.update(
            strokesAt(*painted(document.layers[which.first], which.second), {.size = m_options.size, .levelSize = levelSize()}), job);
        dirty = dirty.united(touchedBy(document, which.first, touched, m_options));
    }
    for (auto& [which, canvas] : m_canvases)
        if (std::find(strokes.begin(), strokes.end(), which) == strokes.end())
            canvas.settle();
    if (!dirty.empty())
        evaluateInto(document, dirty, job);
    return dirty;
}

/// A canvas for every visible paint layer and painted mask, taken over from whichever had the same strokes.
void SphereMapCache::keepCanvases(const SphereMapDocument& document, const JobControl& job)
{
    std::map<Painted, StrokeCanvas> old = std::move(m_canvases);
    m_canvases.clear();
    for (size_t i = 0; i < document.layers.size(); ++i)
        for (const PaintTarget target : {PaintTarget::Layer, PaintTarget::Mask}) {
            const PaintLayer* paint = painted(document.layers[i], target);
            if (!paint || !document.layers[i].visible)
                continue;
            const Painted which(i, target);
            const std::vector<Stroke> strokes = strokesAt(*paint, {.size = m_options.size, .levelSize = levelSize()});
            auto found = std::find_if(old.begin(), old.end(), [&](const auto& entry) { return entry.second.strokes() == strokes; });
            if (found == old.end())
                found = old.find(which);
            if (found == old.end()) {
                m_canvases.emplace(which, StrokeCanvas(m_options.size)).first->second.update(strokes, job);
            } else {
                auto node = old.extract(found);
                node.key() = which;
                m_canvases.insert(std::move(node)).position->second.update(strokes, job);
            }
        }
}

/// To evaluate with the canvases, and over the layers that are kept.
EvaluateOptions SphereMapCache::withWhatIsKept() const
{
    EvaluateOptions options = m_options;
    options.raster = [this](size_t layer, PaintTarget target) -> const Image* {
        const auto canvas = m_canvases.find({layer, target});
        return canvas == m_canvases.end() ? nullptr : &canvas->second.image();
    };
    options.drawn = [this](size_t layer, PaintTarget target) -> const Image* {
        const auto drawn = m_drawn.find({layer, target});
        return drawn == m_drawn.end() ? nullptr : &drawn->second;
    };
    if (m_belowLayer > 0) {
        options.firstLayer = m_belowLayer;
        options.below = &m_below;
    }
    return options;
}

void SphereMapCache::keepBelow(const SphereMapDocument& document, size_t layer, const JobControl& job)
{
    EvaluateOptions options = withWhatIsKept();
    options.endLayer = layer;
    m_below = evaluate(document, options, job);
    m_belowLayer = layer;
}

/// From the dragged layer up, what layers give by themselves: bottom to top, as far as there is room, but for what changes with every
/// update. What a canvas holds as well: outside the disc its texels are read between four others, which takes longer than all inside.
void SphereMapCache::keepDrawn(const SphereMapDocument& document, size_t lowest, const std::vector<Painted>& redrawn, const JobControl& job)
{
    std::erase_if(m_drawn, [&](const auto& entry) { return entry.first.first < lowest; });
    if (m_options.size > largestDrawn)
        return;
    const EvaluateOptions options = withWhatIsKept();
    for (size_t i = lowest; i < document.layers.size(); ++i) {
        const Layer& layer = document.layers[i];
        for (const PaintTarget target : {PaintTarget::Layer, PaintTarget::Mask}) {
            const Painted which(i, target);
            if (!layer.visible || (target == PaintTarget::Mask && !layer.mask) || m_drawn.contains(which) ||
                std::find(redrawn.begin(), redrawn.end(), which) != redrawn.end())
                continue;
            const LayerContent& content = target == PaintTarget::Mask ? layer.mask->content : layer.content;
            if (kindOf(content).role != LayerRole::Generator || std::holds_alternative<UnknownLayer>(content))
                continue;
            if (m_drawn.size() >= mostDrawn)
                return;
            m_drawn.emplace(which, drawnLayer(document, i, target, options, job));
        }
    }
}

void SphereMapCache::evaluateInto(const SphereMapDocument& document, const TexelRect& rect, const JobControl& job)
{
    EvaluateOptions options = withWhatIsKept();
    if (rect == whole(m_options.size)) {
        m_image = evaluate(document, options, job);
        return;
    }
    options.region = rect;
    const Image part = evaluate(document, options, job);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(part.row(y), static_cast<size_t>(part.width) * 4, m_image.texel(rect.x0, rect.y0 + y));
}

} // namespace mirrorball
