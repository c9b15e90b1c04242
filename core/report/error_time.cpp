#include "error_time.h"

#include "peak_memory.h"
#include "reference_samples.h"
#include "seam_ratio.h"
#include "thumbnails.h"
#include "verdicts.h"

#include "core/base/error.h"
#include "core/filter/band_limit.h"
#include "core/image/mip_pyramid.h"

#include <algorithm>
#include <map>
#include <new>

namespace mirrorball {

namespace {

constexpr int pictureHeight = 80;

/// Runs shorter than this are repeated after a first one that warms up.
constexpr double longRun = 0.5;

/// Seam ratios are measured at smaller maps too where those cost less than this.
constexpr double cheapRun = 1.0;

double sum(const glm::dvec3& rgb) { return rgb.r + rgb.g + rgb.b; }

/// How long runs of a setting may take together, by its first run, which warms up where it was short and else counts.
struct RunLimits {
    bool countsFirst;
    int times;        ///< at most, after the first
    double limit;     ///< seconds, after the first
    double nextLimit; ///< of further lobes, which are run `repeats` times at most
    bool smallerMaps; ///< are filtered, too, for their seams
};
RunLimits runLimits(double first, const ErrorTimeOptions& options)
{
    const bool isLong = first > longRun;
    const int after = 2.0 * first <= options.longest ? options.repeats - 1 : 0;
    return {.countsFirst = isLong,
            .times = isLong ? after : options.repeats,
            .limit = isLong ? options.longest - first : options.longest,
            .nextLimit = isLong ? 0.0 : options.longest,
            .smallerMaps = first <= cheapRun};
}

/// Every setting but the reference, which is not run setting by setting.
std::vector<MethodSetting> settingsOf(const ErrorTimeOptions& options)
{
    std::vector<MethodSetting> settings;
    for (const Method method : options.methods)
        if (method != Method::Reference)
            for (MethodSetting& setting : methodSettings(method, options.sweep, options.tolerance))
                settings.push_back(std::move(setting));
    return settings;
}

/// Maps of half the size, a quarter, ...
std::vector<MapLayout> smallerMaps(const MapLayout& target)
{
    std::vector<MapLayout> layouts;
    for (int level = 1; target.size >> level >= 4; ++level)
        layouts.push_back(levelLayout(target, level));
    return layouts;
}

/// One setting after the other, with what they share.
class Bench {
public:
    Bench(const FilterSource& probe, const Lobe& lobe, const ErrorTimeOptions& options, const JobControl& job)
        : m_probe(probe), m_lobe(lobe), m_options(options), m_job{.stop = job.stop, .threads = job.threads},
          m_mean(sum(meanRadiance(*probe.latlong())))
    {
        m_memory.emplace();
        m_reference = referenceSamples(probe, lobe, options.target, options.directions, m_job);
        m_referencePeak = m_memory->bytes();
    }

    const ReferenceSamples& reference() const { return m_reference; }

    /// The sum at the samples, its time scaled to all texels of the map.
    Measurement measureReference(const std::string& name) const
    {
        const PrefilterOptions options = MethodSetting{.method = Method::Reference}.options(m_lobe, m_options.target);
        Measurement m{.setting = {.method = Method::Reference}, .ran = Method::Reference};
        const double texels = static_cast<double>(options.target.width()) * options.target.height();
        const PrefilterPlan plan = planPrefilter(options, traits(m_probe));
        m.filtered = plan.filtered;
        m.predictedSeconds = plan.predictedSeconds;
        m.times.seconds.push_back(m_reference.seconds * texels / static_cast<double>(m_reference.texels.size()));
        m.scaled = !m_reference.complete;
        m.peakBytes = m_referencePeak;
        m.command = filterCommand(name, options);
        return m;
    }

    struct Measured {
        Measurement measurement{};
        EnvironmentMap map{};
    };

