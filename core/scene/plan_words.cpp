#include "plan_words.h"

#include "sphere_map_source.h"

#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"

namespace mirrorball {

std::string sizeText(const MapLayout& layout) { return text(name(layout.kind), ' ', layout.width(), " x ", layout.height()); }

std::string promiseText(const PlannedFilter& filter)
{
    if (keepsTolerance(filter.plan.method))
        return text("; a tolerance of ", filter.options.tolerance, " is promised");
    const PredictedErrors& predicted = filter.plan.predicted;
    return text("; not promised: predicted are rel_rms ", predicted.relRms, ", median_rel ", predicted.medianRel, ", p99_rel ",
                predicted.p99Rel);
}

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

} // namespace

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

} // namespace mirrorball
