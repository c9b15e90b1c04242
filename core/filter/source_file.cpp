#include "source_file.h"

#include <algorithm>
#include <sstream>

namespace mirrorball {

namespace {

/// Whether the file can and should be streamed; if so, the band limit that all jobs need, else -1.
int streamedBandLimit(const ProbeFile& probe, std::span<const PrefilterOptions> jobs)
{
    const MapLayout& layout = probe.layout();
    if (probe.isBuiltin() || probe.detection().arrangement != Arrangement::Whole || layout.kind != Parameterization::Latlong ||
        std::int64_t{layout.width()} * layout.height() <= streamedFrom)
        return -1;
    int bandLimit = 0;
    for (const PrefilterOptions& filter : jobs) {
        if (filter.method != Method::Auto && filter.method != Method::Spectral)
            return -1;
        if (filter.lobe.isMirror() || isUnresolved(filter.lobe, layout.width()))
            return -1;
        bandLimit = std::max(bandLimit, planPrefilter(filter, {.width = layout.width(), .streamed = true}).bandLimit);
    }
    return bandLimit;
}

/// Every row, truncated to the band limit as it arrives; repairs are counted.
Spectrum streamedSpectrum(ProbeFile& probe, int bandLimit, const JobControl& job, RepairReport& repaired)
{
    const int width = probe.layout().width(), height = probe.layout().height();
    SpectrumBuilder builder(width, height, bandLimit);
    constexpr int block = 64;
    std::vector<float> rows(static_cast<size_t>(block) * static_cast<size_t>(width) * 3);
    JobControl inner = job;
    inner.progress = nullptr;
    for (int y = 0; y < height; y += block) {
        const int count = std::min(block, height - y);
        probe.rows().readRows(y, count, rows.data());
        repaired += repairRows(rows.data(), width, count, probe.negatives());
        builder.addRows(y, count, rows.data(), inner);
        if (job.progress)
            job.progress(static_cast<float>(y + count) / static_cast<float>(height));
    }
    return builder.finish(job);
}

} // namespace

OpenedSource openFilterSource(ProbeFile& probe, std::span<const PrefilterOptions> jobs, const JobControl& job)
{
    std::vector<Stage> stages;
    const int bandLimit = streamedBandLimit(probe, jobs);
    if (bandLimit >= 0) {
        RepairReport repaired;
        Spectrum spectrum =
            timedStage(stages, "read probe into spectrum", [&] { return streamedSpectrum(probe, bandLimit, job, repaired); });
        std::ostringstream why;
        why << probe.layout().width() << " x " << probe.layout().height() << ": rows are truncated to band limit " << bandLimit
            << " while they are read";
        stages.back().why = why.str();
        stages.push_back({.name = "hold the probe", .leftOut = true, .why = "only its spectrum is needed"});
        return {FilterSource(std::move(spectrum)), repaired, probe.detection().reason, true, std::move(stages)};
    }

    Probe whole = probe.read(job);
    stages = std::move(whole.stages);
    if (whole.map.layout.kind == Parameterization::Latlong) {
        stages.push_back({.name = "resample to latlong", .leftOut = true, .why = "the probe is one"});
        return {FilterSource(std::move(whole.map), job), whole.repaired, whole.origin, false, std::move(stages)};
    }
    FilterSource source = timedStage(stages, "resample to latlong", [&] { return FilterSource(std::move(whole.map), job); });
    std::ostringstream why;
    why.precision(2);
    why << "the filters run over " << source.width() << " x " << source.height()
        << " latlong texels; that step's own error at the probe's texels is rel_rms " << source.resamplingError();
    stages.back().why = why.str();
    return {std::move(source), whole.repaired, whole.origin, false, std::move(stages)};
}

} // namespace mirrorball
