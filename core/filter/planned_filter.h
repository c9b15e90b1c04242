#pragma once

#include "prefilter.h"

#include "core/base/stage.h"

namespace mirrorball {

/// One filter with what was decided of it, before the probe is read: made once, and handed on to whoever says what it costs, makes it,
/// or keeps what it made.
struct PlannedFilter {
    PrefilterOptions options{};
    PrefilterPlan plan{};
    StageCost spectrum{};  ///< of the forward transform that it begins with, which later filters share; none where it needs none
    StageCost filtering{}; ///< with that there already

    /// The plan follows from the options, and from the probe, which is the same for all filters of a scene.
    bool operator==(const PlannedFilter& other) const { return options == other.options; }
};

/// @param probeWidth  columns of the probe's latlong form. @throws as planPrefilter()
PlannedFilter planFilter(const PrefilterOptions& options, int probeWidth);

} // namespace mirrorball
