#include "plan.h"

#include "sphere_map_source.h"
#include "stage_cost.h"

#include "core/base/error.h"
#include "core/filter/source_file.h"
#include "core/image/image_format.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/spheremap/document/presets.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirrorball {

namespace {

/// A background of more texels than this shows no more detail in a picture.
constexpr int tallestBackground = 2048;
/// Diffuse light is so smooth that this many texels show all of it.
constexpr int irradianceSize = 64;
/// No map is made smaller than this to save time.
constexpr int smallestMap = 32;

template <typename... Parts>
std::string text(const Parts&... parts)
{
    std::ostringstream stream;
    stream.precision(3);
    (stream << ... << parts);
    return stream.str();
}

std::string sizeText(const MapLayout& layout) { return text(name(layout.kind), ' ', layout.width(), " x ", layout.height()); }

std::string plural(int count, const std::string& thing) { return text(count, ' ', thing, count == 1 ? "" : "s"); }

/// The document of a sphere map where it is known without opening a file, else null.
const SphereMapDocument* documentAtHand(const SphereMapPlan& map)
{
    if (map.document)
        return map.document.document.get();
    const SphereMapPreset* preset = isSphereMapFile(map.source) ? nullptr : findSphereMapPreset(map.source);
    return preset ? &preset->document : nullptr;
}

const char* levelsText(const SphereMapPlan& map)
{
    const SphereMapDocument* document = documentAtHand(map);
    if (map.levels == SphereMapLevels::Plain || (!document && isSphereMapPicture(map.source)))
        return "plain levels";
    if (!document)
        return "authored levels where the file has them";
    return hasAuthoredLevels(*document) ? "authored levels" : "plain levels, for no layer is made for levels";
}

std::string sourceText(const SphereMapPlan& map) { return map.document ? "the scene's own" : map.source; }

/// Which sphere map it is and how its levels are made, as far as that is known without opening a file.
std::string sphereMapText(const SphereMapPlan& map)
{
    if (!map.document && isSphereMapPicture(map.source))
        return text(map.source, ", a picture of its own size, plain levels");
    return text(sourceText(map), ", ", map.size, " x ", map.size, ", ", levelsText(map));
}

std::string paintedText(const SphereMapPlan& map, const ExportTarget& target)
{
    return text(sourceText(map), ", ", target.size, " x ", target.size,
                target.border > 0 ? text(" with a border of ", target.border) : std::string(), ", ",
                target.mips ? levelsText(map) : "one level");
}

bool isBlack(const glm::dvec3& color) { return color == glm::dvec3(0.0); }

MapLayout withSize(MapLayout layout, int size)
{
    layout.size = std::min(layout.size, size);
    layout.border = std::min(layout.border, (layout.size - 1) / 2);
    return layout;
}

/// The size at which bilinear lookups show all that a filtered map holds: eight texels to the shortest wave of its band limit.
int sizeForBandLimit(Parameterization kind, int bandLimit)
{
    const bool wholeTurn = kind == Parameterization::Sphere || kind == Parameterization::Angular; // 360 degrees across the edge
    const int perDegree = kind == Parameterization::Cube ? 2 : wholeTurn ? 8 : 4;
    int size = 16;
    while (size < perDegree * bandLimit && size < 16384)
        size *= 2;
    return size;
}

/// Where everything is made, nothing may turn out black or constant: a colour that no picture shows, and an index so high that F is 1.
PlannedMaterial withNothingFolded(PlannedMaterial planned)
{
    constexpr double invisible = 1e-30;
    planned.specular = glm::max(planned.specular, glm::dvec3(invisible));
    planned.diffuse = glm::max(planned.diffuse, glm::dvec3(invisible));
    if (planned.fresnel.kind == FresnelKind::None)
        planned.fresnel = {.kind = FresnelKind::Dielectric, .index = 1e6};
    return planned;
}

/// Which light the material takes in at all, in the order in which reasons rule it out.
PlannedMaterial planMaterial(const Material& material, PlanExtent extent)
{
    PlannedMaterial planned{.specular = material.specular.weight * material.specular.color,
                            .diffuse = material.diffuse.weight * material.diffuse.color,
                            .fresnel = fresnelTerm(material.fresnel),
                            .combine = material.combine};
    if (extent == PlanExtent::Everything)
        return withNothingFolded(planned);
    if (const auto f = constantReflectance(planned.fresnel)) {
        planned.specular *= *f;
        if (planned.combine == Combine::Coat)
            planned.diffuse *= 1.0 - *f;
        planned.fresnel = {};
        planned.combine = Combine::Add;
    }
    if (planned.combine == Combine::Add && isBlack(planned.specular)) // F only scales what is not there
        planned.fresnel = {};
    return planned;
}

bool isAskedFor(const ExportTarget& target, const std::vector<std::string>& only)
{
    return only.empty() || std::find(only.begin(), only.end(), target.name) != only.end();
}

class Planner {
public:
    Planner(const Scene& scene, const MapLayout& probe) : m_scene(scene), m_probe(probe) {}

