#pragma once

#include "report.h"

#include "core/base/job.h"
#include "core/filter/filter_source.h"
#include "reference_samples.h"

#include <memory>
#include <vector>

/// Error against run time of every method for one material, setting by setting: what is measured while somebody waits for it. A report
/// (error_time.h) measures the same more thoroughly.
namespace mirrorball {

struct MethodRaceOptions {
    MapLayout target{.kind = Parameterization::Cube, .size = 64};
    double tolerance = 1e-3; ///< among the settings of the methods that have one
    int directions = 128;    ///< at which the reference is summed
    int repeats = 3;         ///< timed runs of a setting; the median counts
    double longest = 1.0;    ///< seconds; a setting predicted to take longer is left out
};

/// One setting, measured.
struct RacePoint {
    MethodSetting setting{};
    MeasurementState state = MeasurementState::Measured;
    std::string why{};         ///< why refused, left out or failed
    Method ran = Method::Auto; ///< what auto chose
    double seconds = 0.0;      ///< median; spectrum or pyramid included
    bool scaled = false;       ///< the time was measured at a part of the texels
    ErrorMetrics error{};
    double predictedSeconds = 0.0, predictedError = 0.0;
    std::shared_ptr<const EnvironmentMap> map{}; ///< null for the reference, which is known at some texels only
};

/// The field, the reference and the settings that are to run. One thread at a time.
class MethodRace {
public:
    /// Sums the reference. @throws InvalidArgument for a streamed probe or a mirror, whose map nothing filters; Cancelled
    MethodRace(FilterSource probe, Lobe lobe, const MethodRaceOptions& options, const JobControl& job = {});

    /// What measure() is called with, cheap methods first.
    const std::vector<MethodSetting>& settings() const { return m_settings; }
    /// The reference itself, its time scaled to all texels.
    RacePoint reference() const;
    /// @throws Cancelled
    RacePoint measure(const MethodSetting& setting, const JobControl& job = {}) const;
    /// What measuring all settings is expected to take, in seconds of the clock, as busy as the machine was when the race was made.
    double expectedSeconds() const { return m_expectedSeconds; }
    const Lobe& lobe() const { return m_lobe; }
    const MethodRaceOptions& options() const { return m_options; }

private:
    FilterSource m_probe;
    Lobe m_lobe;
    MethodRaceOptions m_options;
    ReferenceSamples m_reference{};
    std::vector<MethodSetting> m_settings{};
    double m_expectedSeconds = 0.0;
};

/// A map minus the best that is known of it: mostExactMap() in the map's layout. @throws as that
EnvironmentMap signedError(FilterSource probe, const Lobe& lobe, const EnvironmentMap& map, const JobControl& job = {});

/// Whether each point is on the front: measured, and no other is both faster and more accurate.
std::vector<bool> onFront(const std::vector<RacePoint>& points);

} // namespace mirrorball
