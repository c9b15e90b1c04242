#include "source_file.h"

#include "core/image/layout_detection.h"

#include <algorithm>
#include <sstream>

namespace mirrorball {

namespace {

constexpr std::string_view builtinPrefix = "builtin:";

/// Whether the file can and should be streamed; if so, the band limit that all jobs need, else -1.
int streamedBandLimit(const ImageFileInfo& info, const ReadProbeOptions& options, std::span<const PrefilterOptions> jobs)
{
    const Detection detection = detectLayout(info, options.from);
    if (detection.arrangement != Arrangement::Whole || detection.layout.kind != Parameterization::Latlong ||
        std::int64_t{info.width} * info.height <= streamedFrom)
        return -1;
    int bandLimit = 0;
    for (const PrefilterOptions& filter : jobs) {
        if (filter.method != Method::Auto && filter.method != Method::Spectral)
            return -1;
        if (filter.lobe.isMirror() || isUnresolved(filter.lobe, info.width))
            return -1;
        bandLimit = std::max(bandLimit, planPrefilter(filter, {.width = info.width, .streamed = true}).bandLimit);
    }
    return bandLimit;
}

} // namespace

OpenedSource openFilterSource(const std::string& probe, const ReadProbeOptions& options, std::span<const PrefilterOptions> jobs,
                              const JobControl& job, std::vector<Stage>& stages)
{
    if (!probe.starts_with(builtinPrefix)) {
        const auto reader = openImage(probe);
        const ImageFileInfo& info = reader->info();
        const int bandLimit = streamedBandLimit(info, options, jobs);
        if (bandLimit >= 0) {
            RepairReport repaired;
            Spectrum spectrum = timedStage(stages, "read probe into spectrum", [&] {
                SpectrumBuilder builder(info.width, info.height, bandLimit);
                constexpr int block = 64;
                std::vector<float> rows(static_cast<size_t>(block) * static_cast<size_t>(info.width) * 3);
                for (int y = 0; y < info.height; y += block) {
                    const int count = std::min(block, info.height - y);
                    reader->readRows(y, count, rows.data());
                    repaired += repairRows(rows.data(), info.width, count, options.negatives);
                    JobControl inner = job;
                    inner.progress = nullptr;
                    builder.addRows(y, count, rows.data(), inner);
                    if (job.progress)
                        job.progress(static_cast<float>(y + count) / static_cast<float>(info.height));
                }
                return builder.finish(job);
            });
            std::ostringstream why;
            why << info.width << " x " << info.height << ": rows are truncated to band limit " << bandLimit << " while they are read";
            stages.back().why = why.str();
            stages.push_back({.name = "hold the probe", .leftOut = true, .why = "only its spectrum is needed"});
            return {FilterSource(std::move(spectrum)), repaired, detectLayout(info, options.from).reason, true};
        }
    }

    Probe whole = readProbe(probe, options, job, stages);
    const bool latlong = whole.map.layout.kind == Parameterization::Latlong;
    if (latlong) {
        stages.push_back({.name = "resample to latlong", .leftOut = true, .why = "the probe is one"});
        return {FilterSource(std::move(whole.map), job), whole.repaired, whole.origin, false};
    }
    FilterSource source = timedStage(stages, "resample to latlong", [&] { return FilterSource(std::move(whole.map), job); });
    std::ostringstream why;
    why.precision(2);
    why << "the filters run over " << source.width() << " x " << source.height()
        << " latlong texels; that step's own error at the probe's texels is rel_rms " << source.resamplingError();
    stages.back().why = why.str();
    return {std::move(source), whole.repaired, whole.origin, false};
}

} // namespace mirrorball