    Measured measure(const MethodSetting& setting, const std::string& name)
    {
        const PrefilterOptions options = setting.options(m_lobe, m_options.target);
        Measured result{.measurement = {.setting = setting, .ran = setting.method, .command = filterCommand(name, options)}};
        Measurement& m = result.measurement;
        m.why = refusal(setting.method, options, traits(m_probe));
        if (!m.why.empty()) {
            m.state = MeasurementState::Refused;
            return result;
        }
        try {
            const PrefilterPlan plan = planPrefilter(options, traits(m_probe));
            m.predictedSeconds = plan.predictedSeconds;
            double& calibration = m_calibration.try_emplace(setting.method, 1.0).first->second;
            if (plan.predictedSeconds * calibration > m_options.longest) {
                m.state = MeasurementState::LeftOut;
                m.why = tooLong(plan.predictedSeconds * calibration, m_options.longest);
                return result;
            }
            run(options, m, result.map);
            if (plan.predictedSeconds > 0.0)
                calibration = m.times.shortest() / plan.predictedSeconds;
            judge(m, result.map);
        } catch (const Cancelled&) {
            throw;
        } catch (const InvalidArgument& error) { // a refusal that shows only when the probe has been looked at
            m.state = MeasurementState::Refused;
            m.why = error.what();
        } catch (const std::bad_alloc&) {
            m.state = MeasurementState::Failed;
            m.why = "not enough memory";
        } catch (const std::exception& error) {
            m.state = MeasurementState::Failed;
            m.why = error.what();
        }
        return result;
    }

    ExactMap standIn() const
    {
        FilterSource source = m_probe;
        return mostExactMap(source, m_lobe, m_options.target, m_job);
    }

private:
    void run(const PrefilterOptions& options, Measurement& m, EnvironmentMap& map)
    {
        FilterSource source = m_probe;
        PrefilterOutcome outcome;
        m_memory.emplace();
        const RunTime first = timeOf([&] { outcome = prefilter(source, options, m_job); });
        m.peakBytes = m_memory->bytes();
        const auto fromNothing = [&] {
            source = m_probe;
            return timeOf([&] { outcome = prefilter(source, options, m_job); });
        };
        const RunLimits limits = runLimits(first.wall, m_options);
        m.times = repeated(limits.times, limits.limit, fromNothing);
        if (limits.countsFirst)
            m.times.add(first);
        const auto again = [&] { return timeOf([&] { prefilter(source, options, m_job); }); };
        m.nextLobe = repeated(m_options.repeats, limits.nextLimit, again);
        m.ran = outcome.method;
        m.filtered = outcome.filtered;
        m.bandLimit = outcome.bandLimit;
        m.predictedError = informedErrors(outcome, options, m_informed, m_job).relRms;
        if (options.method == Method::Auto || !outcome.filtered)
            m.why = outcome.why;
        map = std::move(outcome.map);

        m.seamRatios.push_back(seamSteps(map).ratio());
        if (!limits.smallerMaps)
            return;
        PrefilterOptions smaller = options;
        for (const MapLayout& layout : smallerMaps(options.target)) {
            smaller.target = layout;
            m.seamRatios.push_back(seamSteps(prefilter(source, smaller, m_job).map).ratio());
        }
    }

    void judge(Measurement& m, const EnvironmentMap& map) const
    {
        m.error = errorAt(m_reference, map);
        m.energy = m_mean != 0.0 ? sum(meanRadiance(map)) / m_mean : 1.0;
    }

