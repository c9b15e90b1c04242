#include "probe_resampling.h"

namespace mirrorball {

Probe readResampled(ProbeFile file, const ReprojectOptions& options, const JobControl& job)
{
    const Detection& detection = file.detection();
    if (file.isBuiltin() || detection.orientation != glm::dmat3(1.0) || detection.arrangement != Arrangement::Whole ||
        !detection.faces.empty() || !canReprojectRows(detection.layout, options)) {
        Probe result = file.read(job);
        result.map = timedStage(result.stages, "resample", [&] { return reproject(result.map, options, job); });
        return result;
    }
    Probe result{.origin = detection.reason, .certain = detection.certain};
    result.assumed = allAssumed(file.rows().info(), detection);
    result.notes = allNotes(file.rows().info(), detection);
    result.certain = result.certain && isCertain(result.assumed);
    result.map = timedStage(result.stages, "read and resample", [&] {
        const auto readRows = [&](int firstRow, int rows, float* rgb) { file.rows().readRows(firstRow, rows, rgb); };
        return reprojectRows(detection.layout, readRows, options, job);
    });
    result.repaired = file.rows().report();
    result.stages.back().why = describe(result.repaired);
    return result;
}

} // namespace mirrorball
