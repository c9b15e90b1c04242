#include "error_metrics.h"

#include "core/base/error.h"
#include "core/base/weighted_quantiles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace mirrorball {

ErrorMetrics errorMetrics(std::span<const glm::dvec3> values, std::span<const glm::dvec3> reference, std::span<const double> solidAngles)
{
    assert(values.size() == reference.size() && (solidAngles.empty() || solidAngles.size() == values.size()));
    double differencePower = 0.0, referencePower = 0.0, mean = 0.0, total = 0.0, largest = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
        const double w = solidAngles.empty() ? 1.0 : solidAngles[i];
        if (w <= 0.0)
            continue;
        for (int c = 0; c < 3; ++c) {
            const double difference = values[i][c] - reference[i][c];
            differencePower += w * difference * difference;
            referencePower += w * reference[i][c] * reference[i][c];
            mean += w * reference[i][c];
            largest = std::max(largest, std::abs(difference));
            total += w;
        }
    }
    if (referencePower <= 0.0 || total <= 0.0)
        return {.relRms = differencePower > 0.0 ? HUGE_VAL : 0.0,
                .maxAbs = largest > 0.0 ? HUGE_VAL : 0.0,
                .medianRel = largest > 0.0 ? HUGE_VAL : 0.0,
                .p99Rel = largest > 0.0 ? HUGE_VAL : 0.0};
    mean /= total;

    std::vector<WeightedValue> relative;
    for (size_t i = 0; i < values.size(); ++i) {
        const double w = solidAngles.empty() ? 1.0 : solidAngles[i];
        if (w > 0.0)
            for (int c = 0; c < 3; ++c)
                relative.push_back({std::abs(values[i][c] - reference[i][c]) / std::max(reference[i][c], 1e-6 * std::abs(mean)), w});
    }
    const auto [median, p99] = weightedQuantiles(std::move(relative), std::array{0.5, 0.99});
    return {.relRms = std::sqrt(differencePower / referencePower),
            .maxAbs = largest / std::sqrt(referencePower / total),
            .medianRel = median,
            .p99Rel = p99};
}

ErrorMetrics errorMetrics(const EnvironmentMap& map, const EnvironmentMap& reference)
{
    if (map.layout != reference.layout)
        throw InvalidArgument("error metrics: the two maps must have the same parameterization and size");
    const auto toVectors = [](const Image& image) {
        std::vector<glm::dvec3> v;
        for (size_t i = 0; i + 2 < image.texels.size(); i += 3)
            v.emplace_back(image.texels[i], image.texels[i + 1], image.texels[i + 2]);
        return v;
    };
    std::vector<double> solidAngles;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            solidAngles.push_back(texelSolidAngle(map.layout, x, y));
    return errorMetrics(toVectors(map.image), toVectors(reference.image), solidAngles);
}

} // namespace mirrorball
