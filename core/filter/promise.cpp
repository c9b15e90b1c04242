#include "promise.h"

#include "method_row.h"

#include "core/base/weighted_quantiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace mirrorball {

namespace {

/// Chebyshev's factor for half a per cent, and the per cent's other half, which is left to the darkest values.
const double tailFactor = std::sqrt(200.0);
constexpr double tailShare = 0.995;

/// How far beyond its root mean square an error goes where the map is darkest; what goes beyond is seen when the map is there.
constexpr double crest = 6.0;

/// What samples of a map's root mean square may differ by.
constexpr double rmsReserve = 1.4;

double relative(double rho) { return rho < 1.0 ? rho / (1.0 - rho) : std::numeric_limits<double>::infinity(); }

} // namespace

ErrorLimits errorLimits(double tolerance)
{
    return {.relRms = tolerance,
            .medianRel = tolerance,
            .p99Rel = std::max(5.0 * tolerance, 1e-3),
            .negative = std::max(1e-3 * tolerance, 1e-7)};
}

PredictedErrors largest(const PredictedErrors& a, const PredictedErrors& b)
{
    return {std::max(a.relRms, b.relRms), std::max(a.medianRel, b.medianRel), std::max(a.p99Rel, b.p99Rel)};
}

bool keepsTolerance(Method method) { return !rowOf(method).spread; }

void ValueDistribution::add(const glm::dvec3& value, double weight)
{
    if (weight <= 0.0)
        return;
    m_rms.reset();
    const double least = std::min({value.r, value.g, value.b});
    m_least = m_values.empty() ? least : std::min(m_least, least);
    m_values.push_back({value, weight});
    m_weight += weight;
    m_sum += weight * (value.r + value.g + value.b) / 3.0;
}

ValueDistribution ValueDistribution::of(const EnvironmentMap& map, int texels)
{
    ValueDistribution values;
    const int width = map.image.width, height = map.image.height;
    const double all = static_cast<double>(width) * height;
    // A step that has no factor in common with the width, so that columns and rows are met evenly.
    auto step = static_cast<std::int64_t>(std::max(1.0, all / texels));
    while (step > 1 && std::gcd(step, static_cast<std::int64_t>(width)) != 1)
        ++step;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(all); i += step) {
        const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
        const float* t = map.image.texel(x, y);
        values.add({t[0], t[1], t[2]}, texelSolidAngle(map.layout, x, y));
    }
    return values;
}

double ValueDistribution::mean() const { return m_weight > 0.0 ? m_sum / m_weight : 0.0; }
double ValueDistribution::rms() const
{
    if (m_weight <= 0.0)
        return 0.0;
    if (m_rms)
        return *m_rms;
    const double bright = 1.0 / quantiles(glm::dvec3(1.0)).bright;
    double squares = 0.0;
    for (const Value& v : m_values) {
        const glm::dvec3 rgb = glm::min(v.rgb, glm::dvec3(bright));
        squares += v.weight * glm::dot(rgb, rgb) / 3.0;
    }
    return *(m_rms = std::sqrt(squares / m_weight));
}

double ValueDistribution::floor() const { return std::max(1e-6 * std::abs(mean()), std::numeric_limits<double>::min()); }

ValueDistribution::Quantiles ValueDistribution::quantiles(const glm::dvec3& rms) const
{
    std::vector<WeightedValue> ratios;
    ratios.reserve(3 * m_values.size());
    const double least = floor();
    for (const Value& v : m_values)
        for (int c = 0; c < 3; ++c)
            ratios.push_back({rms[c] / std::max(v.rgb[c], least), v.weight});
    const auto [bright, middle, dark] = weightedQuantiles(std::move(ratios), std::array{1.0 - tailShare, 0.5, tailShare});
    return {bright, middle, dark};
}

PredictedErrors ValueDistribution::errors(const glm::dvec3& rms) const
{
    if (rms == glm::dvec3(0.0))
        return {};
    const double scale = this->rms();
    const Quantiles q = quantiles(rms);
    return {.relRms = scale > 0.0 ? rmsReserve * std::sqrt(glm::dot(rms, rms) / 3.0) / scale : std::numeric_limits<double>::infinity(),
            .medianRel = relative(q.middle),
            .p99Rel = relative(tailFactor * q.dark)};
}

double ValueDistribution::allowedRms(const glm::dvec3& shape, const ErrorLimits& limits) const
{
    const auto inverse = [](double limit) { return limit / (1.0 + limit); }; // of relative()
    const Quantiles q = quantiles(shape);
    double allowed = limits.relRms * rms() / rmsReserve / std::sqrt(glm::dot(shape, shape) / 3.0);
    if (q.middle > 0.0)
        allowed = std::min(allowed, inverse(limits.medianRel) / q.middle);
    if (q.dark > 0.0)
        allowed = std::min(allowed, inverse(limits.p99Rel) / (tailFactor * q.dark));
    return std::min(allowed, (std::max(m_least, 0.0) + limits.negative * std::abs(mean())) / crest);
}

glm::dvec3 ValueDistribution::deviation(const glm::dvec3& from) const
{
    glm::dvec3 squares(0.0);
    for (const Value& v : m_values)
        squares += v.weight / m_weight * (v.rgb - from) * (v.rgb - from);
    return glm::sqrt(squares);
}

double ValueDistribution::allowedLargest(const ErrorLimits& limits) const
{
    const Quantiles q = quantiles(glm::dvec3(1.0));
    return std::min({limits.relRms * rms(), limits.medianRel / q.middle, limits.p99Rel / q.dark});
}

} // namespace mirrorball
