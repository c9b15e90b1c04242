#include "sphere_map_editor.h"

#include "live_sphere_map.h"

#include "core/spheremap/document/sphere_map_file.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace mirrorball::studio {

namespace {
constexpr int paintingSize = 1024; ///< texels: what a map is painted at unless the scene asks for more

/// The strokes of a layer or of its mask; null where there are none.
template <typename Map>
auto strokesOf(Map& map, size_t layer, PaintTarget target)
    -> std::conditional_t<std::is_const_v<Map>, const std::vector<Stroke>, std::vector<Stroke>>*
{
    if (layer >= map.layers.size() || (target == PaintTarget::Mask && !map.layers[layer].mask))
        return nullptr;
    auto& content = target == PaintTarget::Mask ? map.layers[layer].mask->content : map.layers[layer].content;
    auto* paint = std::get_if<PaintLayer>(&content);
    return paint ? &paint->strokes : nullptr;
}
} // namespace

SphereMapEditor::SphereMapEditor(Document& document, LiveScene& live, QObject* parent) : QObject(parent), m_document(document), m_live(live)
{
    connect(&m_document, &Document::changed, this, &SphereMapEditor::follow);
    connect(&m_document, &Document::dragFinished, this, [this] {
        if (m_hasSkipped)
            request();
    });
    connect(&m_live, &LiveScene::updated, this, &SphereMapEditor::followLive);
    connect(&m_live, &LiveScene::failed, this, [this] {
        if (m_awaitsLive)
            request();
    });
    connect(&m_runner, &JobRunner::failed, this, &SphereMapEditor::problemChanged);
    follow();
}

SphereMapEditor::~SphereMapEditor() = default;

void SphereMapEditor::follow()
{
    const std::shared_ptr<const SphereMapDocument>& now = m_document.scene().material.sphereMap.document.document;
    const int size = m_document.scene().material.sphereMap.size;
    if (now == m_map && size == m_size)
        return;
    if (size != m_size) {
        m_size = size;
        m_cache = std::make_shared<SphereMapCache>(EvaluateOptions{.size = size, .unknownLayers = UnknownLayers::Skip});
        m_levelsCache.reset();
        if (m_onlyLevel.value_or(0) >= levelCount())
            showOnly(std::nullopt);
    }
    m_map = now;
    if (m_recorder && !(m_map && strokesOf(*m_map, m_recorderLayer, m_recorderTarget))) // undone from under the pen
        m_recorder.reset();
    const int before = m_chosen, count = m_map ? static_cast<int>(m_map->layers.size()) : 0;
    m_chosen = count == 0 ? -1 : m_chosen < 0 ? count - 1 : std::min(m_chosen, count - 1);
    m_awaitsLive = m_map && m_document.isDragging() && !m_recorder && liveSphereMap(m_live, m_size);
    if (!m_map)
        showOnly(std::nullopt);
    m_hasSkipped = m_hasSkipped || m_awaitsLive;
    emit mapChanged();
    if (m_chosen != before)
        emit chosenChanged();
    if (!m_awaitsLive)
        request();
}

/// The same map need not be evaluated twice with each movement of a slider.
void SphereMapEditor::followLive()
{
    if (!m_awaitsLive)
        return;
    const SphereMapChain chain = liveSphereMap(m_live, m_size);
    if (!chain) { // it could not be made, or is shown no more
        request();
        return;
    }
    m_awaitsLive = m_live.made()->plan.sphereMaps.front().document.document != m_map; // a later one follows
    m_runner.start(
        [chain, size = m_size, only = m_onlyLevel.value_or(0)](const JobControl& job) {
            const Image& picture = chain->levels.front();
            Patch patch{
                .rect = {0, 0, picture.width, picture.width}, .size = picture.width, .image = picture, .screen = onScreen(picture, job)};
            if (only > 0)
                patch.only = levelOf(*chain, size, only);
            return patch;
        },
        [this](Patch patch) { show(std::move(patch)); }, Running::Finish);
}

