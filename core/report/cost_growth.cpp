#include "cost_growth.h"

#include "error_time.h"
#include "peak_memory.h"
#include "resized_rows.h"

#include "core/base/error.h"
#include "core/filter/source_file.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <array>
#include <map>
#include <new>
#include <set>

namespace mirrorball {

namespace {

constexpr int blockRows = 64;
constexpr int narrowest = 256; ///< columns
constexpr std::array exponents{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

bool isStreamed(int width) { return std::int64_t{width} * width / 2 > streamedFrom; }

class Grower {
public:
    Grower(const CostGrowthOptions& options, const JobControl& job)
        : m_options(options), m_job{.stop = job.stop, .threads = job.threads}, m_progress(job.progress)
    {
        for (const Method method : options.methods)
            if (method != Method::Reference)
                m_methods.push_back(method);
    }

    std::vector<GrowthPoint> run(const FilterSource& probe)
    {
        std::vector<int> widths;
        for (int width = narrowest; width <= m_options.largestWidth; width *= 2)
            widths.push_back(width);
        const double steps = static_cast<double>(widths.size() + exponents.size());
        double done = 0.0;
        const auto step = [&] {
            if (m_progress)
                m_progress(static_cast<float>(++done / steps));
        };
        try {
            for (const double exponent : exponents) {
                for (const Method method : m_methods)
                    measure(GrowthAxis::Exponent, exponent, probe, phongLobe(exponent), method);
                step();
            }
            m_tooDear.clear();
            for (const int width : widths) {
                const MapLayout layout{Parameterization::Latlong, width / 2, 0};
                if (isStreamed(width)) {
                    stream(*probe.latlong(), layout);
                } else {
                    FilterSource resized(reproject(*probe.latlong(), {.target = layout}, m_job));
                    resized.useParaboloidDevice(m_options.device);
                    for (const Method method : m_methods)
                        measure(GrowthAxis::ProbeWidth, width, resized, m_options.lobe, method);
                }
                step();
            }
        } catch (const Cancelled&) { // what was measured stays
        }
        return std::move(m_points);
    }

private:
    PrefilterOptions usual(const Lobe& lobe, Method method) const
    {
        MethodSetting setting{.method = method, .tolerance = m_options.tolerance};
        return setting.options(lobe, m_options.target);
    }

    void measure(GrowthAxis axis, double at, const FilterSource& probe, const Lobe& lobe, Method method)
    {
        m_job.checkStop();
        GrowthPoint point{
            .axis = axis, .at = at, .method = method, .ran = method, .probeBytes = std::int64_t{12} * probe.width() * probe.height()};
        const PrefilterOptions options = usual(lobe, method);
        const auto leaveOut = [&](MeasurementState state, std::string why) {
            point.state = state;
            point.why = std::move(why);
            m_points.push_back(std::move(point));
        };
        if (std::string why = refusal(method, options, traits(probe)); !why.empty())
            return leaveOut(MeasurementState::Refused, std::move(why));
        if (axis == GrowthAxis::ProbeWidth && m_tooDear.contains(method))
            return leaveOut(MeasurementState::LeftOut, "the probe of half the width took too long already");
        try {
            const double predicted = planPrefilter(options, traits(probe)).predictedSeconds;
            if (predicted > m_options.longest)
                return leaveOut(MeasurementState::LeftOut, tooLong(predicted, m_options.longest));
            FilterSource source = probe;
            PrefilterOutcome outcome;
            const PeakMemory memory;
            const RunTime first = timeOf([&] { outcome = prefilter(source, options, m_job); });
            point.peakBytes = memory.bytes();
            point.times = repeated(m_options.repeats - 1, m_options.longest - first.wall, [&] {
                source = probe;
                return timeOf([&] { outcome = prefilter(source, options, m_job); });
            });
            if (m_options.repeats == 1 || first.wall > m_options.longest / 2)
                point.times.add(first);
            if (first.wall > m_options.longest)
                m_tooDear.insert(method);
            point.ran = outcome.method;
            point.filtered = outcome.filtered;
            m_points.push_back(std::move(point));
        } catch (const InvalidArgument& error) {
            leaveOut(MeasurementState::Refused, error.what());
        } catch (const std::bad_alloc&) {
            leaveOut(MeasurementState::Failed, "not enough memory");
        } catch (const WorkError& error) {
            leaveOut(MeasurementState::Failed, error.what());
        }
    }

    void stream(const EnvironmentMap& probe, const MapLayout& layout)
    {
        for (const Method method : m_methods) {
            GrowthPoint point{.axis = GrowthAxis::ProbeWidth, .at = static_cast<double>(layout.width()), .method = method, .ran = method};
            try {
                streamOnce(probe, layout, point);
            } catch (const InvalidArgument& error) {
                point.state = MeasurementState::Refused;
                point.why = error.what();
            }
            m_points.push_back(std::move(point));
        }
    }

    /// @throws InvalidArgument where the method cannot do it
    void streamOnce(const EnvironmentMap& probe, const MapLayout& layout, GrowthPoint& point)
    {
        const PrefilterOptions options = usual(m_options.lobe, point.method);
        const PrefilterPlan plan = planPrefilter(options, {.width = layout.width(), .streamed = true});
        if (!plan.filtered)
            throw InvalidArgument(plan.why);
        const PeakMemory memory;
        SpectrumBuilder builder(layout.width(), layout.height(), plan.bandLimit);
        RunTime taken;
        const auto timed = [&taken](auto&& work) {
            const RunTime run = timeOf(work);
            taken = {taken.wall + run.wall, taken.cpu + run.cpu};
        };
        for (int y = 0; y < layout.height(); y += blockRows) {
            const int count = std::min(blockRows, layout.height() - y);
            const std::vector<float> rows = resizedRows(probe, layout.width(), y, count, m_job);
            timed([&] { builder.addRows(y, count, rows.data(), m_job); });
        }
        PrefilterOutcome outcome;
        timed([&] {
            FilterSource source(builder.finish(m_job));
            outcome = prefilter(source, options, m_job);
        });
        point.peakBytes = memory.bytes();
        point.times.add(taken);
        point.streamed = true;
        point.ran = outcome.method;
    }

    const CostGrowthOptions& m_options;
    JobControl m_job;
    std::function<void(float)> m_progress;
    std::vector<Method> m_methods{};
    std::set<Method> m_tooDear{};
    std::vector<GrowthPoint> m_points{};
};

} // namespace

std::vector<GrowthPoint> measureGrowth(const FilterSource& probe, const CostGrowthOptions& options, const JobControl& job)
{
    return Grower(options, job).run(probe);
}

double expectedGrowthSeconds(const ProbeTraits& probe, const CostGrowthOptions& options, const Pace& pace)
{
    double sum = 0.0;
    const auto add = [&](const ProbeTraits& traits, const Lobe& lobe, Method method) {
        const PrefilterOptions filter = MethodSetting{.method = method, .tolerance = options.tolerance}.options(lobe, options.target);
        if (method == Method::Reference || !refusal(method, filter, traits).empty())
            return;
        const double first = pace.seconds(predictedSeconds(method, filter, traits));
        if (first <= options.longest)
            sum += first * (1 + repeats(traits.streamed ? 0 : options.repeats - 1, options.longest - first, first));
    };
    for (const Method method : options.methods) {
        for (const double exponent : exponents)
            add(probe, phongLobe(exponent), method);
        for (int width = narrowest; width <= options.largestWidth; width *= 2)
            add({.width = width, .streamed = isStreamed(width), .hasParaboloidDevice = probe.hasParaboloidDevice}, options.lobe, method);
    }
    for (int width = narrowest; width <= options.largestWidth; width *= 2)
        sum += pace.seconds(1e-7 * 0.5 * width * width);
    return sum;
}

} // namespace mirrorball
