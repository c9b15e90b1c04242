#include "map_stage.h"

#include "map_panel.h"
#include "widgets/controls/text.h"

#include "core/scene/plan_words.h"

namespace mirrorball::studio {

namespace {

/// What the plan says of a map that it leaves out.
QString whyLeftOut(const char* stageName, const Plan& plan)
{
    for (const PlannedStage& s : plan.decisions)
        if (s.name == stageName && s.isLeftOut)
            return MapPanel::tr("This map is left out: %1.").arg(toQString(inWords(s.why)));
    return MapPanel::tr("This map is not made.");
}

} // namespace

StageMaps mapsOf(MapStage stage, const Workspace& workspace)
{
    const auto one = [](const std::shared_ptr<const EnvironmentMap>& map, const QString& why) {
        return map ? StageMaps{.levels = {map}} : StageMaps{.why = why};
    };
    // Each level keeps all of them alive; none is copied.
    const auto all = [](const MapLevels& levels, const QString& why) {
        StageMaps result{.why = why};
        for (size_t i = 0; levels && i < levels->size(); ++i)
            result.levels.push_back(std::shared_ptr<const EnvironmentMap>(levels, &(*levels)[i]));
        return result;
    };
    if (stage == MapStage::Error)
        return one(workspace.methodError.map(),
                   MapPanel::tr("No method is picked. Click a point in the Report panel to see the signed error of its map here."));
    const auto made = workspace.live.made();
    if (!made)
        return {.why = MapPanel::tr("The maps are being made.")};
    switch (stage) {
    case MapStage::Probe:
        return one(made->environment, made->plan.needsProbe()
                                          ? MapPanel::tr("The probe is too large to hold: it was filtered while it was read.")
                                          : MapPanel::tr("Nothing in the scene needs the probe, so it was not read."));
    case MapStage::Specular:
        return all(made->maps.specular, whyLeftOut("specular map", made->plan));
    case MapStage::Diffuse:
        return all(made->maps.diffuse, whyLeftOut("irradiance map", made->plan));
    default:
        return all(made->maps.background, whyLeftOut("background", made->plan));
    }
}

} // namespace mirrorball::studio
