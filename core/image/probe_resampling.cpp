#include "probe_resampling.h"

namespace mirrorball {

Probe readResampled(ProbeFile file, const ReprojectOptions& options, const JobControl& job)
{
    const Detection& detection = file.detection();
    if (file.isBuiltin() || detection.arrangement != Arrangement::Whole || !canReprojectRows(detection.layout, options)) {
        Probe result = file.read(job);
        result.map = timedStage(result.stages, "resample", [&] { return reproject(result.map, options, job); });
        return result;
    }
    Probe result{.origin = detection.reason, .certain = detection.certain};
    result.map = timedStage(result.stages, "read and resample", [&] {
        const auto readRows = [&](int firstRow, int rows, float* rgb) {
            file.rows().readRows(firstRow, rows, rgb);
            result.repaired += repairRows(rgb, detection.layout.width(), rows, file.negatives());
        };
        return reprojectRows(detection.layout, readRows, options, job);
    });
    result.stages.back().why = describe(result.repaired);
    return result;
}

} // namespace mirrorball
