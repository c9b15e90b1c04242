#pragma once

#include "plan.h"
#include "scene_maps.h"

#include "core/base/job.h"
#include "core/filter/paraboloid.h"
#include "core/filter/source_file.h"
#include "core/image/probe_file.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A probe's file, or that of a spectrum, filtered into the levels of one map: what the command line and the Python module share.
namespace mirrorball {

/// A reading without its turn about Y, which comes last of all, and that turn: the filter does it on the way, exactly.
struct ReadingAndYaw {
    ProbeReading reading{};
    double yawDeg = 0.0;
};
ReadingAndYaw yawApart(ProbeReading reading);

struct FileFilterOptions {
    std::string probe{}; ///< file, builtin:NAME, or the file of a spectrum
    ReadProbeOptions read{};
    std::vector<PrefilterOptions> levels{};     ///< one a level, largest first
    std::string file{};                         ///< where the map will lie, for the plan's words; may be empty
    std::shared_ptr<ParaboloidDevice> device{}; ///< null: the paraboloid method runs on the CPU
};

/// A filter with its plan, and its probe opened for it.
struct PlannedFileFilter {
    FileFilterOptions options{};
    Plan plan{};
    std::optional<ProbeFile> file{};        ///< header read
    std::optional<OpenedSource> spectrum{}; ///< or this, which is little enough to be read before the plan
    WorkRecord record{};                    ///< what planning took
};

/// Opens the probe's header and plans. @throws FileError, InvalidArgument; Cancelled
PlannedFileFilter planFileFilter(FileFilterOptions options, const JobControl& job = {});

/// Reads and filters. The record tells of all of it, and has what of the file a user should know. @throws as prefilter(); FileError
BuiltMap filterFile(PlannedFileFilter planned, const JobControl& job = {});

} // namespace mirrorball
