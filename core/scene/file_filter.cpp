#include "file_filter.h"

#include "core/base/error.h"
#include "core/filter/spectrum_file.h"

#include <utility>

namespace mirrorball {

ReadingAndYaw yawApart(ProbeReading reading)
{
    const double yawDeg = std::exchange(reading.rotateDeg[0], 0.0);
    return {std::move(reading), yawDeg};
}

PlannedFileFilter planFileFilter(FileFilterOptions options, const JobControl& job)
{
    PlannedFileFilter planned{.options = std::move(options)};
    const FileFilterOptions& o = planned.options;
    if (!isSpectrumFile(o.probe)) {
        planned.file.emplace(o.probe, o.read);
    } else {
        if (o.read.reading != ProbeReading{})
            throw InvalidArgument("PROBE: a spectrum knows how its probe was read; give part, layer and the like to `mirrorball spectrum`");
        planned.spectrum = openSpectrum(o.probe, job);
    }
    const MapLayout layout =
        planned.file ? planned.file->layout() : MapLayout{.kind = Parameterization::Latlong, .size = planned.spectrum->source.height()};
    planned.plan = timedStage(planned.record.stages, "plan", [&] { return planFilters(o.probe, layout, o.levels, o.file); });
    return planned;
}

BuiltMap filterFile(PlannedFileFilter planned, const JobControl& job)
{
    const FileFilterOptions& o = planned.options;
    OpenedSource opened = planned.file ? openFilterSource(*planned.file, o.levels, partOf(job, 0.0f, 0.3f)) : std::move(*planned.spectrum);
    opened.source.useParaboloidDevice(o.device);
    WorkRecord record = std::move(planned.record);
    record += {.stages = std::move(opened.stages), .notes = std::move(opened.notes)};
    SceneProbe probe{.source = std::move(opened.source)};
    BuiltMap built = buildMap(planned.plan.exports.front().map, probe, 0.0, partOf(job, 0.3f, 1.0f));
    record += std::move(built.record);
    built.record = std::move(record);
    return built;
}

} // namespace mirrorball
