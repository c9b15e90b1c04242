#include "reference_samples.h"

#include "method_settings.h"
#include "run_times.h"

#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/probe_statistics.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace mirrorball {

namespace {

Texel texelOf(const MapLayout& layout, const glm::dvec3& d)
{
    const glm::dvec2 p = coordinate(layout, d);
    return {std::clamp(static_cast<int>(p.x), 0, layout.width() - 1), std::clamp(static_cast<int>(p.y), 0, layout.height() - 1)};
}

/// Where errors are largest: the brightest direction and two rings around it, axes, edges and corners of the cube.
std::vector<glm::dvec3> extremeDirections(const EnvironmentMap& probe, const Lobe& lobe)
{
    std::vector<glm::dvec3> directions;
    const glm::dvec3 sun = statistics(probe).brightestDirection;
    const glm::dvec3 side = glm::normalize(glm::cross(sun, std::abs(sun.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 up = glm::cross(side, sun);
    directions.push_back(sun);
    for (const double widths : {0.5, 1.5}) {
        const double angle = widths * LobeShape(lobe).halfWidth();
        for (int i = 0; i < 8; ++i) {
            const double turn = 0.25 * pi * i;
            directions.push_back(std::cos(angle) * sun + std::sin(angle) * (std::cos(turn) * side + std::sin(turn) * up));
        }
    }
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
    return directions;
}

} // namespace

std::vector<glm::dvec3> evenDirections(int count)
{
    std::vector<glm::dvec3> directions;
    const double goldenAngle = pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - y * y);
        directions.emplace_back(r * std::cos(goldenAngle * i), y, r * std::sin(goldenAngle * i));
    }
    return directions;
}

std::vector<glm::dvec3> referenceAt(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                    const JobControl& job)
{
    if (!lobe.isMirror() && !isUnresolved(lobe, latlong.image.width))
        return referenceSum(latlong, lobe, directions, job);
    std::vector<glm::dvec3> values;
    for (const glm::dvec3& d : directions)
        values.emplace_back(latlong.radiance(d));
    return values;
}

int ReferenceSamples::weighted() const
{
    return static_cast<int>(std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0.0; }));
}

ReferenceSamples referenceSamples(const FilterSource& source, const Lobe& lobe, const MapLayout& target, int count, const JobControl& job)
{
    const EnvironmentMap* probe = source.latlong();
    if (!probe)
        throw InvalidArgument("reference: needs the whole probe in memory");
    ReferenceSamples samples;
    const int texels = target.width() * target.height();
    samples.complete = count >= texels;
    if (samples.complete) {
        for (int y = 0; y < target.height(); ++y)
            for (int x = 0; x < target.width(); ++x)
                if (const double solidAngle = texelSolidAngle(target, x, y); solidAngle > 0.0) {
                    samples.texels.push_back({x, y});
                    samples.weights.push_back(solidAngle);
                }
    } else {
        std::set<std::pair<int, int>> taken;
        const auto take = [&](const glm::dvec3& d, double weight) {
            const Texel t = texelOf(target, d);
            if (taken.insert({t.x, t.y}).second) {
                samples.texels.push_back(t);
                samples.weights.push_back(weight);
            }
        };
        for (const glm::dvec3& d : evenDirections(count))
            take(d, 4.0 * pi / count);
        for (const glm::dvec3& d : extremeDirections(*probe, lobe))
            take(d, 0.0);
    }

    std::vector<glm::dvec3> directions;
    for (const Texel& t : samples.texels)
        directions.push_back(texelDirection(target, t.x, t.y));
    samples.seconds = secondsOf([&] { samples.values = referenceAt(*probe, lobe, directions, job); });
    return samples;
}

ErrorMetrics errorAt(const ReferenceSamples& reference, const EnvironmentMap& map)
{
    std::vector<glm::dvec3> values;
    for (const Texel& t : reference.texels) {
        const float* rgb = map.image.texel(t.x, t.y);
        values.emplace_back(rgb[0], rgb[1], rgb[2]);
    }
    ErrorMetrics metrics = errorMetrics(values, reference.values, reference.weights);
    double power = 0.0, total = 0.0, largest = 0.0;
    for (size_t i = 0; i < values.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            power += reference.weights[i] * reference.values[i][c] * reference.values[i][c];
            total += reference.weights[i];
            largest = std::max(largest, std::abs(values[i][c] - reference.values[i][c]));
        }
    if (power > 0.0)
        metrics.maxAbs = largest / std::sqrt(power / total);
    return metrics;
}

ExactMap mostExactMap(FilterSource& source, const Lobe& lobe, const MapLayout& target, const JobControl& job)
{
    constexpr double loosest = 1e-3;
    for (const double tolerance : {1e-6, 1e-5, 1e-4, loosest})
        try {
            PrefilterOutcome outcome =
                prefilter(source, {.lobe = lobe, .target = target, .method = Method::Spectral, .tolerance = tolerance}, job);
            return {std::move(outcome.map), outcome.filtered ? "spectral at tolerance " + shortNumber(tolerance) : "the bilinear lookup"};
        } catch (const InvalidArgument&) { // the promise cannot be kept so tightly
            if (tolerance == loosest)
                throw;
        }
    return {};
}

} // namespace mirrorball