    const FilterSource& m_probe;
    FilterSource m_informed = m_probe; ///< keeps the spectrum that predictions look at, which no method is to find made
    const Lobe& m_lobe;
    const ErrorTimeOptions& m_options;
    JobControl m_job;
    double m_mean;
    std::optional<PeakMemory> m_memory{};
    ReferenceSamples m_reference{};
    std::optional<std::int64_t> m_referencePeak{};
    std::map<Method, double> m_calibration{}; ///< measured time over predicted, of the setting before
};

} // namespace

std::string tooLong(double seconds, double longest)
{
    return "a run is predicted to take " + shortNumber(seconds, 2) + " s, more than the " + shortNumber(longest, 2) +
           " s that a report gives it";
}

namespace {

/// What Bench::measure() is expected to take.
double expectedSettingSeconds(const MethodSetting& setting, const ProbeTraits& probe, const Lobe& lobe, const ErrorTimeOptions& options,
                              const Pace& pace)
{
    const PrefilterOptions filter = setting.options(lobe, options.target);
    if (!refusal(setting.method, filter, probe).empty())
        return 0.0;
    const auto seconds = [&](const MapLayout& target, const ProbeTraits& traits) {
        PrefilterOptions sized = filter;
        sized.target = target;
        return pace.seconds(predictedSeconds(setting.method, sized, traits));
    };
    const double first = seconds(options.target, probe);
    if (first > options.longest)
        return 0.0;
    ProbeTraits known = probe; // a further lobe finds what the first has made
    known.knownBandLimit = largestBandLimit;
    const double next = seconds(options.target, known);
    const RunLimits limits = runLimits(first, options);
    double sum = first + repeats(limits.times, limits.limit, first) * first + repeats(options.repeats, limits.nextLimit, next) * next;
    if (limits.smallerMaps)
        for (const MapLayout& smaller : smallerMaps(options.target))
            sum += seconds(smaller, known);
    return sum;
}

} // namespace

double expectedCaseSeconds(const ProbeTraits& probe, const Lobe& lobe, const ErrorTimeOptions& options, const Pace& pace)
{
    const double texels = static_cast<double>(options.target.width()) * options.target.height();
    const PrefilterOptions reference = MethodSetting{.method = Method::Reference}.options(lobe, options.target);
    double sum = pace.seconds(predictedSeconds(Method::Reference, reference, probe)) * std::min(1.0, options.directions / texels);
    for (const MethodSetting& setting : settingsOf(options))
        sum += expectedSettingSeconds(setting, probe, lobe, options, pace);
    return sum;
}

ReportCase measureCase(const FilterSource& probe, const std::string& name, const Lobe& lobe, const ErrorTimeOptions& options,
                       const JobControl& job)
{
    const std::vector<MethodSetting> settings = settingsOf(options);
    const bool withReference = std::find(options.methods.begin(), options.methods.end(), Method::Reference) != options.methods.end();
    const double steps = static_cast<double>(settings.size()) + 2.0;
    double done = 0.0;
    const auto step = [&] {
        if (job.progress)
            job.progress(static_cast<float>(++done / steps));
    };

    Bench bench(probe, lobe, options, job);
    step();
    ReportCase result{.lobe = lobe, .referenceDirections = bench.reference().weighted(), .referenceComplete = bench.reference().complete};
    std::vector<EnvironmentMap> maps;
    if (withReference) {
        result.measurements.push_back(bench.measureReference(name));
        maps.emplace_back();
    }
    for (const MethodSetting& setting : settings) {
        try {
            job.checkStop();
            Bench::Measured measured = bench.measure(setting, name);
            result.measurements.push_back(std::move(measured.measurement));
            maps.push_back(std::move(measured.map));
        } catch (const Cancelled&) {
            result.measurements.push_back({.setting = setting,
                                           .state = MeasurementState::LeftOut,
                                           .why = "the report was stopped",
                                           .ran = setting.method,
                                           .command = filterCommand(name, setting.options(lobe, options.target))});
            maps.emplace_back();
        }
        step();
    }
    markFront(result.measurements);
    if (job.stop.stop_requested())
        return result;

    try {
        ExactMap standIn = bench.standIn(); // its error is measured and shown
        result.standIn = std::move(standIn.how);
        result.standInError = errorAt(bench.reference(), standIn.map).relRms;
        result.picture = mapPicture(standIn.map, pictureHeight);
        for (const Method method : options.methods) {
            const Measurement* shown = workingSetting(result.measurements, method, options.tolerance);
            if (!shown || method == Method::Reference || method == Method::Auto)
                continue;
            const auto index = static_cast<size_t>(shown - result.measurements.data());
            ErrorPicture picture = errorPicture(maps[index], standIn.map, {Parameterization::Latlong, pictureHeight, 0});
            result.measurements[index].errorPicture = std::move(picture.png);
            result.measurements[index].errorPictureLimit = picture.limit;
        }
    } catch (const Cancelled&) { // the figures stay, the pictures are missing
    }
    step();
    return result;
}

} // namespace mirrorball