    Plan make(const PlanRequest& request)
    {
        m_extent = request.extent;
        m_detail = request.detail;
        m_plan.material = planMaterial(m_scene.material, m_extent);
        if (request.picture)
            planPicture();
        if (request.exports)
            planExports(*request.exports);
        planReading();
        return std::move(m_plan);
    }

    /// Levels that are all filtered from the probe, as one export.
    Plan makeFilters(const std::vector<PrefilterOptions>& levels, const std::string& file)
    {
        MapPlan map{.name = levels.size() == 1 ? describe(levels.front().lobe) : "map"};
        for (size_t i = 0; i < levels.size(); ++i)
            addLevel(map, planned(levels[i]), levels.size() == 1 ? map.name : text(map.name, " level ", i), "", "the lobe is a mirror");
        if (levels.size() == 1)
            leaveOut("mip levels of " + map.name, "not asked for");
        need("save map", file, savingCost(levels.front().target));
        m_plan.exports.push_back({.map = std::move(map)});
        planReading();
        return std::move(m_plan);
    }

private:
    bool makesAll() const { return m_extent == PlanExtent::Everything; }
    int probeWidth() const { return 2 * latlongHeight(m_probe); }
    void need(std::string name, std::string why, const StageCost& cost = {})
    {
        m_later.push_back({.name = std::move(name), .why = std::move(why), .expected = cost});
    }
    void leaveOut(std::string name, std::string why)
    {
        m_later.push_back({.name = std::move(name), .leftOut = true, .why = std::move(why)});
    }

    /// Why the material shows no reflection, or no diffuse light.
    std::string whyNoSpecular() const
    {
        const Material& material = m_scene.material;
        if (material.specular.weight == 0.0)
            return "specular weight is 0";
        return isBlack(material.specular.color) ? "specular colour is black" : "the index of refraction is 1: nothing is reflected";
    }
    std::string whyNoDiffuse() const
    {
        const Material& material = m_scene.material;
        if (material.diffuse.weight == 0.0)
            return "diffuse weight is 0";
        return isBlack(material.diffuse.color) ? "diffuse colour is black" : "the coat mirrors everything: no light gets below it";
    }

    PlannedFilter planned(const PrefilterOptions& filter) const { return planFilter(filter, probeWidth()); }

    /// The scene's choice of method. What that refuses is left to auto; @return a note for the stage, empty where nothing was chosen
    std::string chooseMethod(PrefilterOptions& filter) const
    {
        const FilterSettings& chosen = m_scene.filter;
        filter.tolerance = chosen.tolerance;
        filter.knobs = chosen.knobs();
        if (chosen.method == Method::Auto || filter.lobe.isMirror())
            return {};
        PrefilterOptions asked = filter;
        asked.method = chosen.method;
        const std::string why = refusal(chosen.method, asked, {.width = probeWidth()});
        if (!why.empty())
            return text("; ", mirrorball::name(chosen.method), " was asked for but cannot do this: ", why);
        filter.method = chosen.method;
        return "; as the scene asks";
    }

