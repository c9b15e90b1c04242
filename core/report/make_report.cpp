#include "make_report.h"

#include "conclusions.h"
#include "cost_growth.h"
#include "error_time.h"
#include "parameterization_study.h"
#include "stability.h"
#include "thumbnails.h"
#include "verdicts.h"

#include "core/base/error.h"
#include "core/image/probe_file.h"
#include "core/image/probe_statistics.h"

#include <cmath>

namespace mirrorball {

namespace {

constexpr int probePictureHeight = 128;

/// Progress of a list of parts of known weight.
class Progress {
public:
    Progress(const JobControl& job, double total) : m_job(job), m_total(total) {}

    /// The job of the next part.
    JobControl part(double weight)
    {
        const double from = m_done;
        m_done += weight;
        JobControl inner = m_job;
        if (m_job.progress)
            inner.progress = [this, from, weight](float fraction) {
                m_job.progress(static_cast<float>((from + weight * static_cast<double>(fraction)) / m_total));
            };
        return inner;
    }

private:
    const JobControl& m_job;
    double m_total;
    double m_done = 0.0;
};

struct OpenProbe {
    ReportProbe record{};
    FilterSource source;
};

OpenProbe openProbe(const ReportOptions& options, const std::string& name, const JobControl& job)
{
    JobControl inner = job;
    inner.progress = nullptr;
    ProbeFile file(name, {});
    if (!file.isBuiltin()) {
        const ImageFileInfo& info = file.rows().info();
        if (std::int64_t{info.width} * info.height > largestReportProbe)
            throw InvalidArgument(
                name + ": has " + std::to_string(info.width) + " x " + std::to_string(info.height) +
                " texels, more than a report holds; give a smaller one, and --growth-to 16384 to see how large ones stream");
    }
    Probe probe = file.read(inner);
    const ProbeStatistics s = statistics(probe.map);
    ReportProbe record{.name = name,
                       .origin = probe.origin,
                       .sunShare = s.sunShare,
                       .meanLuminance = s.meanLuminance,
                       .maxLuminance = s.maxLuminance,
                       .repaired = probe.repaired,
                       .picture = mapPicture(probe.map, probePictureHeight)};
    FilterSource source(std::move(probe.map), inner);
    source.useParaboloidDevice(options.device);
    record.width = source.width();
    record.height = source.height();
    record.resamplingError = source.resamplingError();
    return {std::move(record), std::move(source)};
}

void measureStability(const ReportOptions& options, const JobControl& job, Report& report)
{
    JobControl inner = job;
    inner.progress = nullptr;
    const std::vector<StabilityCase> cases = stabilityCases(options.sweep == Sweep::Few ? StabilityScale::Small : StabilityScale::Large);
    size_t done = 0;
    for (const StabilityCase& test : cases) {
        for (const Method method : options.methods)
            report.stability.push_back(runStability(test, method, inner, options.device));
        if (job.progress)
            job.progress(static_cast<float>(++done) / static_cast<float>(cases.size()));
    }
    for (const ShadingCase& test : shadingCases())
        report.shading.push_back(runShading(test, inner));
}

} // namespace

ReportOptions quickReport(ReportOptions options)
{
    options.sweep = Sweep::Few;
    options.repeats = 2;
    options.longest = 0.5;
    options.directions = 128;
    options.growthTo = 0;
    return options;
}

void validate(const ReportOptions& options)
{
    if (options.probes.empty())
        throw InvalidArgument("PROBE: is missing; give a file or builtin:NAME");
    if (options.lobes.empty())
        throw InvalidArgument("lobes: at least one is needed, such as phong:50");
    if (options.methods.empty())
        throw InvalidArgument("methods: at least one is needed, such as auto");
    validate(options.target);
    ReportOptions::visitFields(options, [](const Field& field, const auto& value) {
        const auto number = static_cast<double>(value);
        if (!(number >= field.low && number <= field.high))
            throw InvalidArgument(std::string(field.name) + ": must lie in " + shortNumber(field.low, 6) + " to " +
                                  shortNumber(field.high, 6) + "; it is " + shortNumber(number, 6));
    });
    if (options.growthTo != 0 && options.growthTo < 256)
        throw InvalidArgument("growth-to: must be 0 or 256 to 16384 columns; it is " + std::to_string(options.growthTo));
}

Report makeReport(const ReportOptions& options, const JobControl& job)
{
    validate(options);
    Report report{.version = options.version,
                  .command = options.command,
                  .machine = thisMachine(),
                  .threads = job.threadCount(),
                  .device = options.deviceName,
                  .target = options.target,
                  .tolerance = options.tolerance,
                  .repeats = options.repeats,
                  .longest = options.longest,
                  .growthLobe = options.lobes.front()};
    const auto cases = static_cast<double>(options.probes.size() * options.lobes.size());
    const double growthWeight = options.growthTo == 0 ? 0.0 : 1.5 * std::exp2(std::max(0.0, std::log2(options.growthTo / 2048.0)));
    Progress progress(job, cases + (options.parameterizations ? 0.3 : 0.0) + growthWeight + (options.stability ? 1.0 : 0.0));
    const ErrorTimeOptions errorTime{.target = options.target,
                                     .methods = options.methods,
                                     .sweep = options.sweep,
                                     .tolerance = options.tolerance,
                                     .repeats = options.repeats,
                                     .longest = options.longest,
                                     .directions = options.directions};
    report.seconds = secondsOf([&] {
        try {
            for (const std::string& name : options.probes) {
                job.checkStop();
                const OpenProbe probe = openProbe(options, name, job);
                report.probes.push_back(probe.record);
                for (const Lobe& lobe : options.lobes) {
                    job.checkStop();
                    report.cases.push_back(measureCase(probe.source, name, lobe, errorTime, progress.part(1.0)));
                    report.cases.back().probe = report.probes.size() - 1;
                }
                if (report.probes.size() > 1)
                    continue;
                if (options.parameterizations)
                    report.parameterizations.push_back(studyParameterizations(probe.source, options.lobes.front(),
                                                                              options.target.width() * options.target.height(),
                                                                              options.directions, progress.part(0.3)));
                if (options.growthTo > 0)
                    report.growth = measureGrowth(probe.source,
                                                  {.methods = options.methods,
                                                   .lobe = options.lobes.front(),
                                                   .target = options.target,
                                                   .tolerance = options.tolerance,
                                                   .largestWidth = options.growthTo,
                                                   .repeats = std::min(options.repeats, 3),
                                                   .device = options.device,
                                                   .longest = options.longest},
                                                  progress.part(growthWeight));
            }
            if (options.stability)
                measureStability(options, progress.part(1.0), report);
            job.checkStop();
        } catch (const Cancelled&) {
            report.complete = false;
        }
    });
    report.loadAtEnd = thisMachine().load;
    for (const ReportCase& c : report.cases)
        if (const auto v = verdict(c, options.tolerance))
            report.verdicts.push_back(*v);
    report.conclusions = conclusions(report);
    return report;
}

} // namespace mirrorball
