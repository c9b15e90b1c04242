#include "planner.h"

#include "core/base/error.h"
#include "core/filter/source_file.h"
#include "core/image/mip_pyramid.h"
#include "core/shading/brdf.h"
#include "core/shading/brdf_file.h"

#include <algorithm>
#include <cmath>

/// What a picture needs of a scene.
namespace mirrorball {

namespace {

/// A background of more texels than this shows no more detail in a picture.
constexpr int tallestBackground = 2048;
/// Diffuse light is so smooth that this many texels show all of it.
constexpr int irradianceSize = 64;
/// No map is made smaller than this to save time.
constexpr int smallestMap = 32;

/// A chain ends where texels are about as wide as a lobe of roughness 1 can stand.
int smallestChainLevel(Parameterization kind) { return 8 * mapping(kind).quarterTurns; }
/// Of a chain's levels: between them lookups are linear, which misses far more.
constexpr double chainTolerance = 1e-3;

MapLayout withSize(MapLayout layout, int size)
{
    layout.size = std::min(layout.size, size);
    layout.border = std::min(layout.border, (layout.size - 1) / 2);
    return layout;
}

/// The size at which bilinear lookups show all that a filtered map holds: eight texels to the shortest wave of its band limit.
int sizeForBandLimit(Parameterization kind, int bandLimit)
{
    const int perDegree = 2 * mapping(kind).quarterTurns;
    int size = 16;
    while (size < perDegree * bandLimit && size < 16384)
        size *= 2;
    return size;
}

/// Where everything is made, nothing may turn out black or constant: a color that no picture shows, and an index so high that F is 1.
PlannedMaterial withNothingFolded(PlannedMaterial planned)
{
    constexpr double invisible = 1e-30;
    planned.specular = glm::max(planned.specular, glm::dvec3(invisible));
    planned.diffuse = glm::max(planned.diffuse, glm::dvec3(invisible));
    if (planned.fresnel.kind == FresnelKind::None)
        planned.fresnel = {.kind = FresnelKind::Dielectric, .index = 1e6};
    return planned;
}

} // namespace

PlannedMaterial planMaterial(const Material& material, PlanExtent extent)
{
    PlannedMaterial planned{.specular = material.specular.weight * material.specular.color,
                            .diffuse = material.diffuse.weight * material.diffuse.color,
                            .fresnel = material.brdf.isNone() ? fresnelTerm(material.fresnel) : Fresnel{},
                            .combine = material.combine,
                            .clearCoat = material.clearCoat.index == 1.0 ? 0.0 : material.clearCoat.weight,
                            .clearCoatIndex = material.clearCoat.index,
                            .clearCoatCombine = material.clearCoat.combine};
    if (extent == PlanExtent::Everything)
        planned = withNothingFolded(planned);
    if (!material.brdf.isNone()) // its albedo takes the place of F, and changes with the view
        planned.fresnel = {};
    if (extent == PlanExtent::Everything || !material.brdf.isNone())
        return planned;
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

Because Planner::whyNoSpecular() const
{
    const Material& material = m_scene.material;
    if (material.specular.weight == 0.0)
        return Because::SpecularWeightIsZero;
    return isBlack(material.specular.color) ? Because::SpecularColorIsBlack : Because::IndexIsOne;
}

Because Planner::whyNoDiffuse() const
{
    const Material& material = m_scene.material;
    if (material.diffuse.weight == 0.0)
        return Because::DiffuseWeightIsZero;
    return isBlack(material.diffuse.color) ? Because::DiffuseColorIsBlack : Because::CoatMirrorsAll;
}

bool Planner::readsMaterial() const
{
    const SphereMapSettings& map = m_scene.material.sphereMap;
    const bool isHidden = !map.isNone() && hidesMaterial(map.use);
    return showsMaterial() && !isHidden && !isWindow();
}

Decision Planner::whyNoMaterial() const
{
    if (showsMaterial())
        return isWindow() ? Because::RoomHasNoMaterial : Because::SphereMapReplaces;
    return ShowsDebugView{m_scene.view.shading};
}

void Planner::planPicture()
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
    planClearCoat();
    planBackground();
    if (!reads)
        leaveOut("fresnel term", whyNoMaterial());
    else if (!m_scene.material.brdf.isNone())
        leaveOut("fresnel term", Because::BrdfHoldsFresnel);
    else if (makesAll() && m_scene.material.fresnel.kind == FresnelKind::None)
        need("fresnel term", Because::EverythingIsAskedFor);
    else if (m_plan.material.fresnel.kind != FresnelKind::None)
        need("fresnel term", m_plan.material.fresnel.kind == FresnelKind::Dielectric
                                 ? Decision(DielectricAtEveryPixel{m_scene.material.fresnel.index})
                                 : MetalAtEveryPixel{m_scene.material.fresnel.metal});
    else if (m_scene.material.fresnel.kind == FresnelKind::None)
        leaveOut("fresnel term", Because::ReflectanceIsOne);
    else
        leaveOut("fresnel term", m_scene.material.fresnel.kind == FresnelKind::Dielectric && m_scene.material.fresnel.index == 1.0
                                     ? Because::ReflectanceIsZero
                                     : whyNoSpecular());
    planSphereMaps();
    planSurfacePictures();
    planLambda();
    if (makesAll()) {
        planOthers();
    } else if (m_plan.specular || m_plan.diffuse || m_plan.clearCoat) {
        leaveOut("other maps", ReadsOneParameterization{m_scene.map.parameterization});
    }
    if (builtinGeometry(m_scene.view.geometry))
        leaveOut("read mesh", MeshIsBuiltin{m_scene.view.geometry});
    else
        need("read mesh", ReadsMesh{m_scene.view.geometry});
    need("draw", Draws{m_scene.view.geometry, m_scene.view.width, m_scene.view.height},
         drawingCost(m_scene.view.width, m_scene.view.height));
}

void Planner::planLambda()
{
    const Material& material = m_scene.material;
    const std::string stage = "lambda by angle";
    if (m_plan.isExact() && material.lambda > 0.0)
        leaveOut(stage, Because::BrdfIsExact);
    else if (!m_plan.specular || material.lambda == 0.0)
        leaveOut(stage, Because::LambdaHoldsNoLevel);
    else if (material.lambdaGrazing == 0.0)
        leaveOut(stage, Because::LambdaIsTheSame);
    else
        need(stage, LambdaAtEveryPixel{material.lambdaGrazing});
}

void Planner::planOthers()
{
    for (const Parameterization p : allParameterizations) {
        if (p == m_scene.map.parameterization)
            continue;
        MapPlan map{.name = text(name(p), " map"), .pyramid = true};
        const PrefilterOptions filter{.lobe = lobe(m_scene.material.specular), .target = {p, m_scene.map.size, 0}, .yaw = bakedYaw()};
        addLevel(map, planned(filter), map.name, {.isForCompleteness = true});
        m_plan.others.push_back(std::move(map));
    }
}

void Planner::planSphereMap(const std::string& name, const std::string& field, const std::string& source, SphereMapLevels levels,
                            const EmbeddedSphereMap& document)
{
    const SphereMapSettings& map = m_scene.material.sphereMap;
    const bool isNone = source.empty() && !document;
    if (!showsMaterial() || isNone) {
        leaveOut(name, isNone ? Because::NoneIsNamed : whyNoMaterial());
        return;
    }
    SphereMapPlan planned{field, source, document, map.size, levels};
    // Levels that are made by hand have no coarser picture: each is one of its own.
    const int pixels = m_detail.discPixels;
    if (document && pixels > 0 && !(levels == SphereMapLevels::Authored && hasAuthoredLevels(*document.document)))
        for (int half = map.size; half % 2 == 0 && half / 2 >= pixels; planned.drawnSize = half)
            half /= 2;
    m_plan.sphereMaps.push_back(std::move(planned));
    need(name, EvaluatesSphereMap{m_plan.sphereMaps.back()});
}

void Planner::planSphereMaps()
{
    const SphereMapSettings& map = m_scene.material.sphereMap;
    const WindowSettings& window = m_scene.view.window;
    planSphereMap("sphere map", "material.sphere_map.source", map.source, isWindow() ? SphereMapLevels::Plain : map.levels, map.document);
    if (map.isNone() || !showsMaterial())
        return;
    if (isWindow()) {
        planSphereMap("sphere map, middle", "view.window.middle", window.middle, SphereMapLevels::Plain);
        planSphereMap("sphere map, far", "view.window.far", window.far, SphereMapLevels::Plain);
    } else if (const std::optional<Decision> why = whyNoFlecks()) {
        leaveOut("flecks", *why);
    } else {
        need("flecks", FlecksAtEveryPixel{map.flecks.cells.density, map.flecks.cells.size});
    }
}

std::optional<Decision> Planner::whyNoFlecks() const
{
    const SphereMapSettings& map = m_scene.material.sphereMap;
    if (!showsMaterial() || isWindow())
        return whyNoMaterial();
    if (map.isNone())
        return Because::NoSphereMapForFlecks;
    return map.flecks.cells.density == 0.0 ? std::optional<Decision>(Because::FleckDensityIsZero) : std::nullopt;
}

// Where none is named nothing is said: most scenes have none.
void Planner::planSurfacePictures()
{
    const Material& material = m_scene.material;
    const auto plan = [&](std::optional<SurfacePicturePlan>& picture, const SurfacePicturePlan& named,
                          const std::optional<Decision>& whyNot) {
        if (named.source.empty())
            return;
        if (whyNot) {
            leaveOut("read " + named.name, *whyNot);
            return;
        }
        picture = named;
        need("read " + named.name, ReadsSurfacePicture{named.source});
    };
    plan(m_plan.diffusePicture, {"diffuse picture", "material.diffuse.picture", material.diffuse.picture, SurfacePictureUse::Color},
         m_plan.diffuse    ? std::nullopt
         : readsMaterial() ? std::optional<Decision>(whyNoDiffuse())
                           : whyNoMaterial());
    plan(m_plan.fleckPattern,
         {"fleck pattern", "material.sphere_map.flecks.pattern", material.sphereMap.flecks.pattern, SurfacePictureUse::Share},
         whyNoFlecks());
    plan(m_plan.normalMap, {"normal map", "material.normal_map.source", material.normalMap.source, SurfacePictureUse::Normal},
         material.normalMap.strength == 0.0 ? std::optional<Decision>(Because::StrengthIsZero)
         : showsNormals()                   ? std::nullopt
                                            : std::optional<Decision>(whyNoMaterial()));
}

PlannedFilter Planner::withTolerance(PrefilterOptions filter) const
{
    if (m_detail != MapDetail{})
        filter.tolerance = std::max(filter.tolerance, m_detail.tolerance);
    PlannedFilter result = planned(filter);
    if (result.plan.bandLimit > m_detail.longBandLimit && filter.tolerance < m_detail.longTolerance) {
        filter.tolerance = m_detail.longTolerance;
        result = planned(filter);
    }
    return result;
}

void Planner::applySize(PrefilterOptions& filter, bool pyramid) const
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

PlannedFilter Planner::reflectionFilter(const PrefilterOptions& wanted, bool pyramid, LevelChoice& choice) const
{
    PlannedFilter whole = withTolerance(wanted);
    PrefilterOptions filter = whole.options;
    if (whole.plan.filtered && whole.plan.method == Method::Spectral && !makesAll()) {
        const MapLayout enough = withSize(filter.target, sizeForBandLimit(filter.target.kind, whole.plan.bandLimit));
        if (enough.size < filter.target.size)
            choice.askedSize = filter.target.size;
        filter.target = enough;
    }
    applySize(filter, pyramid);
    return filter == whole.options ? std::move(whole) : planned(filter);
}

void Planner::planSpecular()
{
    if (isBlack(m_plan.material.specular)) {
        leaveOut("specular map", whyNoSpecular());
        return;
    }
    if (!m_scene.material.brdf.isNone()) {
        // A view of levels shows those that the lookups read.
        if (m_scene.material.brdf.kind == LookupKind::Exact && m_scene.view.shading != Shading::Mips)
            planExactBrdf();
        else
            planBrdf();
        return;
    }
    MapPlan map{.name = "specular map"};
    const double lambda = m_scene.material.lambda;
    const double bias = m_scene.material.lodBias;
    map.pyramid = lambda > 0.0 || bias > 0.0 || m_scene.map.mips || makesAll();
    PrefilterOptions filter{.lobe = lobe(m_scene.material.specular), .target = mapLayout(), .yaw = bakedYaw()};
    LevelChoice choice = chooseMethod(filter);
    PlannedFilter level = reflectionFilter(filter, map.pyramid, choice);
    const MapLayout target = level.options.target;
    addLevel(map, std::move(level), map.name, choice, Because::SurfaceIsMirror);
    const bool perFace = m_scene.map.mipFiltering == MipFiltering::PerFace && target.kind == Parameterization::Cube;
    map.filtering = perFace ? MipFiltering::PerFace : MipFiltering::AcrossSeams;
    const std::string stage = "mip levels of specular map";
    if (map.pyramid)
        need(stage, HalvesForPicture{.lambda = lambda, .lodBias = bias, .levels = levelCount(target), .perFace = perFace},
             pyramidCost(target));
    else
        leaveOut(stage, Because::FinestLevelIsEnough);
    m_plan.specular = std::move(map);
}

void Planner::planBrdf()
{
    const BrdfSettings& brdf = m_scene.material.brdf;
    MapPlan map{.name = "specular map"};
    MapLayout largest = mapLayout();
    largest.size = std::max(largest.size, smallestMap);
    int levels = 1;
    while (levelLayout(largest, levels).size >= smallestChainLevel(largest.kind))
        ++levels;
    for (int i = 0; i < levels; ++i) {
        const double roughness = chainRoughness(i, levels);
        const PrefilterOptions filter{
            .lobe = ggxLobe(roughness * roughness), .target = levelLayout(largest, i), .tolerance = chainTolerance, .yaw = bakedYaw()};
        addLevel(map, planned(filter), text(map.name, " level ", i), {}, Because::RoughnessIsZero);
    }
    m_plan.specular = std::move(map);
    const LookupChoice choice = brdf.kind == LookupKind::Exact ? LookupChoice{} : brdf.choice();
    m_plan.brdf = BrdfPlan{brdf.model, choice, m_detail.brdfColumns};
    need("BRDF lookups", BrdfAtEveryPixel{*m_plan.brdf});
}

void Planner::planExactBrdf()
{
    const BrdfSettings& brdf = m_scene.material.brdf;
    if (std::int64_t{m_probe.width()} * m_probe.height() > streamedFrom)
        throw InvalidArgument(text("material.brdf.kind: exact holds the probe whole, and ", m_probe.width(), " x ", m_probe.height(),
                                   " texels are more than ", streamedFrom, "; take a smaller probe, or another kind"));
    leaveOut("specular map", Because::BrdfIsExact);
    m_plan.brdf = BrdfPlan{.model = brdf.model, .lookups = brdf.choice(), .tolerance = m_detail.brdfTolerance, .yaw = bakedYaw()};
    need("exact BRDF maps", BrdfAtEveryPixel{*m_plan.brdf},
         viewStackCost(isBrdfFile(brdf.model) ? 0.3 : equivalentAlpha(brdfFromText(brdf.model))));
}

void Planner::planDiffuse()
{
    if (isBlack(m_plan.material.diffuse)) {
        leaveOut("irradiance map", whyNoDiffuse());
        return;
    }
    MapPlan map{.name = "irradiance map"};
    PrefilterOptions filter{
        .lobe = diffuseLobe(), .target = makesAll() ? mapLayout() : withSize(mapLayout(), irradianceSize), .yaw = bakedYaw()};
    PlannedFilter whole = withTolerance(filter);
    filter = whole.options;
    applySize(filter, map.pyramid);
    addLevel(map, filter == whole.options ? std::move(whole) : planned(filter), map.name);
    m_plan.diffuse = std::move(map);
}

// Where there is none nothing is said: most materials have none.
void Planner::planClearCoat()
{
    MapPlan map{.name = "clear coat map", .pyramid = m_scene.map.mips};
    if (m_scene.material.clearCoat.weight == 0.0)
        return;
    if (!readsMaterial() || m_plan.material.clearCoat == 0.0) {
        leaveOut(map.name, readsMaterial() ? Because::CoatIndexIsOne : whyNoMaterial());
        return;
    }
    const PrefilterOptions filter{.lobe = lobe(m_scene.material.clearCoat), .target = mapLayout(), .yaw = bakedYaw()};
    LevelChoice choice;
    PlannedFilter level = reflectionFilter(filter, map.pyramid, choice);
    addLevel(map, std::move(level), map.name, choice, Because::CoatIsMirror);
    m_plan.clearCoat = std::move(map);
}

void Planner::planBackground()
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
        leaveOut("background", Because::BackdropIsOneColor);
        return;
    case Backdrop::None:
        leaveOut("background", Because::BackdropIsNone);
        return;
    case Backdrop::Environment:
        addLevel(map, planned({.lobe = ggxLobe(0.0), .target = withSize(m_probe, tallestBackground)}), map.name);
        break;
    case Backdrop::Blurred:
        addLevel(map, planned({.lobe = ggxLobe(background.blur * background.blur), .target = {Parameterization::Cube, 256, 0}}), map.name);
        break;
    }
    m_plan.background = std::move(map);
}

} // namespace mirrorball
