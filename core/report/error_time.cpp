#include "error_time.h"

#include "peak_memory.h"
#include "reference_samples.h"
#include "seam_ratio.h"
#include "thumbnails.h"
#include "verdicts.h"

#include "core/base/error.h"
#include "core/image/mip_pyramid.h"

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

    EnvironmentMap standIn(std::string& how) const
    {
        FilterSource source = m_probe;
        PrefilterOptions options;
        options.lobe = m_lobe;
        options.target = m_options.target;
        options.method = Method::Spectral;
        for (options.tolerance = 1e-6;; options.tolerance *= 10.0) // its error is measured and shown
            try {
                PrefilterOutcome outcome = prefilter(source, options, m_job);
                how = outcome.filtered ? "spectral at tolerance " + shortNumber(options.tolerance) : "the bilinear lookup";
                return std::move(outcome.map);
            } catch (const InvalidArgument&) { // the promise cannot be kept so tightly
                if (options.tolerance > 1e-3)
                    throw;
            }
    }

private:
    void run(const PrefilterOptions& options, Measurement& m, EnvironmentMap& map)
    {
        FilterSource source = m_probe;
        PrefilterOutcome outcome;
        m_memory.emplace();
        const double first = secondsOf([&] { outcome = prefilter(source, options, m_job); });
        m.peakBytes = m_memory->bytes();
        const auto fromNothing = [&] {
            source = m_probe;
            return secondsOf([&] { outcome = prefilter(source, options, m_job); });
        };
        m.times = first > longRun ? repeated(m_options.repeats - 1, m_options.longest - first, fromNothing)
                                  : repeated(m_options.repeats, m_options.longest, fromNothing);
        if (first > longRun)
            m.times.seconds.insert(m.times.seconds.begin(), first);
        const auto again = [&] { return secondsOf([&] { prefilter(source, options, m_job); }); };
        m.nextLobe = repeated(m_options.repeats, first > longRun ? 0.0 : m_options.longest, again);
        m.ran = outcome.method;
        m.filtered = outcome.filtered;
        m.bandLimit = outcome.bandLimit;
        m.predictedError = informedErrors(outcome, options, source, m_job).relRms;
        if (options.method == Method::Auto || !outcome.filtered)
            m.why = outcome.why;
        map = std::move(outcome.map);

        m.seamRatios.push_back(seamSteps(map).ratio());
        if (first > cheapRun)
            return;
        PrefilterOptions smaller = options;
        for (int level = 1; options.target.size >> level >= 4; ++level) {
            smaller.target = levelLayout(options.target, level);
            m.seamRatios.push_back(seamSteps(prefilter(source, smaller, m_job).map).ratio());
        }
    }

    void judge(Measurement& m, const EnvironmentMap& map) const
    {
        m.error = errorAt(m_reference, map);
        m.energy = m_mean != 0.0 ? sum(meanRadiance(map)) / m_mean : 1.0;
    }

    const FilterSource& m_probe;
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

ReportCase measureCase(const FilterSource& probe, const std::string& name, const Lobe& lobe, const ErrorTimeOptions& options,
                       const JobControl& job)
{
    std::vector<MethodSetting> settings;
    bool withReference = false;
    for (const Method method : options.methods) {
        withReference = withReference || method == Method::Reference;
        if (method != Method::Reference)
            for (MethodSetting& setting : methodSettings(method, options.sweep, options.tolerance))
                settings.push_back(std::move(setting));
    }
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
        const EnvironmentMap standIn = bench.standIn(result.standIn);
        result.standInError = errorAt(bench.reference(), standIn).relRms;
        result.picture = mapPicture(standIn, pictureHeight);
        for (const Method method : options.methods) {
            const Measurement* shown = workingSetting(result.measurements, method, options.tolerance);
            if (!shown || method == Method::Reference || method == Method::Auto)
                continue;
            const auto index = static_cast<size_t>(shown - result.measurements.data());
            ErrorPicture picture = errorPicture(maps[index], standIn, pictureHeight);
            result.measurements[index].errorPicture = std::move(picture.png);
            result.measurements[index].errorPictureLimit = picture.limit;
        }
    } catch (const Cancelled&) { // the figures stay, the pictures are missing
    }
    step();
    return result;
}

} // namespace mirrorball
