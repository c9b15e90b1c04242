#include "verdicts.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

bool competes(const Measurement& m)
{
    return m.state == MeasurementState::Measured && m.setting.method != Method::Auto && m.setting.method != Method::Reference &&
           std::isfinite(m.error.relRms);
}

/// Settings of one method that are worth their time, from cheap to dear: each more accurate than all cheaper ones.
std::vector<const Measurement*> worthwhile(std::span<const Measurement> measurements, Method method)
{
    std::vector<const Measurement*> sorted;
    for (const Measurement& m : measurements)
        if (m.state == MeasurementState::Measured && m.setting.method == method && std::isfinite(m.error.relRms))
            sorted.push_back(&m);
    std::sort(sorted.begin(), sorted.end(), [](auto a, auto b) { return a->times.median() < b->times.median(); });
    std::vector<const Measurement*> kept;
    for (const Measurement* m : sorted)
        if (kept.empty() || m->error.relRms < kept.back()->error.relRms)
            kept.push_back(m);
    return kept;
}

} // namespace

void markFront(std::span<Measurement> measurements)
{
    for (Measurement& m : measurements) {
        m.onFront = competes(m);
        for (const Measurement& other : measurements)
            if (&other != &m && competes(other)) {
                const double time = m.times.median(), error = m.error.relRms;
                const double otherTime = other.times.median(), otherError = other.error.relRms;
                if (otherTime <= time && otherError <= error && (otherTime < time || otherError < error))
                    m.onFront = false;
            }
    }
}

std::optional<TimeForError> timeForError(std::span<const Measurement> measurements, Method method, double relRms)
{
    const std::vector<const Measurement*> settings = worthwhile(measurements, method);
    if (settings.empty())
        return std::nullopt;
    for (size_t i = 0; i < settings.size(); ++i) {
        if (settings[i]->error.relRms > relRms)
            continue;
        const double time = settings[i]->times.median();
        if (i == 0 || settings[i]->error.relRms <= 0.0)
            return TimeForError{time};
        const double cheaper = settings[i - 1]->times.median();
        const double share =
            std::log(settings[i - 1]->error.relRms / relRms) / std::log(settings[i - 1]->error.relRms / settings[i]->error.relRms);
        return TimeForError{cheaper * std::pow(time / cheaper, share)};
    }
    return TimeForError{settings.back()->times.median(), false};
}

const Measurement* workingSetting(std::span<const Measurement> measurements, Method method, double tolerance)
{
    const std::vector<const Measurement*> settings = worthwhile(measurements, method);
    for (const Measurement* m : settings)
        if (m->error.relRms <= tolerance)
            return m;
    return settings.empty() ? nullptr : settings.back();
}

std::optional<Verdict> verdict(const ReportCase& measured, double tolerance)
{
    const auto& all = measured.measurements;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& m) {
        return m.setting.method == Method::Auto && m.setting.tolerance == tolerance && m.state == MeasurementState::Measured;
    });
    if (found == all.end())
        return std::nullopt;
    Verdict v{.probe = measured.probe,
              .lobe = measured.lobe,
              .tolerance = tolerance,
              .autoError = found->error.relRms,
              .autoSeconds = found->times.median(),
              .autoRan = found->ran};
    for (const Measurement& m : all)
        if (competes(m) && m.error.relRms <= tolerance && (!v.fastest || m.times.median() < v.fastestSeconds)) {
            v.fastest = m.setting.method;
            v.fastestSetting = m.setting.label;
            v.fastestSeconds = m.times.median();
        }
    const auto spectral = timeForError(all, Method::Spectral, tolerance);
    if (spectral && spectral->reached && spectral->seconds > 0.0) {
        if (const auto importance = timeForError(all, Method::Importance, tolerance)) {
            v.importanceRatio = importance->seconds / spectral->seconds;
            v.importanceRatioIsBound = !importance->reached;
        }
        if (const auto reference = timeForError(all, Method::Reference, tolerance))
            v.referenceRatio = reference->seconds / spectral->seconds;
    }
    return v;
}

} // namespace mirrorball
