#pragma once

#include "environment_map.h"
#include "image_io.h"
#include "layout_detection.h"
#include "probe_statistics.h"
#include "repair.h"

#include "core/base/job.h"

#include <optional>
#include <string>
#include <vector>

/// Small pictures and figures of probes, for browsers of them. Files are streamed: memory holds some rows and the small image, whatever the
/// size of the file, but where surveyProbe() says otherwise.
namespace mirrorball {

struct ThumbnailOptions {
    int height = 128;       ///< of the latlong that thumbnailOf() makes, 1 to 1024 texels
    ProbeReading reading{}; ///< how the file is to be read
};

/// A probe's file or built-in scene, reduced by area averages in the arrangement that it has.
struct ReducedProbe {
    ImageFileInfo info{};  ///< of the file as it is; a built-in probe has a size and the format "builtin"
    Detection detection{}; ///< of the file as it is
    Image image{};         ///< the reduced image, in detection.arrangement
    RepairReport repaired{};
    bool fromMip = false; ///< reduced from a mip level of the file: `repaired` tells of that level only
};

/// Reads and reduces a probe until it is just finer than options.height asks for. A coarser mip level is read where the file has one.
/// @throws FileError, InvalidArgument, Cancelled
ReducedProbe reduceProbe(const std::string& probe, const ThumbnailOptions& options = {}, const JobControl& job = {});

/// A reduced probe as a latlong of the given height, read as `kind` where one is given: the picture of a guess.
/// @throws FileError when the shape does not fit that kind
EnvironmentMap thumbnailOf(const ReducedProbe& probe, int height, std::optional<Parameterization> kind = {}, const JobControl& job = {});

/// The parameterizations whose shape fits the file, the detected one first. More than one: offer the choice.
std::vector<Parameterization> possibleKinds(const ReducedProbe& probe);

/// What a probe holds, from all of its texels.
struct ProbeSurvey {
    ReducedProbe reduced{}; ///< never from a mip level
    ProbeStatistics statistics{};
};

/// One pass over the whole file. A foreign arrangement (cross, strip, edge-sampled) is held whole for its statistics, up to
/// 2^25 texels; beyond that its statistics are those of the reduced image.
/// @throws FileError, InvalidArgument, Cancelled
ProbeSurvey surveyProbe(const std::string& probe, const ThumbnailOptions& options = {}, const JobControl& job = {});

} // namespace mirrorball