    /// Adds the stages of one level and remembers what it takes. A map that never was to be filtered has no stage for that.
    void addLevel(MapPlan& map, PlannedFilter planned, const std::string& name, const std::string& note = "",
                  const std::string& whyMirror = "")
    {
        const PrefilterOptions& filter = planned.options;
        const PrefilterPlan& prediction = planned.plan;
        if (prediction.filtered) {
            const std::string how = prediction.method == Method::Spectral ? text("spectral, band limit ", prediction.bandLimit, " at most")
                                                                          : text(mirrorball::name(prediction.method));
            need("filter " + name, text(describe(filter.lobe), " into ", sizeText(filter.target), ": ", how, note), planned.filtering);
        } else {
            if (!filter.lobe.isMirror() || !whyMirror.empty())
                leaveOut("filter " + name, filter.lobe.isMirror() ? whyMirror : prediction.why);
            const bool same = filter.target == m_probe && filter.yaw == 0.0;
            if (same)
                leaveOut("resample " + name, text("the probe already is ", sizeText(m_probe)));
            else
                need("resample " + name, text(sizeText(m_probe), " to ", sizeText(filter.target), note), resamplingCost(filter.target));
        }
        map.filters.push_back(std::move(planned));
    }

    /// A debug view shows what the material is computed from, and not the material.
    bool showsMaterial() const { return m_scene.view.shading == Shading::Material; }
    bool isWindow() const { return m_scene.view.geometry == "window"; }
    /// Nor does a sphere map that replaces the material show it, nor a room.
    bool readsMaterial() const
    {
        const SphereMapSettings& map = m_scene.material.sphereMap;
        const bool isHidden = !map.isNone() && (map.use == SphereMapUse::Replace || map.use == SphereMapUse::Multiply);
        return showsMaterial() && !isHidden && !isWindow();
    }
    std::string whyNoMaterial() const
    {
        if (showsMaterial())
            return isWindow() ? "a room with a window has no material" : "the sphere map stands in for the reflection";
        return text("the view shows ", words(Shading{})[static_cast<size_t>(m_scene.view.shading)], " and not the material");
    }

    void planPicture()
    {
        const bool reads = readsMaterial();
        if (reads || makesAll() || m_scene.view.shading == Shading::Mips)
            planSpecular();
        else
            leaveOut("specular map", whyNoMaterial());
        if (reads || makesAll())
            planDiffuse();
        else
            leaveOut("irradiance map", whyNoMaterial());
        planBackground();
        if (!reads)
            leaveOut("fresnel term", whyNoMaterial());
        else if (makesAll() && m_scene.material.fresnel.kind == FresnelKind::None)
            need("fresnel term", "everything is asked for: evaluated at every pixel");
        else if (m_plan.material.fresnel.kind != FresnelKind::None)
            need("fresnel term", m_plan.material.fresnel.kind == FresnelKind::Dielectric
                                     ? text("index ", m_scene.material.fresnel.index, ": evaluated at every pixel")
                                     : text("metal ", m_scene.material.fresnel.metal, ": evaluated at every pixel"));
        else if (m_scene.material.fresnel.kind == FresnelKind::None)
            leaveOut("fresnel term", "none: F is 1 at every angle");
        else
            leaveOut("fresnel term", m_scene.material.fresnel.kind == FresnelKind::Dielectric && m_scene.material.fresnel.index == 1.0
                                         ? "the index is 1: F is 0 at every angle"
                                         : whyNoSpecular());
        planSphereMaps();
        planLambda();
        if (makesAll()) {
            planOthers();
        } else if (m_plan.specular || m_plan.diffuse) {
            std::string others;
            for (const Parameterization p : allParameterizations)
                if (p != m_scene.map.parameterization)
                    others += (others.empty() ? "" : ", ") + std::string(name(p));
            leaveOut("other maps", text("the picture reads ", name(m_scene.map.parameterization), ": no ", others, " is built"));
        }
        if (isBuiltinGeometry(m_scene.view.geometry))
            leaveOut("read mesh", text("the ", m_scene.view.geometry, " is built in"));
        else
            need("read mesh", m_scene.view.geometry);
        need("draw", text(m_scene.view.geometry, ", ", m_scene.view.width, " x ", m_scene.view.height),
             drawingCost(m_scene.view.width, m_scene.view.height));
    }

