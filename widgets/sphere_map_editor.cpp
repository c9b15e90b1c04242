#include "sphere_map_editor.h"

#include "core/spheremap/sphere_map_file.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {
constexpr int paintingSize = 1024; ///< texels: what a map is painted at unless the scene asks for more
} // namespace

SphereMapEditor::SphereMapEditor(Document& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    connect(&m_document, &Document::changed, this, &SphereMapEditor::follow);
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
    }
    m_map = now;
    const auto isPaintLayer = [this](size_t layer) {
        return m_map && layer < m_map->layers.size() && std::holds_alternative<PaintLayer>(m_map->layers[layer].content);
    };
    if (m_recorder && !isPaintLayer(m_recorderLayer)) // undone from under the pen
        m_recorder.reset();
    const int before = m_chosen, count = m_map ? static_cast<int>(m_map->layers.size()) : 0;
    m_chosen = count == 0 ? -1 : m_chosen < 0 ? count - 1 : std::min(m_chosen, count - 1);
    emit mapChanged();
    if (m_chosen != before)
        emit chosenChanged();
    request();
}

/// The worker brings its cache to the document with the stroke at hand; only what changed comes back.
void SphereMapEditor::request()
{
    if (!m_map)
        return;
    const std::vector<Stroke> pending = m_recorder ? m_recorder->strokes() : std::vector<Stroke>();
    m_runner.start(
        [cache = m_cache, map = m_map, pending, layer = m_recorderLayer](const JobControl& job) {
            const auto update = [&] {
                if (pending.empty())
                    return cache->update(*map, job);
                SphereMapDocument painted = *map;
                std::vector<Stroke>& strokes = std::get<PaintLayer>(painted.layers[layer].content).strokes;
                strokes.insert(strokes.end(), pending.begin(), pending.end());
                return cache->update(painted, job);
            };
            Patch patch{.rect = update(), .size = cache->size()};
            patch.image = Image(std::max(0, patch.rect.width()), std::max(0, patch.rect.height()), 4);
            for (int y = 0; y < patch.image.height; ++y)
                std::copy_n(cache->image().texel(patch.rect.x0, patch.rect.y0 + y), static_cast<size_t>(patch.image.width) * 4,
                            patch.image.row(y));
            return patch;
        },
        [this](const Patch& patch) {
            if (!patch.rect.empty()) {
                if (m_picture.width != patch.size)
                    m_picture = Image(patch.size, patch.size, 4);
                for (int y = 0; y < patch.image.height; ++y)
                    std::copy_n(patch.image.row(y), static_cast<size_t>(patch.image.width) * 4,
                                m_picture.texel(patch.rect.x0, patch.rect.y0 + y));
                emit pictureChanged(patch.rect);
            }
            emit problemChanged({});
        },
        Running::Finish);
}

void SphereMapEditor::setMap(const QString& label, const SphereMapDocument& map)
{
    m_document.edit(label, {}, [&](Scene& scene) {
        SphereMapDocument own = movedTo(map, scene.folder);
        scene.material.sphereMap.document.document = std::make_shared<const SphereMapDocument>(std::move(own));
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

void SphereMapEditor::setBrush(const Brush& brush)
{
    if (brush == m_brush)
        return;
    m_brush = brush;
    emit brushChanged();
}

void SphereMapEditor::setSymmetry(const Symmetry& symmetry)
{
    if (symmetry == m_symmetry)
        return;
    m_symmetry = symmetry;
    emit brushChanged();
}

void SphereMapEditor::setTool(PaintTool tool)
{
    if (tool == m_tool)
        return;
    m_tool = tool;
    emit toolChanged();
}

void SphereMapEditor::setPaintsOnModel(bool on)
{
    if (on == m_paintsOnModel)
        return;
    m_paintsOnModel = on;
    emit toolChanged();
}

QString SphereMapEditor::paintingProblem() const
{
    const Layer* layer = chosenLayer();
    if (!layer)
        return tr("Add a paint layer to paint on");
    if (!std::holds_alternative<PaintLayer>(layer->content))
        return tr("Choose a paint layer, or add one, to paint");
    if (!layer->visible)
        return tr("The chosen layer is hidden; show it to paint on it");
    return {};
}

void SphereMapEditor::beginStroke(const StrokePoint& point, PenEnd end, double leap)
{
    if (!canPaint())
        return;
    Brush brush = m_brush;
    brush.mode = end == PenEnd::Eraser || m_tool == PaintTool::Erase ? BrushMode::Erase
                 : m_tool == PaintTool::Smudge                       ? BrushMode::Smudge
                                                                     : BrushMode::Paint;
    m_recorder.emplace(brush, m_symmetry, leap);
    m_recorderLayer = static_cast<size_t>(m_chosen);
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
    m_recorder.reset();
    if (strokes.empty())
        return;
    const BrushMode mode = strokes.front().brush.mode;
    const QString label = mode == BrushMode::Erase ? tr("Erase") : mode == BrushMode::Smudge ? tr("Smudge") : tr("Paint");
    const auto change = [layer](Scene& scene, const std::function<void(std::vector<Stroke>&)>& step) {
        SphereMapDocument map = *scene.material.sphereMap.document.document;
        step(std::get<PaintLayer>(map.layers[layer].content).strokes);
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

void SphereMapEditor::pickColor(const glm::dvec2& q)
{
    if (m_picture.empty())
        return;
    const int n = m_picture.width;
    const auto texel = [n](double v) { return std::clamp(static_cast<int>((v + 1.0) * 0.5 * n), 0, n - 1); };
    const float* rgba = m_picture.texel(texel(q.x), texel(-q.y));
    if (!(rgba[3] > 0.0f))
        return;
    Brush brush = m_brush;
    for (int c = 0; c < 3; ++c)
        brush.color[c] = std::clamp(std::round(static_cast<double>(rgba[c] / rgba[3]) * 1e5) / 1e5, 0.0, 1000.0);
    setBrush(brush);
}

} // namespace mirrorball::studio
