#include "make_report.h"

#include "conclusions.h"
#include "method_comparison.h"
#include "part_options.h"
#include "thumbnails.h"
#include "verdicts.h"

#include "core/base/error.h"
#include "core/image/probe_file.h"
#include "core/image/probe_statistics.h"

#include <chrono>
#include <cmath>

namespace mirrorball {

namespace {

constexpr int probePictureHeight = 128;

/// Progress of parts that are expected to take so long, and the times that they took.
class PartTimes {
public:
    PartTimes(const JobControl& job, const ReportForecast& forecast, std::vector<PartTime>& times)
        : m_job(job), m_total(std::max(forecast.seconds(), 1e-9)), m_times(times)
    {
        for (const ReportForecast::Part& part : forecast.parts)
            m_times.push_back({part.part, part.seconds, 0.0});
    }

    /// Does one of `pieces` equal pieces of a part. @param work  called with its job
    template <typename Work>
    void run(ReportPart part, size_t pieces, Work&& work)
    {
        m_job.checkStop();
        PartTime& time = *std::find_if(m_times.begin(), m_times.end(), [&](const PartTime& t) { return t.part == part; });
        const double from = m_done / m_total;
        m_done += time.foretold / static_cast<double>(pieces);
        const JobControl inner = partOf(m_job, static_cast<float>(from), static_cast<float>(std::min(1.0, m_done / m_total)));
        struct Clock {
            explicit Clock(double& sum_) : sum(sum_) {}
            ~Clock() { sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
            double& sum;
            const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        } const clock(time.seconds); // of work that was stopped, too
        work(inner);
    }

private:
    const JobControl& m_job;
    double m_total;
    double m_done = 0.0;
    std::vector<PartTime>& m_times;
};

struct OpenProbe {
    ReportProbe record{};
    FilterSource source;
};

OpenProbe openProbe(const ReportOptions& options, const std::string& name, const JobControl& job)
{
    const JobControl inner{.stop = job.stop, .threads = job.threads};
    Probe probe = readProbe(name, {.reading = options.reading}, inner);
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
    const JobControl inner{.stop = job.stop, .threads = job.threads};
    const std::vector<StabilityCase> cases = stabilityCases(stabilityScale(options));
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

/// The parts that look at one probe, the first.
void measureFirstProbe(const ReportOptions& options, const FilterSource& probe, PartTimes& times, Report& report)
{
    if (options.has(ReportPart::Parameterizations))
        times.run(ReportPart::Parameterizations, 1, [&](const JobControl& job) {
            report.parameterizations.push_back(studyParameterizations(probe, studyOptions(options), job));
        });
    if (options.has(ReportPart::Growth))
        times.run(ReportPart::Growth, 1, [&](const JobControl& job) { report.growth = measureGrowth(probe, growthOptions(options), job); });
    if (options.has(ReportPart::Kernels))
        times.run(ReportPart::Kernels, 1,
                  [&](const JobControl& job) { report.kernelTable = measureKernelTable(probe, kernelTableOptions(options), job); });
    if (options.has(ReportPart::Comparison))
        times.run(ReportPart::Comparison, 1,
                  [&](const JobControl& job) { report.comparison = compareMethods(*probe.latlong(), comparisonOptions(options), job); });
}

void measure(const ReportOptions& options, PartTimes& times, const JobControl& job, Report& report)
{
    const size_t cases = options.probes.size() * options.lobes.size();
    const bool looksAtProbes = std::any_of(options.parts.begin(), options.parts.end(), needsProbe);
    for (const std::string& name : options.probes) {
        const bool first = report.probes.empty();
        if (!looksAtProbes || (!first && !options.has(ReportPart::Methods)))
            break;
        job.checkStop();
        const OpenProbe probe = openProbe(options, name, job);
        report.probes.push_back(probe.record);
        if (options.has(ReportPart::Methods))
            for (const Lobe& lobe : options.lobes)
                times.run(ReportPart::Methods, cases, [&](const JobControl& part) {
                    report.cases.push_back(measureCase(probe.source, name, lobe, errorTimeOptions(options), part));
                    report.cases.back().probe = report.probes.size() - 1;
                });
        if (first)
            measureFirstProbe(options, probe.source, times, report);
    }
    if (options.has(ReportPart::Distortion))
        times.run(ReportPart::Distortion, 1, [&](const JobControl&) { report.distortion = distortionCurves(); });
    if (options.has(ReportPart::Stability))
        times.run(ReportPart::Stability, 1, [&](const JobControl& part) { measureStability(options, part, report); });
    job.checkStop();
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
    if (options.parts.empty())
        throw InvalidArgument("parts: at least one is needed, such as methods");
    if (options.probes.empty() && std::any_of(options.parts.begin(), options.parts.end(), needsProbe))
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
    report.seconds = secondsOf([&] {
        try {
            const ReportForecast forecast = forecastReport(options, measurePace(job));
            if (options.foretell)
                options.foretell(forecast);
            PartTimes times(job, forecast, report.parts);
            measure(options, times, job, report);
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