    void planLambda()
    {
        const Material& material = m_scene.material;
        const std::string stage = "lambda by angle";
        if (!m_plan.specular || material.lambda == 0.0)
            leaveOut(stage, "lambda is 0: no level is held");
        else if (material.lambdaGrazing == 0.0)
            leaveOut(stage, "lambda_grazing is 0: lambda is the same at every angle");
        else
            need(stage, text("lambda_grazing ", material.lambdaGrazing, ": evaluated at every pixel"));
    }

    void planOthers()
    {
        for (const Parameterization p : allParameterizations) {
            if (p == m_scene.map.parameterization)
                continue;
            MapPlan map{.name = text(name(p), " map"), .pyramid = true};
            const PrefilterOptions filter{.lobe = lobe(m_scene.material.specular), .target = {p, m_scene.map.size, 0}, .yaw = bakedYaw()};
            addLevel(map, planned(filter), map.name, "; everything is asked for");
            m_plan.others.push_back(std::move(map));
        }
    }

    void planSphereMap(const std::string& name, const std::string& field, const std::string& source, SphereMapLevels levels,
                       const EmbeddedSphereMap& document = {})
    {
        const SphereMapSettings& map = m_scene.material.sphereMap;
        const bool isNone = source.empty() && !document;
        if (!showsMaterial() || isNone) {
            leaveOut(name, isNone ? "none is named" : whyNoMaterial());
            return;
        }
        m_plan.sphereMaps.push_back({field, source, document, map.size, levels});
        need(name, sphereMapText(m_plan.sphereMaps.back()));
    }

    void planSphereMaps()
    {
        const SphereMapSettings& map = m_scene.material.sphereMap;
        const WindowSettings& window = m_scene.view.window;
        planSphereMap("sphere map", "material.sphere_map.source", map.source, isWindow() ? SphereMapLevels::Plain : map.levels,
                      map.document);
        if (map.isNone() || !showsMaterial())
            return;
        if (isWindow()) {
            planSphereMap("sphere map, middle", "view.window.middle", window.middle, SphereMapLevels::Plain);
            planSphereMap("sphere map, far", "view.window.far", window.far, SphereMapLevels::Plain);
        } else if (map.flecks.density > 0.0) {
            need("flecks", text("density ", map.flecks.density, ", cells of ", map.flecks.size));
        } else {
            leaveOut("flecks", "density is 0");
        }
    }

    /// The environment's yaw belongs to the picture's lookups, so that turning it makes no map anew; a map in eye space has no such turn.
    double bakedYaw() const { return m_scene.map.space == MapSpace::Eye ? m_scene.probe.yawDeg * pi / 180.0 : 0.0; }

    void applyTolerance(PrefilterOptions& filter) const
    {
        if (m_detail != MapDetail{})
            filter.tolerance = std::max(filter.tolerance, m_detail.tolerance);
    }

    /// A map without coarser levels may be made smaller: lookups do not notice but for sharpness. Levels are counted from the largest, so
    /// a pyramid keeps its size.
    void applySize(PrefilterOptions& filter, bool pyramid) const
    {
        if (pyramid)
            return;
        const auto shrink = [&](int size) {
            filter.target.border = filter.target.border * size / filter.target.size;
            filter.target.size = size;
        };
        if (filter.target.size > m_detail.largestSize)
            shrink(m_detail.largestSize);
        while (filter.target.size >= 2 * smallestMap && lobeAngle(filter.lobe) > 2.0 * m_detail.texelsPerLobe * texelAngle(filter.target))
            shrink(filter.target.size / 2);
    }

    MapLayout mapLayout() const { return {m_scene.map.parameterization, m_scene.map.size, m_scene.map.border}; }

