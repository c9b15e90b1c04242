#include "parameterization_study.h"

#include "reference_samples.h"

#include "core/base/weighted_quantiles.h"
#include "core/image/reproject.h"
#include "core/sphere/distortion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace mirrorball {

namespace {

constexpr int angles = 181; ///< a degree apart

/// Where the mirror is looked up: the probe's texel centers, so that no small sun falls between them, or every second, third ... of
/// both ways in a large probe.
struct MirrorLookups {
    std::vector<glm::dvec3> directions{}, truth{};
    std::vector<double> solidAngles{};

    MirrorLookups(const EnvironmentMap& probe, int enough)
    {
        const double texels = static_cast<double>(probe.image.width) * probe.image.height;
        const int step = std::max(1, static_cast<int>(std::lround(std::sqrt(texels / enough))));
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

/// Counts and shapes of the texels whose centers lie on the map.
void measureTexels(ParameterizationRow& row)
{
    const MapLayout& layout = row.layout;
    double largest = 0.0, smallest = 4.0 * pi;
    std::vector<WeightedValue> anisotropy;
    for (int y = 0; y < layout.height(); ++y)
        for (int x = 0; x < layout.width(); ++x)
            if (acrossSeam(layout, {x, y}, x, y) == Texel{x, y}) {
                const glm::dvec2 center(x + 0.5, y + 0.5);
                const double at = density(layout, center);
                ++row.used;
                largest = std::max(largest, at);
                smallest = std::min(smallest, at);
                anisotropy.push_back({distortion(layout, center).anisotropy(), at});
            }
    row.densityRatio = largest / smallest;
    const auto [middle, high] = weightedQuantiles(std::move(anisotropy), std::array{0.5, 0.99});
    row.anisotropyMedian = middle;
    row.anisotropyP99 = high;
    row.solidAngle = solidAngleByAngle(layout, row.used);
}

/// Seconds of one lookup: the median of some rounds through directions that lie far apart one after the other, as those of a picture of a
/// curved thing do.
double lookupSeconds(const EnvironmentMap& map, int rounds)
{
    constexpr int lookups = 1 << 14, stride = 6421; // odd, so that every direction comes once
    const std::vector<glm::dvec3> directions = evenDirections(lookups);
    glm::vec3 sum(0.0f);
    const auto round = [&] {
        return timeOf([&] {
            for (int i = 0, at = 0; i < lookups; ++i, at = (at + stride) % lookups)
                sum += map.radiance(directions[static_cast<size_t>(at)]);
        });
    };
    const double seconds = repeated(rounds + 1, 1.0, round).median() / lookups;
    return std::isnan(sum.x) ? 0.0 : seconds; // the sum is looked at, so that no compiler leaves it out
}

double drawSeconds(MapDrawer& drawer, EnvironmentMap map, int pictures)
{
    const auto levels = std::make_shared<const std::vector<EnvironmentMap>>(std::vector<EnvironmentMap>{std::move(map)});
    drawer.draw(levels); // compiles the shader, hands the map over
    return repeated(pictures, 1.0, [&] { return timeOf([&] { drawer.draw(levels); }); }).median();
}

} // namespace

MapLayout layoutOfTexels(Parameterization kind, int texels)
{
    const MapLayout unit{kind, 1, 0};
    const double perSquare = unit.width() * unit.height();
    return {kind, std::max(1, static_cast<int>(std::lround(std::sqrt(texels / perSquare)))), 0};
}

ParameterizationStudy studyParameterizations(const FilterSource& probe, const ParameterizationStudyOptions& options, const JobControl& job)
{
    const JobControl inner{.stop = job.stop, .threads = job.threads};
    const EnvironmentMap& whole = *probe.latlong();
    const MirrorLookups mirror(whole, options.mirrorLookups);
    const std::vector<glm::dvec3> fewer = evenDirections(options.referenceDirections);
    const std::vector<glm::dvec3> truth = referenceAt(whole, options.lobe, fewer, inner);
    ParameterizationStudy study{.lobe = options.lobe,
                                .directions = static_cast<int>(mirror.directions.size()),
                                .referenceDirections = options.referenceDirections,
                                .drawnBy = options.drawer ? options.drawer->description() : ""};

    FilterSource source = probe;
    for (const Parameterization kind : allParameterizations) {
        job.checkStop();
        const MapLayout layout = layoutOfTexels(kind, options.texels);
        ParameterizationRow row{.layout = layout, .texels = layout.width() * layout.height()};
        measureTexels(row);
        const ErrorMetrics mirrorError =
            lookupError(reproject(whole, {.target = layout}, inner), mirror.directions, mirror.truth, mirror.solidAngles);
        row.mirrorError = mirrorError.relRms;
        row.mirrorP99 = mirrorError.p99Rel;
        EnvironmentMap filtered = mostExactMap(source, options.lobe, layout, inner).map;
        row.filteredError = lookupError(filtered, fewer, truth).relRms;
        row.lookupSeconds = lookupSeconds(filtered, options.repeats);
        if (options.drawer)
            row.drawSeconds = drawSeconds(*options.drawer, std::move(filtered), options.repeats);
        study.rows.push_back(std::move(row));
        if (job.progress)
            job.progress(static_cast<float>(study.rows.size()) / static_cast<float>(allParameterizations.size()));
    }
    return study;
}

double expectedStudySeconds(const ProbeTraits& probe, const ParameterizationStudyOptions& options, const Pace& pace)
{
    const double sources = 0.5 * probe.width * probe.width, kinds = allParameterizations.size();
    const MapLayout target = layoutOfTexels(Parameterization::Cube, options.texels);
    const PrefilterOptions exact{.lobe = options.lobe, .target = target, .method = Method::Spectral, .tolerance = 1e-6};
    const double reference = predictedSeconds(Method::Reference, exact, probe) * options.referenceDirections / options.texels;
    return pace.seconds(reference + kinds * (predictedSeconds(Method::Spectral, exact, probe) + 1e-7 * sources));
}

} // namespace mirrorball