/// The worker brings its cache to the document with the stroke at hand; only what changed comes back.
void SphereMapEditor::request()
{
    m_awaitsLive = m_hasSkipped = false;
    if (!m_map)
        return;
    const std::vector<Stroke> pending = m_recorder ? m_recorder->strokes() : std::vector<Stroke>();
    // Hand-made coarser levels are followed while a stroke is drawn; when it is done, the scene's maps hold them. One that is shown alone
    // is followed always.
    const int only = m_onlyLevel.value_or(0);
    const bool followsLevels = (!pending.empty() || only > 0) && hasAuthoredLevels(*m_map);
    if (followsLevels && !m_levelsCache)
        m_levelsCache = std::make_shared<LevelsCache>(EvaluateOptions{.size = m_size, .unknownLayers = UnknownLayers::Skip});
    m_runner.start(
        [cache = m_cache, levels = followsLevels ? m_levelsCache : nullptr, map = m_map, pending, layer = m_recorderLayer,
         target = m_recorderTarget, only, whole = m_picture.width != m_size](const JobControl& job) {
            const SphereMapDocument* shown = map.get();
            SphereMapDocument painted;
            if (!pending.empty()) {
                painted = *map;
                if (std::vector<Stroke>* strokes = strokesOf(painted, layer, target))
                    strokes->insert(strokes->end(), pending.begin(), pending.end());
                shown = &painted;
            }
            Patch patch{.rect = cache->update(*shown, job), .size = cache->size()};
            if (whole) // what is shown has fewer texels: it is of a drag
                patch.rect = {0, 0, patch.size, patch.size};
            if (levels)
                patch.levels = levels->update(*shown, job);
            else if (only > 0)
                patch.only = plainChain(cache->image(), job)[static_cast<size_t>(only)];
            patch.image = Image(std::max(0, patch.rect.width()), std::max(0, patch.rect.height()), 4);
            for (int y = 0; y < patch.image.height; ++y)
                std::copy_n(cache->image().texel(patch.rect.x0, patch.rect.y0 + y), static_cast<size_t>(patch.image.width) * 4,
                            patch.image.row(y));
            patch.screen = onScreen(patch.image, job);
            return patch;
        },
        [this](Patch patch) {
            show(std::move(patch));
            emit problemChanged({});
        },
        Running::Finish);
}

void SphereMapEditor::show(Patch patch)
{
    const auto put = [](const Image& part, const TexelRect& rect, int size, Image& picture) {
        if (picture.width != size)
            picture = Image(size, size, 4);
        for (int y = 0; y < part.height; ++y)
            std::copy_n(part.row(y), static_cast<size_t>(part.width) * 4, picture.texel(rect.x0, rect.y0 + y));
    };
    if (!patch.levels.empty()) {
        std::vector<TexelRect> touched;
        for (const LevelPatch& level : patch.levels) {
            const auto index = static_cast<size_t>(level.level - 1);
            m_coarser.resize(std::max(m_coarser.size(), index + 1));
            touched.resize(std::max(touched.size(), index + 1));
            put(level.texels, level.rect, patch.size >> level.level, m_coarser[index]);
            touched[index] = level.rect;
        }
        emit levelsChanged(touched);
    }
    if (patch.rect.width() == patch.size && patch.rect.height() == patch.size) {
        m_picture = std::move(patch.image);
    } else if (m_picture.width != patch.size) { // a part, or none, of what is not there: a coarse one came in between
        request();
        return;
    } else if (!patch.rect.empty()) {
        put(patch.image, patch.rect, patch.size, m_picture);
    }
    if (!patch.rect.empty()) {
        m_screen.put(patch.screen, patch.rect, patch.size);
        emit pictureChanged(patch.rect);
    }
    showLevel(std::move(patch.only));
}

void SphereMapEditor::setMap(const QString& label, const SphereMapDocument& map)
{
    m_document.edit(label, {}, [&](Scene& scene) {
        SphereMapDocument own = movedTo(map, scene.folder);
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(own));
        scene.material.sphereMap.source.clear();
        scene.material.sphereMap.size = std::max(scene.material.sphereMap.size, paintingSize);
    });
    choose(m_map ? static_cast<int>(m_map->layers.size()) - 1 : -1);
}

void SphereMapEditor::edit(const QString& label, const QString& mergeKey, const std::function<void(SphereMapDocument&)>& change)
{
    if (!m_map)
        return;
    m_document.edit(label, mergeKey, [&](Scene& scene) {
        SphereMapDocument changed = *scene.material.sphereMap.document.document;
        change(changed);
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(changed));
    });
}

void SphereMapEditor::choose(int layer)
{
    const int count = m_map ? static_cast<int>(m_map->layers.size()) : 0;
    const int wanted = count == 0 ? -1 : std::clamp(layer, 0, count - 1);
    if (wanted == m_chosen)
        return;
    finishEdit();
    m_chosen = wanted;
    emit chosenChanged();
}

void SphereMapEditor::chooseLight(int light)
{
    if (light == m_light)
        return;
    m_light = light;
    emit lightChanged();
}

const Layer* SphereMapEditor::chosenLayer() const
{
    return m_map && m_chosen >= 0 ? &m_map->layers[static_cast<size_t>(m_chosen)] : nullptr;
}

void SphereMapEditor::editLayer(const QString& label, const QString& mergeKey, const std::function<void(Layer&)>& change)
{
    if (m_chosen < 0)
        return;
    const QString key = mergeKey.isEmpty() ? QString() : QStringLiteral("sphere_map.%1.%2").arg(m_chosen).arg(mergeKey);
    edit(label, key, [&](SphereMapDocument& map) { change(map.layers[static_cast<size_t>(m_chosen)]); });
}