    void planSpecular()
    {
        if (isBlack(m_plan.material.specular)) {
            leaveOut("specular map", whyNoSpecular());
            return;
        }
        MapPlan map{.name = "specular map"};
        const double lambda = m_scene.material.lambda;
        const double bias = m_scene.material.lodBias;
        map.pyramid = lambda > 0.0 || bias > 0.0 || m_scene.map.mips || makesAll();
        PrefilterOptions filter{.lobe = lobe(m_scene.material.specular), .target = mapLayout(), .yaw = bakedYaw()};
        std::string note = chooseMethod(filter);
        applyTolerance(filter);
        PlannedFilter whole = planned(filter);
        if (whole.plan.filtered && whole.plan.method == Method::Spectral && !makesAll()) {
            const MapLayout enough = withSize(filter.target, sizeForBandLimit(filter.target.kind, whole.plan.bandLimit));
            if (enough.size < filter.target.size)
                note += text("; so smooth that size ", enough.size, " shows all of it, ", filter.target.size, " is left out");
            filter.target = enough;
        }
        applySize(filter, map.pyramid);
        addLevel(map, filter == whole.options ? std::move(whole) : planned(filter), map.name, note,
                 "the surface is a mirror: it shows the environment itself");
        const bool perFace = m_scene.map.mipFiltering == MipFiltering::PerFace && filter.target.kind == Parameterization::Cube;
        map.filtering = perFace ? MipFiltering::PerFace : MipFiltering::AcrossSeams;
        const std::string stage = "mip levels of specular map";
        if (map.pyramid)
            need(stage,
                 text(lambda > 0.0 ? text("lambda ", lambda)
                      : bias > 0.0 ? text("LOD bias ", bias)
                                   : "asked for, where reflections shrink",
                      ": ", plural(levelCount(filter.target), "level"),
                      perFace ? ", each face halved by itself: seams will show" : ", halved across seams"),
                 pyramidCost(filter.target));
        else
            leaveOut(stage, "lambda is 0: only the finest level is read");
        m_plan.specular = std::move(map);
    }

    void planDiffuse()
    {
        if (isBlack(m_plan.material.diffuse)) {
            leaveOut("irradiance map", whyNoDiffuse());
            return;
        }
        MapPlan map{.name = "irradiance map"};
        PrefilterOptions filter{
            .lobe = diffuseLobe(), .target = makesAll() ? mapLayout() : withSize(mapLayout(), irradianceSize), .yaw = bakedYaw()};
        applyTolerance(filter);
        applySize(filter, map.pyramid);
        addLevel(map, planned(filter), map.name);
        m_plan.diffuse = std::move(map);
    }

    void planBackground()
    {
        const BackdropSettings& background = m_scene.view.background;
        MapPlan map{.name = "background"};
        if (makesAll() && background.kind != Backdrop::Blurred) {
            addLevel(map, planned({.lobe = ggxLobe(0.0), .target = m_probe}), map.name);
            m_plan.background = std::move(map);
            return;
        }
        switch (background.kind) {
        case Backdrop::Color:
            leaveOut("background", "one colour: no map");
            return;
        case Backdrop::None:
            leaveOut("background", "none: the picture is transparent beside the object");
            return;
        case Backdrop::Environment:
            addLevel(map, planned({.lobe = ggxLobe(0.0), .target = withSize(m_probe, tallestBackground)}), map.name);
            break;
        case Backdrop::Blurred:
            addLevel(map, planned({.lobe = ggxLobe(background.blur * background.blur), .target = {Parameterization::Cube, 256, 0}}),
                     map.name);
            break;
        }
        m_plan.background = std::move(map);
    }

    void planExports(const std::vector<std::string>& only)
    {
        for (const std::string& name : only)
            if (std::none_of(m_scene.exports.begin(), m_scene.exports.end(), [&](const ExportTarget& t) { return t.name == name; })) {
                std::string known;
                for (const ExportTarget& target : m_scene.exports)
                    known += (known.empty() ? "" : ", ") + target.name;
                throw InvalidArgument("--only: the scene has no export '" + name + "'; it has " + (known.empty() ? "none" : known));
            }
        for (const ExportTarget& target : m_scene.exports)
            if (!isAskedFor(target, only))
                leaveOut("export " + target.name, "not among those asked for");
            else if (target.kind == ExportKind::Painted)
                planPainted(target);
            else
                planExport(target);
    }

