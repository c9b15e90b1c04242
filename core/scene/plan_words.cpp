#include "plan_words.h"

#include "sphere_map_source.h"

#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"

namespace mirrorball {

std::string sizeText(const MapLayout& layout) { return text(name(layout.kind), ' ', layout.width(), " x ", layout.height()); }

std::string plural(int count, const std::string& thing) { return text(count, ' ', thing, count == 1 ? "" : "s"); }

const SphereMapDocument* documentAtHand(const SphereMapPlan& map)
{
    if (map.document)
        return map.document.document.get();
    const SphereMapPreset* preset = isSphereMapFile(map.source) ? nullptr : findSphereMapPreset(map.source);
    return preset ? &preset->document : nullptr;
}

namespace {

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

/// What is promised of a filtered map before the probe is read, or what is predicted of it where nothing is.
std::string promiseText(const PlannedFilter& filter)
{
    if (keepsTolerance(filter.plan.method))
        return text("; a tolerance of ", filter.options.tolerance, " is promised");
    const PredictedErrors& predicted = filter.plan.predicted;
    return text("; not promised: predicted are rel_rms ", predicted.relRms, ", median_rel ", predicted.medianRel, ", p99_rel ",
                predicted.p99Rel);
}

/// What follows what a level is.
std::string choiceText(const LevelChoice& choice, const MapLayout& made)
{
    std::string result;
    if (choice.asked)
        result = choice.refusal.empty() ? "; as the scene asks"
                                        : text("; ", name(*choice.asked), " was asked for but cannot do this: ", choice.refusal);
    if (choice.askedSize > 0)
        result += text("; so smooth that size ", made.size, " shows all of it, ", choice.askedSize, " is left out");
    if (choice.isForCompleteness)
        result += "; everything is asked for";
    return result;
}

struct Words {
    std::string operator()(Because because) const
    {
        switch (because) {
        case Because::NoMapIsNeeded:
            return "no map is needed";
        case Because::NothingIsFiltered:
            return "nothing is filtered";
        case Because::SumsAreCheaper:
            return "direct sums are cheaper for these lobes";
        case Because::NoneIsNamed:
            return "none is named";
        case Because::NotAskedFor:
            return "not asked for";
        case Because::NotAmongThoseAskedFor:
            return "not among those asked for";
        case Because::EverythingIsAskedFor:
            return "everything is asked for: evaluated at every pixel";
        case Because::LobeIsMirror:
            return "the lobe is a mirror";
        case Because::SurfaceIsMirror:
            return "the surface is a mirror: it shows the environment itself";
        case Because::ExportIsOfMirror:
            return "the surface is a mirror";
        case Because::CoatIsMirror:
            return "the coat is a mirror: it shows the environment itself";
        case Because::RoughnessIsZero:
            return "roughness 0: the level is the environment itself";
        case Because::SpecularWeightIsZero:
            return "specular weight is 0";
        case Because::SpecularColorIsBlack:
            return "specular color is black";
        case Because::IndexIsOne:
            return "the index of refraction is 1: nothing is reflected";
        case Because::CoatIndexIsOne:
            return "its index is 1: nothing is reflected";
        case Because::ReflectanceIsZero:
            return "the index is 1: F is 0 at every angle";
        case Because::ReflectanceIsOne:
            return "none: F is 1 at every angle";
        case Because::BrdfHoldsFresnel:
            return "the BRDF has its own, inside its integral";
        case Because::BrdfIsExact:
            return "the BRDF is drawn exactly, from maps of its own";
        case Because::DiffuseWeightIsZero:
            return "diffuse weight is 0";
        case Because::DiffuseColorIsBlack:
            return "diffuse color is black";
        case Because::CoatMirrorsAll:
            return "the coat mirrors everything: no light gets below it";
        case Because::RoomHasNoMaterial:
            return "a room with a window has no material";
        case Because::SphereMapReplaces:
            return "the sphere map stands in for the reflection";
        case Because::NoSphereMapForFlecks:
            return "there is no sphere map that they look up";
        case Because::FleckDensityIsZero:
            return "density is 0";
        case Because::StrengthIsZero:
            return "strength is 0";
        case Because::LambdaHoldsNoLevel:
            return "lambda is 0: no level is held";
        case Because::LambdaIsTheSame:
            return "lambda_grazing is 0: lambda is the same at every angle";
        case Because::FinestLevelIsEnough:
            return "lambda is 0: only the finest level is read";
        case Because::BackdropIsOneColor:
            return "one color: no map";
        case Because::BackdropIsNone:
            return "none: the picture is transparent beside the object";
        }
        return {};
    }
    std::string operator()(const ReadsProbe& d) const
    {
        return text(d.source, ", ", sizeText(d.layout),
                    d.streamedBandLimit
                        ? text("; each row is truncated to band limit ", *d.streamedBandLimit, " while it is read, which is exact")
                    : d.isLargeAndWhole ? std::string("; held whole, because not every map is filtered")
                                        : std::string());
    }
    std::string operator()(const TransformsOnce& d) const { return "one forward transform for " + plural(d.lobes, "lobe"); }
    std::string operator()(const FiltersLevel& d) const
    {
        const PrefilterPlan& plan = d.filter.plan;
        const PrefilterOptions& filter = d.filter.options;
        const std::string how =
            plan.method == Method::Spectral ? text("spectral, band limit ", plan.bandLimit, " at most") : std::string(name(plan.method));
        return text(describe(filter.lobe), " into ", sizeText(filter.target), ": ", how, promiseText(d.filter),
                    choiceText(d.choice, filter.target));
    }
    std::string operator()(const LooksUp& d) const { return d.plan.why; }
    std::string operator()(const ResamplesLevel& d) const
    {
        return text(sizeText(d.from), " to ", sizeText(d.to), choiceText(d.choice, d.to));
    }
    std::string operator()(const IsProbeAlready& d) const { return "the probe already is " + sizeText(d.layout); }
    std::string operator()(const HalvesForPicture& d) const
    {
        return text(d.lambda > 0.0    ? text("lambda ", d.lambda)
                    : d.lodBias > 0.0 ? text("LOD bias ", d.lodBias)
                                      : std::string("asked for, where reflections shrink"),
                    ": ", plural(d.levels, "level"), d.perFace ? ", each face halved by itself: seams will show" : ", halved across seams");
    }
    std::string operator()(const HalvesForExport& d) const { return plural(d.levels, "level"); }
    std::string operator()(const FileHoldsNoLevels& d) const
    {
        return d.file + " holds none; .exr and .tif do, and a %d in the name makes one file a level";
    }
    std::string operator()(const ShowsDebugView& d) const { return text("the view shows ", wordOf(d.shading), " and not the material"); }
    std::string operator()(const DielectricAtEveryPixel& d) const { return text("index ", d.index, ": evaluated at every pixel"); }
    std::string operator()(const MetalAtEveryPixel& d) const { return text("metal ", d.metal, ": evaluated at every pixel"); }
    std::string operator()(const LambdaAtEveryPixel& d) const { return text("lambda_grazing ", d.grazing, ": evaluated at every pixel"); }
    std::string operator()(const BrdfAtEveryPixel& d) const
    {
        const LookupChoice& lookups = d.brdf.lookups;
        if (lookups.kind == LookupKind::Exact)
            return text(d.brdf.model, ": exact, maps by order about the mirror direction at as many angles of view as a tolerance of ",
                        d.brdf.tolerance, " asks for");
        return lookups.kind == LookupKind::Fitted ? text(d.brdf.model, ": ", plural(lookups.count, "lookup"), " at each pixel")
                                                  : text(d.brdf.model, ": ", describe(lookups), ", as an engine shows it");
    }
    std::string operator()(const FlecksAtEveryPixel& d) const { return text("density ", d.density, ", cells of ", d.size); }
    std::string operator()(const EvaluatesSphereMap& d) const
    {
        if (!d.map.document && isSphereMapPicture(d.map.source))
            return text(d.map.source, ", a picture of its own size, plain levels");
        return text(sourceText(d.map), ", ", d.map.size, " x ", d.map.size, ", ", levelsText(d.map));
    }
    std::string operator()(const PaintsFile& d) const
    {
        return text(sourceText(d.map), ", ", d.target.size, " x ", d.target.size,
                    d.target.border > 0 ? text(" with a border of ", d.target.border) : std::string(), ", ",
                    d.target.mips ? levelsText(d.map) : "one level");
    }
    std::string operator()(const ReadsOneParameterization& d) const
    {
        std::string others;
        for (const Parameterization p : allParameterizations)
            if (p != d.kind)
                others += (others.empty() ? "" : ", ") + std::string(name(p));
        return text("the picture reads ", name(d.kind), ": no ", others, " is built");
    }
    std::string operator()(const ReadsSurfacePicture& d) const { return d.source + ", by the mesh's texture coordinates"; }
    std::string operator()(const MeshIsBuiltin& d) const { return text("the ", d.geometry, " is built in"); }
    std::string operator()(const ReadsMesh& d) const { return d.file; }
    std::string operator()(const Draws& d) const { return text(d.geometry, ", ", d.width, " x ", d.height); }
    std::string operator()(const SavesFile& d) const { return d.file; }
};

} // namespace

std::string inWords(const Decision& decision) { return std::visit(Words{}, decision); }

std::vector<Stage> Plan::stages() const
{
    std::vector<Stage> result;
    for (const PlannedStage& stage : decisions)
        result.push_back({.name = stage.name, .leftOut = stage.isLeftOut, .why = inWords(stage.why), .expected = stage.expected});
    return result;
}

} // namespace mirrorball
