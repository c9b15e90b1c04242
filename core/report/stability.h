#pragma once

#include "error_metrics.h"
#include "pace.h"

#include "core/base/job.h"
#include "core/filter/prefilter.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The extreme cases of filtering, and what must hold in each of them for every method that does not refuse it. The tests
/// and `report --stability` run the same table.
namespace mirrorball {

/// Small: every case on a probe of a few thousand texels, for tests. Large: also those whose point is their size (16384 x 8192).
enum class StabilityScale { Small, Large };

/// One case: a probe, a lobe and a target.
struct StabilityCase {
    std::string name{};                                      ///< "sun of 1e6 on a sky of 1e-3, phong:50"
    std::function<FilterSource(const JobControl&)> source{}; ///< makes the probe
    Lobe lobe{};
    MapLayout target{};
    MethodKnobs knobs{};
    double tolerance = 1e-5;                                   ///< what is asked for, by lobes with a kink, too
    std::optional<double> constant{};                          ///< of a constant probe: the radiance that must come out
    bool nonNegative = true;                                   ///< the probe has no negative texel
    std::function<glm::dvec3(const glm::dvec3& r)> expected{}; ///< closed form, where the probe has one; empty: the reference sum
};

std::vector<StabilityCase> stabilityCases(StabilityScale scale = StabilityScale::Small);

/// What a method that promises nothing may do at most, by what it says of itself. (One that keeps a tolerance is judged by the promise,
/// errorLimits().) A method's ringing is bounded by its kernel's negative part.
struct ApproximationBounds {
    double prediction = 1.0; ///< factor of the predicted error that rel_rms keeps within
    double energy = 0.0;     ///< largest |energy - 1|
    double negative = 0.0;   ///< largest -lowest, see StabilityRow
};
/// @param predictedError  the method's own, see informedErrors()
ApproximationBounds approximationBounds(Method method, double predictedError);

/// What a method did in a case.
struct StabilityRow {
    std::string name{};
    Method method = Method::Auto;
    std::string refused{}; ///< the reason, where the method cannot do the case or not keep the tolerance; the rest is then empty
    bool finite = true;
    ErrorMetrics error{};
    double predictedError = 0.0; ///< rel_rms
    bool promised = false;       ///< the tolerance
    double energy = 1.0;         ///< mean of the map over the mean of what is expected
    double lowest = 0.0;         ///< smallest value of the map over the largest expected one; negative: ringing
    double constantError = 0.0;  ///< largest |value / constant - 1|; 0 where the probe is not constant
    double seconds = 0.0;
    std::vector<std::string> failures{}; ///< what does not hold, in words

    bool holds() const { return failures.empty(); }
};

/// Judges a map: finite; the four promises of the tolerance where it was promised, else within what the method says of itself; energy kept;
/// a constant kept to 1e-6.
/// @param predictedError  see informedErrors()
StabilityRow judgeStability(const StabilityCase& test, const PrefilterOutcome& outcome, double predictedError,
                            const EnvironmentMap& expected);

/// Runs one method through one case and judges the outcome.
/// @param device  for the paraboloid method; null: the CPU
/// @throws Cancelled
StabilityRow runStability(const StabilityCase& test, Method method, const JobControl& job = {},
                          std::shared_ptr<ParaboloidDevice> device = nullptr);

/// What every case takes by each of these methods.
double expectedStabilitySeconds(std::span<const Method> methods, StabilityScale scale, const Pace& pace);

} // namespace mirrorball