    void planPainted(const ExportTarget& target)
    {
        const SphereMapSettings& map = m_scene.material.sphereMap;
        if (map.isNone())
            throw InvalidArgument(text("exports[", &target - m_scene.exports.data(),
                                       "].kind: painted writes the scene's sphere map, and it has none; "
                                       "give material.sphere_map.source a preset or a file, or choose another kind"));
        const SphereMapPlan painted{"material.sphere_map.source", map.source, map.document, target.size - 2 * target.border, map.levels};
        const SphereMapDocument* document = documentAtHand(painted);
        const bool isAuthored = target.mips && document && map.levels == SphereMapLevels::Authored && hasAuthoredLevels(*document);
        const StageCost cost = paintingCost(painted.size, document ? document->layers.size() : 1, isAuthored);
        need("paint " + target.name, paintedText(painted, target), cost);
        need("save " + target.name, target.fileName(), savingCost(target.layout()));
        m_plan.exports.push_back({.map = {.name = target.name}, .target = target, .painted = painted, .paintingSeconds = cost.seconds});
    }

    void planExport(const ExportTarget& target)
    {
        MapPlan map{.name = target.name};
        PrefilterOptions filter{.target = target.layout(), .yaw = m_scene.probe.yawDeg * pi / 180.0};
        switch (target.kind) {
        case ExportKind::Source:
            filter.lobe = ggxLobe(0.0);
            break;
        case ExportKind::Specular:
            filter.lobe = lobe(m_scene.material.specular);
            break;
        case ExportKind::Diffuse:
            filter.lobe = diffuseLobe();
            break;
        case ExportKind::Chain:
        case ExportKind::Painted:
            break;
        }
        if (target.kind == ExportKind::Chain) {
            const int all = levelCount(filter.target), levels = target.levels == 0 ? all : std::min(target.levels, all);
            for (int i = 0; i < levels; ++i) {
                const double roughness = chainRoughness(i, levels);
                PrefilterOptions level = filter;
                level.lobe = ggxLobe(roughness * roughness);
                level.target = levelLayout(filter.target, i);
                addLevel(map, planned(level), text(target.name, " level ", i), "", "roughness 0: the level is the environment itself");
            }
        } else {
            const std::string note = target.kind == ExportKind::Specular ? chooseMethod(filter) : std::string();
            addLevel(map, planned(filter), map.name, note, target.kind == ExportKind::Specular ? "the surface is a mirror" : "");
            const bool held = holdsMips(target.fileName()) || namesLevels(target.fileName());
            map.pyramid = target.mips && held;
            if (map.pyramid)
                need("mip levels of " + map.name, plural(levelCount(filter.target), "level"), pyramidCost(filter.target));
            else
                leaveOut("mip levels of " + map.name,
                         target.mips ? target.fileName() + " holds none; .exr and .tif do, and a %d in the name makes one file a level"
                                     : "not asked for");
        }
        need("save " + map.name, target.fileName(), savingCost(filter.target));
        m_plan.exports.push_back({.map = std::move(map), .target = target});
    }