void SphereMapEditor::addLayer(const Layer& layer)
{
    const int at = m_chosen + 1;
    edit(tr("Add layer"), {}, [&](SphereMapDocument& map) { map.layers.insert(map.layers.begin() + at, layer); });
    choose(at);
}

void SphereMapEditor::duplicateChosen()
{
    if (const Layer* layer = chosenLayer()) {
        const Layer copy = *layer;
        const int at = m_chosen + 1;
        edit(tr("Duplicate layer"), {}, [&](SphereMapDocument& map) { map.layers.insert(map.layers.begin() + at, copy); });
        choose(at);
    }
}

void SphereMapEditor::removeChosen()
{
    if (m_chosen < 0)
        return;
    edit(tr("Delete layer"), {}, [&](SphereMapDocument& map) { map.layers.erase(map.layers.begin() + m_chosen); });
}

void SphereMapEditor::moveLayer(int from, int to)
{
    const int count = m_map ? static_cast<int>(m_map->layers.size()) : 0;
    if (from == to || from < 0 || to < 0 || from >= count || to >= count)
        return;
    edit(tr("Move layer"), {}, [&](SphereMapDocument& map) {
        Layer layer = std::move(map.layers[static_cast<size_t>(from)]);
        map.layers.erase(map.layers.begin() + from);
        map.layers.insert(map.layers.begin() + to, std::move(layer));
    });
    m_chosen = -1;
    choose(to);
}

std::optional<PaintTarget> SphereMapEditor::paintTarget() const
{
    const Layer* layer = chosenLayer();
    if (!layer)
        return std::nullopt;
    const bool isPaint = std::holds_alternative<PaintLayer>(layer->content);
    if (layer->mask && std::holds_alternative<PaintLayer>(layer->mask->content) && (m_paintsMask || !isPaint))
        return PaintTarget::Mask;
    return isPaint ? std::optional(PaintTarget::Layer) : std::nullopt;
}

void SphereMapEditor::setPaintsMask(bool on)
{
    if (on == m_paintsMask)
        return;
    m_paintsMask = on;
    emit toolChanged();
}

QString SphereMapEditor::paintingProblem() const
{
    if (m_map && m_onlyLevel)
        return {}; // a layer of the level is found or made
    const Layer* layer = chosenLayer();
    if (!layer)
        return tr("Add a paint layer to paint on");
    if (!paintTarget())
        return tr("Choose a paint layer, or add one, to paint");
    if (!layer->visible)
        return tr("The chosen layer is hidden; show it to paint on it");
    return {};
}

void SphereMapEditor::beginStroke(const StrokePoint& point, PenEnd end, double leap)
{
    if (!canPaint())
        return;
    if (m_onlyLevel)
        prepareLevelLayer();
    Brush brush = m_brush;
    brush.mode = end == PenEnd::Eraser || m_tool == PaintTool::Erase ? BrushMode::Erase
                 : m_tool == PaintTool::Smudge                       ? BrushMode::Smudge
                                                                     : BrushMode::Paint;
    m_recorder.emplace(brush, m_symmetry, leap);
    m_recorderLayer = static_cast<size_t>(m_chosen);
    m_recorderTarget = *paintTarget();
    moveStroke(point);
}

void SphereMapEditor::moveStroke(const StrokePoint& point)
{
    if (!m_recorder)
        return;
    m_recorder->add(point);
    request();
}

void SphereMapEditor::liftStroke()
{
    if (m_recorder)
        m_recorder->lift();
}

void SphereMapEditor::endStroke()
{
    if (!m_recorder)
        return;
    m_recorder->finish();
    const std::vector<Stroke> strokes = m_recorder->strokes();
    const size_t layer = m_recorderLayer;
    const PaintTarget target = m_recorderTarget;
    m_recorder.reset();
    if (strokes.empty())
        return;
    const BrushMode mode = strokes.front().brush.mode;
    const QString label = mode == BrushMode::Erase ? tr("Erase") : mode == BrushMode::Smudge ? tr("Smudge") : tr("Paint");
    const auto change = [layer, target](Scene& scene, const std::function<void(std::vector<Stroke>&)>& step) {
        SphereMapDocument map = *scene.material.sphereMap.document.document;
        if (std::vector<Stroke>* all = strokesOf(map, layer, target))
            step(*all);
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(map));
    };
    m_document.editReversibly(
        label,
        [change, strokes](Scene& scene) {
            change(scene, [&](std::vector<Stroke>& all) { all.insert(all.end(), strokes.begin(), strokes.end()); });
        },
        [change, count = strokes.size()](Scene& scene) {
            change(scene, [&](std::vector<Stroke>& all) { all.resize(all.size() - count); });
        });
    request(); // should the edit have been refused
}

void SphereMapEditor::cancelStroke()
{
    if (!m_recorder)
        return;
    m_recorder.reset();
    request();
}

} // namespace mirrorball::studio
