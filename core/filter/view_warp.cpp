#include "view_warp.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

std::array<SurfaceView, 3> warpSources(const SurfaceView& wanted, double distance)
{
    if (!(distance >= 0.0 && distance < pi - 2.0 * wanted.view))
        throw InvalidArgument("warp: the views must lie at least 0 and less than 180 degrees minus twice --view from the wanted one");
    // About r, which is +Z, with the normal towards +X: the view mirrors r.
    const double twice = 2.0 * wanted.view;
    const glm::dvec3 v(std::sin(twice), 0.0, std::cos(twice)), away(std::cos(twice), 0.0, -std::sin(twice)), side(0.0, 1.0, 0.0);
    std::array<SurfaceView, 3> sources{};
    for (size_t i = 0; i < 3; ++i) {
        const double turn = 2.0 * pi * static_cast<double>(i) / 3.0;
        const glm::dvec3 from = std::cos(distance) * v + std::sin(distance) * (std::cos(turn) * away + std::sin(turn) * side);
        const glm::dvec3 n = glm::normalize(from + glm::dvec3(0.0, 0.0, 1.0));
        sources[i] = {std::acos(std::clamp(n.z, -1.0, 1.0)), wanted.azimuth + std::atan2(n.y, n.x)};
    }
    return sources;
}

EnvironmentMap filterBrdfWarped(FilterSource& source, const Brdf& brdf, const SurfaceView& seen, double distance, const MapLayout& target,
                                double yaw, double tolerance, const JobControl& job)
{
    EnvironmentMap mean(target);
    for (const SurfaceView& from : warpSources(seen, distance)) {
        const StackPlan plan = planStack(brdf, from.view, tolerance, source, job);
        const EnvironmentMap map = filterBrdfStack(source, plan, from.azimuth, target, yaw, job);
        for (size_t i = 0; i < mean.image.texels.size(); ++i)
            mean.image.texels[i] += map.image.texels[i] / 3.0f;
    }
    return mean;
}

} // namespace mirrorball
