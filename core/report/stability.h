#pragma once

#include "error_metrics.h"

#include "core/base/job.h"
#include "core/filter/prefilter.h"

#include <functional>
#include <optional>
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
    double tolerance = 1e-5;
    std::optional<double> constant{};                          ///< of a constant probe: the radiance that must come out
    bool nonNegative = true;                                   ///< the probe has no negative texel
    std::function<glm::dvec3(const glm::dvec3& r)> expected{}; ///< closed form, where the probe has one; empty: the reference sum
};

std::vector<StabilityCase> stabilityCases(StabilityScale scale = StabilityScale::Small);

/// What a method may do at most: one that holds a tolerance, within that; one that approximates, within what it predicts of itself. A
/// method's ringing is bounded by its kernel's negative part.
struct StabilityBounds {
    std::optional<double> tolerance{};  ///< factor of the case's tolerance that rel_rms keeps within
    std::optional<double> prediction{}; ///< factor of the predicted error that rel_rms keeps within, where there is no tolerance
    double energy = 0.0;                ///< largest |energy - 1|
    double negative = 0.0;              ///< largest -lowest, see StabilityRow
};
/// @param predictedError  the method's own, see informedErrors()
StabilityBounds stabilityBounds(Method method, const StabilityCase& test, double predictedError);

/// What a method did in a case.
struct StabilityRow {
    std::string name{};
    Method method = Method::Auto;
    std::string refused{}; ///< the reason, where the method cannot do the case; the rest is then empty
    bool finite = true;
    ErrorMetrics error{};
    double predictedError = 0.0;
    double energy = 1.0;        ///< mean of the map over the mean of what is expected
    double lowest = 0.0;        ///< smallest value of the map over the largest expected one; negative: ringing
    double constantError = 0.0; ///< largest |value / constant - 1|; 0 where the probe is not constant
    double seconds = 0.0;
    std::vector<std::string> failures{}; ///< what does not hold, in words

    bool holds() const { return failures.empty(); }
};

/// Runs one method through one case and judges the outcome: finite, within the tolerance, energy kept, a constant kept to 1e-6, not
/// negative.
/// @param device  for the paraboloid method; null: the CPU
/// @throws Cancelled
StabilityRow runStability(const StabilityCase& test, Method method, const JobControl& job = {},
                          std::shared_ptr<ParaboloidDevice> device = nullptr);

} // namespace mirrorball
