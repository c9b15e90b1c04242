#include "method_race.h"

#include "pace.h"

#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/image/map_picture.h"

#include <algorithm>
#include <new>
#include <utility>

namespace mirrorball {

MethodRace::MethodRace(FilterSource probe, Lobe lobe, const MethodRaceOptions& options, const JobControl& job)
    : m_probe(std::move(probe)), m_lobe(std::move(lobe)), m_options(options)
{
    if (m_lobe.isMirror())
        throw InvalidArgument("lobe: the material is a mirror, whose map is the environment itself; nothing is filtered");
    if (!m_probe.latlong())
        throw InvalidArgument(
            "probe: it is too large to hold, so only the spectral method can filter it; compare methods on a smaller one");
    m_reference = referenceSamples(m_probe, m_lobe, options.target, options.directions, job);
    for (const Method method : allMethods)
        if (method != Method::Reference)
            for (MethodSetting& setting : methodSettings(method, Sweep::Few, options.tolerance))
                m_settings.push_back(std::move(setting));
    const auto predicted = [&](const MethodSetting& setting) {
        const PrefilterOptions filter = setting.options(m_lobe, options.target);
        return refusal(setting.method, filter, traits(m_probe)).empty() ? planPrefilter(filter, traits(m_probe)).predictedSeconds : 0.0;
    };
    const Pace pace = measurePace(job);
    std::vector<std::pair<double, MethodSetting>> order;
    for (MethodSetting& setting : m_settings) {
        const double seconds = predicted(setting), run = pace.seconds(seconds);
        if (seconds <= m_options.longest)
            m_expectedSeconds += repeats(m_options.repeats, m_options.longest, run) * run;
        order.emplace_back(seconds, std::move(setting));
    }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (size_t i = 0; i < order.size(); ++i)
        m_settings[i] = std::move(order[i].second);
}

RacePoint MethodRace::reference() const
{
    const double texels = static_cast<double>(m_options.target.width()) * m_options.target.height();
    RacePoint point{.setting = {.method = Method::Reference}, .ran = Method::Reference};
    point.seconds = m_reference.seconds * texels / static_cast<double>(m_reference.texels.size());
    point.scaled = !m_reference.complete;
    return point;
}

RacePoint MethodRace::measure(const MethodSetting& setting, const JobControl& job) const
{
    const PrefilterOptions options = setting.options(m_lobe, m_options.target);
    RacePoint point{.setting = setting, .ran = setting.method};
    point.why = refusal(setting.method, options, traits(m_probe));
    if (!point.why.empty()) {
        point.state = MeasurementState::Refused;
        return point;
    }
    try {
        const PrefilterPlan plan = planPrefilter(options, traits(m_probe));
        point.predictedSeconds = plan.predictedSeconds;
        if (plan.predictedSeconds > m_options.longest) {
            point.state = MeasurementState::LeftOut;
            point.why = "predicted to take " + shortNumber(plan.predictedSeconds, 2) + " s, more than the " +
                        shortNumber(m_options.longest, 2) + " s that a live comparison gives it";
            return point;
        }
        PrefilterOutcome outcome;
        FilterSource source = m_probe;
        const RunTimes times = repeated(m_options.repeats, m_options.longest, [&] {
            source = m_probe; // which holds nothing but the probe
            return timeOf([&] { outcome = prefilter(source, options, job); });
        });
        point.seconds = times.median();
        point.ran = outcome.method;
        point.predictedError = informedErrors(outcome, options, source, job).relRms;
        point.error = errorAt(m_reference, outcome.map);
        point.map = std::make_shared<const EnvironmentMap>(std::move(outcome.map));
    } catch (const Cancelled&) {
        throw;
    } catch (const InvalidArgument& error) { // a refusal that shows only when the probe has been looked at
        point.state = MeasurementState::Refused;
        point.why = error.what();
    } catch (const std::bad_alloc&) {
        point.state = MeasurementState::Failed;
        point.why = "not enough memory";
    }
    return point;
}

EnvironmentMap signedError(FilterSource probe, const Lobe& lobe, const EnvironmentMap& map, const JobControl& job)
{
    return difference(map, mostExactMap(probe, lobe, map.layout, job).map, job);
}

std::vector<bool> onFront(const std::vector<RacePoint>& points)
{
    const auto measured = [](const RacePoint& p) { return p.state == MeasurementState::Measured; };
    std::vector<bool> front;
    for (const RacePoint& p : points)
        front.push_back(measured(p) && std::none_of(points.begin(), points.end(), [&](const RacePoint& q) {
                            return measured(q) && q.seconds <= p.seconds && q.error.relRms <= p.error.relRms &&
                                   (q.seconds < p.seconds || q.error.relRms < p.error.relRms);
                        }));
    return front;
}

} // namespace mirrorball
