#pragma once

#include "method.h"

#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

/// What a tolerance promises (DESIGN 4), and how an absolute error becomes the relative ones that it names.
namespace mirrorball {

/// The largest errors that a tolerance t allows, and how far below 0 a map of a non-negative probe may go.
struct ErrorLimits {
    double relRms;    ///< t
    double medianRel; ///< t
    double p99Rel;    ///< max(5 t, 1e-3)
    double negative;  ///< max(1e-3 t, 1e-7), times the mean
};
ErrorLimits errorLimits(double tolerance);

/// Error of a map as it is predicted: see ErrorMetrics, which is how it is measured.
struct PredictedErrors {
    double relRms = 0.0;
    double medianRel = 0.0;
    double p99Rel = 0.0;

    bool within(const ErrorLimits& limits) const
    {
        return relRms <= limits.relRms && medianRel <= limits.medianRel && p99Rel <= limits.p99Rel;
    }
};
PredictedErrors largest(const PredictedErrors& a, const PredictedErrors& b);

/// Whether a method keeps a tolerance or refuses; the others run and promise nothing.
bool keepsTolerance(Method method);

/// The values of a filtered map, or of a sample of them: what an absolute error is relative to.
class ValueDistribution {
public:
    /// @param weight  solid angle that the value stands for
    void add(const glm::dvec3& value, double weight);
    /// Every texel of a map, or so many of them evenly chosen.
    static ValueDistribution of(const EnvironmentMap& map, int texels = 1500);

    double mean() const; ///< over the channels
    double rms() const;  ///< over the channels
    double least() const { return m_least; }
    /// Root mean square of what each channel differs from this by.
    glm::dvec3 deviation(const glm::dvec3& from) const;

    /// Errors whose root mean square is `rms` in each channel, at most (rel_rms with a reserve of 1.4 for what samples of it differ by):
    /// with a share q of the values so large that rms/value <= rho,
    ///   median_rel <= rho(1/2)                the median of an error is below its root mean square, and errors are larger where the light
    ///   is p99_rel <= sqrt(200) rho(0.995)       Chebyshev: no more than 0.5 % of all errors exceed sqrt(200) times their root mean square
    /// and rho/(1 - rho) in place of rho, because the values themselves may be off by that much.
    PredictedErrors errors(const glm::dvec3& rms) const;

    /// The largest s for which errors of root mean square s * shape keep the limits, the largest channel of `shape` being 1.
    double allowedRms(const glm::dvec3& shape, const ErrorLimits& limits) const;

    /// The largest error, the same everywhere, that keeps the limits of a map that errs to neither side of 0.
    double allowedLargest(const ErrorLimits& limits) const;

private:
    /// Of rms/value: half of them are no larger than `middle`, all but a half per cent than `dark`, a half per cent than `bright`.
    struct Quantiles {
        double bright, middle, dark;
    };
    Quantiles quantiles(const glm::dvec3& rms) const;
    double floor() const; ///< 1e-6 of the mean: what is darker counts as this

    struct Value {
        glm::dvec3 rgb;
        double weight;
    };
    std::vector<Value> m_values{};
    double m_weight = 0.0, m_sum = 0.0, m_least = 0.0;
    mutable std::optional<double> m_rms{}; ///< found by the first rms(), which planning asks for again and again
};

} // namespace mirrorball