    /// The stages before all others follow from what the maps need.
    void planReading()
    {
        const bool builtin = m_scene.probe.source.starts_with("builtin:");
        const std::string read = builtin ? "compute probe" : "read probe";
        std::vector<Stage>& stages = m_plan.stages;
        if (!m_plan.needsProbe()) {
            stages.push_back({.name = read, .leftOut = true, .why = "no map is needed"});
        } else {
            const std::vector<const PlannedFilter*> filters = m_plan.planned();
            int filtered = 0, spectral = 0, bandLimit = 0;
            StageCost transform;
            for (const PlannedFilter* filter : filters) {
                const PrefilterPlan& prediction = filter->plan;
                filtered += prediction.filtered;
                if (prediction.filtered && prediction.method == Method::Spectral) {
                    ++spectral;
                    if (prediction.bandLimit >= bandLimit)
                        transform = filter->spectrum;
                }
                bandLimit = std::max(bandLimit, prediction.filtered ? prediction.bandLimit : 0);
            }
            const bool large = std::int64_t{m_probe.width()} * m_probe.height() > streamedFrom;
            const bool streamed =
                large && m_probe.kind == Parameterization::Latlong && !builtin && filtered == static_cast<int>(filters.size());
            std::string how = m_scene.probe.source + ", " + sizeText(m_probe);
            if (streamed)
                how += text("; each row is truncated to band limit ", bandLimit, " while it is read, which is exact");
            else if (large)
                how += "; held whole, because not every map is filtered";
            stages.push_back({.name = read, .why = how, .expected = readingCost(m_probe, builtin, streamed)});
            if (spectral > 0)
                stages.push_back(
                    {.name = "spectrum", .why = text("one forward transform for ", plural(spectral, "lobe")), .expected = transform});
            else
                stages.push_back({.name = "spectrum",
                                  .leftOut = true,
                                  .why = filtered == 0 ? "nothing is filtered" : "direct sums are cheaper for these lobes"});
        }
        stages.insert(stages.end(), std::make_move_iterator(m_later.begin()), std::make_move_iterator(m_later.end()));
    }

    const Scene& m_scene;
    MapLayout m_probe;
    PlanExtent m_extent = PlanExtent::Needed;
    MapDetail m_detail{};
    Plan m_plan{};
    std::vector<Stage> m_later{};
};

} // namespace

bool Plan::needsProbe() const
{
    return specular || diffuse || background || !others.empty() ||
           std::any_of(exports.begin(), exports.end(), [](const ExportPlan& planned) { return !planned.painted; });
}

std::vector<const PlannedFilter*> Plan::planned() const
{
    std::vector<const PlannedFilter*> all;
    const auto add = [&](const MapPlan& map) {
        for (const PlannedFilter& filter : map.filters)
            all.push_back(&filter);
    };
    for (const auto* map : {&specular, &diffuse, &background})
        if (*map)
            add(**map);
    for (const MapPlan& map : others)
        add(map);
    for (const ExportPlan& exported : exports)
        add(exported.map);
    return all;
}

std::vector<PrefilterOptions> Plan::filters() const
{
    std::vector<PrefilterOptions> all;
    for (const PlannedFilter* filter : planned())
        all.push_back(filter->options);
    return all;
}

bool Plan::filtersAny() const
{
    const std::vector<const PlannedFilter*> all = planned();
    return std::any_of(all.begin(), all.end(), [](const PlannedFilter* filter) { return filter->plan.filtered; });
}

double lobeAngle(const Lobe& lobe) { return lobe.isMirror() ? 0.0 : 2.0 * LobeShape(lobe).halfWidth(); }

double texelAngle(const MapLayout& layout) { return std::sqrt(4.0 * pi / (double(layout.width()) * layout.height())); }

std::optional<double> constantReflectance(const Fresnel& fresnel)
{
    if (fresnel.kind == FresnelKind::None)
        return 1.0;
    if (fresnel.kind == FresnelKind::Dielectric && fresnel.index == 1.0)
        return 0.0;
    return std::nullopt;
}

bool mayNeedProbe(const Scene& scene, const PlanRequest& request)
{
    const auto readsProbe = [&](const ExportTarget& target) {
        return target.kind != ExportKind::Painted && isAskedFor(target, *request.exports);
    };
    return request.picture || (request.exports && std::any_of(scene.exports.begin(), scene.exports.end(), readsProbe));
}

Plan makePlan(const Scene& scene, const MapLayout& probe, const PlanRequest& request)
{
    validate(scene);
    return Planner(scene, probe).make(request);
}

Plan planFilters(const std::string& source, const MapLayout& probe, const std::vector<PrefilterOptions>& levels, const std::string& file)
{
    Scene scene;
    scene.probe.source = source;
    return Planner(scene, probe).makeFilters(levels, file);
}

} // namespace mirrorball
