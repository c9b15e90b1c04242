#pragma once

#include "command.h"

#include "core/scene/scene_maps.h"

namespace mirrorball::cli {

/// The record of a scene's work: the stages that were done, with their times, and those that the plan left out.
inline Stats sceneStats(const Plan& plan, const WorkRecord& record, int threads)
{
    Stats stats{.stages = record.stages,
                .method = record.method.empty() ? "lookup" : record.method,
                .bandLimit = record.bandLimit,
                .predicted = record.predicted,
                .promised = record.promised,
                .threads = threads};
    for (const Stage& stage : plan.stages)
        if (stage.leftOut)
            stats.stages.push_back(stage);
    return stats;
}

} // namespace mirrorball::cli
