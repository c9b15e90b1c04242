#include "source_file.h"

#include "band_limit.h"
#include "bright_texels.h"
#include "spectral.h"

#include <algorithm>
#include <sstream>

namespace mirrorball {

namespace {

/// Whether the file can and should be streamed; if so, the band limit that all jobs need, else -1.
int bandLimitOfAll(const ProbeFile& probe, std::span<const PrefilterOptions> jobs)
{
    const MapLayout& layout = probe.layout();
    if (probe.isBuiltin() || probe.detection().orientation != glm::dmat3(1.0) || probe.detection().arrangement != Arrangement::Whole ||
        layout.kind != Parameterization::Latlong || std::int64_t{layout.width()} * layout.height() <= streamedFrom)
        return -1;
    int bandLimit = 0;
    for (const PrefilterOptions& filter : jobs) {
        if (filter.method != Method::Auto && filter.method != Method::Spectral)
            return -1;
        if (filter.lobe.isMirror() || isUnresolved(filter.lobe, layout.width()))
            return -1;
        bandLimit = std::max(bandLimit, streamedBandLimit(filter));
    }
    return bandLimit;
}

/// Every row, truncated to the band limit as it arrives.
FilterSource streamedSource(ProbeFile& probe, int bandLimit, const JobControl& job)
{
    const int width = probe.layout().width(), height = probe.layout().height();
    auto builder = std::make_shared<SpectrumBuilder>(width, height, bandLimit);
    BrightTexelFinder brightest(probe.layout());
    constexpr int block = 64;
    std::vector<float> rows(static_cast<size_t>(block) * static_cast<size_t>(width) * 3);
    JobControl inner = job;
    inner.progress = nullptr;
    for (int y = 0; y < height; y += block) {
        const int count = std::min(block, height - y);
        probe.rows().readRows(y, count, rows.data());
        builder->addRows(y, count, rows.data(), inner);
        brightest.addRows(y, count, rows.data());
        if (job.progress)
            job.progress(static_cast<float>(y + count) / static_cast<float>(height));
    }
    return FilterSource(std::move(builder), std::move(brightest));
}

} // namespace

int streamedBandLimit(const PrefilterOptions& filter)
{
    // A lobe with a kink has no end of its own; its bright texels are taken out from the start.
    const double dark = splitsBrightTexels(filter.lobe) ? 1.0 : 1e-3;
    for (int length = firstCoefficients;; length = std::min(2 * length, largestBandLimit)) {
        const int bandLimit = planBandLimit(legendreCoefficients(filter.lobe, length), dark * filter.tolerance).bandLimit;
        if (2 * bandLimit <= length || splitsBrightTexels(filter.lobe) || length == largestBandLimit)
            return bandLimit;
    }
}

OpenedSource openFilterSource(ProbeFile& probe, std::span<const PrefilterOptions> jobs, const JobControl& job)
{
    std::vector<Stage> stages;
    const int bandLimit = bandLimitOfAll(probe, jobs);
    if (bandLimit >= 0) {
        FilterSource source = timedStage(stages, "read probe into spectrum", [&] { return streamedSource(probe, bandLimit, job); });
        const ImageFileInfo& info = probe.rows().info();
        std::ostringstream why;
        why << probe.layout().width() << " x " << probe.layout().height() << ": rows are truncated to band limit " << bandLimit
            << " while they are read";
        if (const std::string chosen = summary(allAssumed(info, probe.detection())); !chosen.empty())
            why << "; " << chosen;
        stages.back().why = why.str();
        stages.push_back({.name = "hold the probe", .leftOut = true, .why = "only its spectrum is needed"});
        return {
            std::move(source), probe.rows().report(), probe.detection().reason, true, std::move(stages), allNotes(info, probe.detection())};
    }

    Probe whole = probe.read(job);
    stages = std::move(whole.stages);
    if (whole.map.layout.kind == Parameterization::Latlong) {
        stages.push_back({.name = "resample to latlong", .leftOut = true, .why = "the probe is one"});
        return {FilterSource(std::move(whole.map), job), whole.repaired, whole.origin, false, std::move(stages), std::move(whole.notes)};
    }
    FilterSource source = timedStage(stages, "resample to latlong", [&] { return FilterSource(std::move(whole.map), job); });
    std::ostringstream why;
    why.precision(2);
    why << "the filters run over " << source.width() << " x " << source.height()
        << " latlong texels; that step's own error at the probe's texels is rel_rms " << source.resamplingError();
    stages.back().why = why.str();
    return {std::move(source), whole.repaired, whole.origin, false, std::move(stages), std::move(whole.notes)};
}

} // namespace mirrorball
