#include "parameterization_study.h"

#include "reference_samples.h"

#include "core/filter/reference.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace mirrorball {

namespace {

constexpr int angles = 181; ///< a degree apart

/// Where the mirror is looked up: the probe's texel centres, so that no small sun falls between them, or every second, third ... of
/// both ways in a large probe.
struct MirrorLookups {
    std::vector<glm::dvec3> directions{}, truth{};
    std::vector<double> solidAngles{};

    explicit MirrorLookups(const EnvironmentMap& probe)
    {
        constexpr double enough = 1 << 19;
        const int step = std::max(1, static_cast<int>(std::lround(std::sqrt(probe.image.width * probe.image.height / enough))));
        for (int y = 0; y < probe.image.height; y += step)
            for (int x = 0; x < probe.image.width; x += step) {
                const float* rgb = probe.image.texel(x, y);
                directions.push_back(texelDirection(probe.layout, x, y));
                truth.emplace_back(rgb[0], rgb[1], rgb[2]);
                solidAngles.push_back(texelSolidAngle(probe.layout, x, y));
            }
    }
};

ErrorMetrics lookupError(const EnvironmentMap& map, std::span<const glm::dvec3> directions, std::span<const glm::dvec3> truth,
                         std::span<const double> solidAngles = {})
{
    std::vector<glm::dvec3> values;
    for (const glm::dvec3& d : directions)
        values.emplace_back(map.radiance(d));
    return errorMetrics(values, truth, solidAngles);
}

/// Solid angle of a texel over that of an equal share of the sphere, on the way from +Z over +Y to -Z.
std::vector<double> solidAngleByAngle(const MapLayout& layout, int used)
{
    std::vector<double> values;
    for (int i = 0; i < angles; ++i) {
        // A little off the plane and the ends, where charts meet and density is that of neither side.
        const double angle = std::clamp(pi * i / (angles - 1), 1e-4, pi - 1e-4);
        const glm::dvec3 d = glm::normalize(glm::dvec3(1e-6, std::sin(angle), std::cos(angle)));
        values.push_back(density(layout, coordinate(layout, d)) * used / (4.0 * pi));
    }
    return values;
}

} // namespace

MapLayout layoutOfTexels(Parameterization kind, int texels)
{
    const MapLayout unit{kind, 1, 0};
    const double perSquare = unit.width() * unit.height();
    return {kind, std::max(1, static_cast<int>(std::lround(std::sqrt(texels / perSquare)))), 0};
}

ParameterizationStudy studyParameterizations(const FilterSource& probe, const Lobe& lobe, int texels, int referenceDirections,
                                             const JobControl& job)
{
    JobControl inner = job;
    inner.progress = nullptr;
    const EnvironmentMap& whole = *probe.latlong();
    const MirrorLookups mirror(whole);
    const std::vector<glm::dvec3> fewer = evenDirections(referenceDirections);
    ParameterizationStudy study{
        .lobe = lobe, .directions = static_cast<int>(mirror.directions.size()), .referenceDirections = referenceDirections};
    const bool looksUp = lobe.isMirror() || isUnresolved(lobe, whole.image.width);
    std::vector<glm::dvec3> filteredTruth;
    if (looksUp)
        for (const glm::dvec3& d : fewer)
            filteredTruth.emplace_back(whole.radiance(d));
    else
        filteredTruth = referenceSum(whole, lobe, fewer, inner);

    FilterSource source = probe;
    for (const Parameterization kind : allParameterizations) {
        job.checkStop();
        const MapLayout layout = layoutOfTexels(kind, texels);
        ParameterizationRow row{.layout = layout, .texels = layout.width() * layout.height()};
        double largest = 0.0, smallest = 4.0 * pi;
        for (int y = 0; y < layout.height(); ++y)
            for (int x = 0; x < layout.width(); ++x)
                if (acrossSeam(layout, {x, y}, x, y) == Texel{x, y}) { // the centre lies on the map
                    const double at = density(layout, {x + 0.5, y + 0.5});
                    ++row.used;
                    largest = std::max(largest, at);
                    smallest = std::min(smallest, at);
                }
        row.densityRatio = largest / smallest;
        row.solidAngle = solidAngleByAngle(layout, row.used);
        const ErrorMetrics mirrorError =
            lookupError(reproject(whole, {.target = layout}, inner), mirror.directions, mirror.truth, mirror.solidAngles);
        row.mirrorError = mirrorError.relRms;
        row.mirrorP99 = mirrorError.p99Rel;
        const PrefilterOptions exact{.lobe = lobe, .target = layout, .method = Method::Spectral, .tolerance = 1e-6};
        row.filteredError = lookupError(prefilter(source, exact, inner).map, fewer, filteredTruth).relRms;
        study.rows.push_back(std::move(row));
        if (job.progress)
            job.progress(static_cast<float>(study.rows.size()) / static_cast<float>(allParameterizations.size()));
    }
    return study;
}

} // namespace mirrorball
