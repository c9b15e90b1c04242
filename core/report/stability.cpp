#include "stability.h"

#include "core/base/error.h"
#include "core/filter/reference.h"
#include "core/image/repair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace mirrorball {

namespace {

constexpr MapLayout smallLatlong{Parameterization::Latlong, 32, 0};
constexpr MapLayout smallCube{Parameterization::Cube, 8, 0};

EnvironmentMap constantMap(const MapLayout& layout, float value)
{
    EnvironmentMap map(layout);
    std::fill(map.image.texels.begin(), map.image.texels.end(), value);
    return map;
}

/// Log-normal noise about `level`, every texel for itself.
EnvironmentMap noiseMap(const MapLayout& layout, double level, std::uint32_t seed)
{
    EnvironmentMap map(layout);
    std::mt19937 generator(seed);
    for (float& value : map.image.texels) {
        double sum = -6.0; // a sum of twelve uniform numbers: the library's normal distribution differs between libraries
        for (int i = 0; i < 12; ++i)
            sum += static_cast<double>(generator()) / 4294967296.0;
        value = static_cast<float>(level * std::exp(sum));
    }
    return map;
}

/// A sky of 1e-3 and one texel of 1e6 in the direction given.
EnvironmentMap sunMap(const MapLayout& layout, const glm::dvec3& d)
{
    EnvironmentMap map = noiseMap(layout, 1e-3, 7);
    const glm::dvec2 p = coordinate(layout, d);
    float* sun =
        map.image.texel(std::min(static_cast<int>(p.x), map.image.width - 1), std::min(static_cast<int>(p.y), map.image.height - 1));
    for (int c = 0; c < 3; ++c)
        sun[c] = 1e6f * (1.0f - 0.1f * static_cast<float>(c));
    return map;
}

std::function<FilterSource(const JobControl&)> whole(EnvironmentMap map)
{
    return [map = std::move(map)](const JobControl& job) { return FilterSource(map, job); };
}

/// A probe 1 + y/2, which every lobe turns into 1 + k_1 y/2, made row by row as a file is streamed.
FilterSource streamedGradient(int height, int bandLimit, const JobControl& job)
{
    SpectrumBuilder builder(2 * height, height, bandLimit);
    std::vector<float> row(static_cast<size_t>(height) * 6);
    JobControl quiet = job;
    quiet.progress = nullptr;
    for (int y = 0; y < height; ++y) {
        std::fill(row.begin(), row.end(), static_cast<float>(1.0 + 0.5 * std::cos(pi * (y + 0.5) / height)));
        builder.addRows(y, 1, row.data(), quiet);
    }
    return FilterSource(builder.finish(quiet));
}

void addExponents(std::vector<StabilityCase>& cases)
{
    const EnvironmentMap sun = sunMap(smallLatlong, directionFromLonLat(0.7, 0.4));
    std::vector<Lobe> lobes;
    for (const double n : {0.0, 1e-3, 1.0, 2.5, 50.0, 1e3, 1e6, 1e9})
        lobes.push_back(phongLobe(n));
    for (const double roughness : {0.0, 1e-3, 0.3, 0.6, 1.0})
        lobes.push_back(ggxLobe(roughness * roughness));
    lobes.push_back(diffuseLobe());
    lobes.push_back(tabulatedLobe({0.0, 1.0, 0.0, 2.0}));
    for (const Lobe& lobe : lobes) {
        cases.push_back(
            {.name = "sun of 1e6 on a sky of 1e-3, " + describe(lobe), .source = whole(sun), .lobe = lobe, .target = smallCube});
        cases.push_back({.name = "constant 0.7, " + describe(lobe),
                         .source = whole(constantMap(smallLatlong, 0.7f)),
                         .lobe = lobe,
                         .target = smallCube,
                         .constant = static_cast<double>(0.7f)});
    }
}

void addPlaces(std::vector<StabilityCase>& cases)
{
    struct Place {
        const char* name;
        glm::dvec3 d;
        MapLayout target;
    };
    const glm::dvec3 corner = glm::normalize(glm::dvec3(1.0, 1.0, 1.0));
    const std::vector<Place> places{
        {"a sun on the latlong's pole, lobes on both poles", {0.0, 1.0, 0.0}, {Parameterization::Octahedral, 17, 0}},
        {"a sun on a cube's corner", corner, {Parameterization::Cube, 8, 0}},
        {"a sun on the paraboloid's equator", glm::normalize(glm::dvec3(1.0, 0.2, 1e-9)), {Parameterization::Paraboloid, 16, 2}},
        {"a sun on the sphere map's rim", {0.0, 0.0, -1.0}, {Parameterization::Sphere, 24, 0}},
        {"a sun on the latlong's seam", glm::normalize(glm::dvec3(1e-9, 0.1, -1.0)), {Parameterization::Latlong, 16, 0}},
        {"a sun on the angular map's rim", {1e-12, 0.0, -1.0}, {Parameterization::Angular, 24, 0}},
    };
    for (const Place& place : places)
        for (const Lobe& lobe : {phongLobe(40.0), diffuseLobe()})
            cases.push_back({.name = std::string(place.name) + ", " + describe(lobe),
                             .source = whole(sunMap(smallLatlong, place.d)),
                             .lobe = lobe,
                             .target = place.target});
}

void addProbes(std::vector<StabilityCase>& cases, StabilityScale scale)
{
    const Lobe lobe = phongLobe(20.0);
    for (const Lobe& l : {lobe, diffuseLobe(), ggxLobe(0.25)}) {
        EnvironmentMap two = constantMap({Parameterization::Latlong, 1, 0}, 0.5f);
        cases.push_back({.name = "a probe of one radiance, 2 x 1, " + describe(l),
                         .source = whole(two),
                         .lobe = l,
                         .target = smallCube,
                         .constant = 0.5});
        two.image.texel(1, 0)[0] = 1.5f;
        cases.push_back({.name = "a probe of 2 x 1, " + describe(l), .source = whole(two), .lobe = l, .target = smallCube});

        EnvironmentMap broken = noiseMap(smallLatlong, 1.0, 3);
        broken.image.texel(5, 7)[1] = std::numeric_limits<float>::quiet_NaN();
        broken.image.texel(40, 20)[0] = std::numeric_limits<float>::infinity();
        broken.image.texel(41, 20)[0] = -0.5f;
        repair(broken.image, NegativePolicy::Keep);
        cases.push_back({.name = "NaN, Inf and negative texels, repaired, " + describe(l),
                         .source = whole(broken),
                         .lobe = l,
                         .target = smallCube,
                         .nonNegative = false});

        cases.push_back(
            {.name = "a black probe, " + describe(l), .source = whole(constantMap(smallLatlong, 0.0f)), .lobe = l, .target = smallCube});
    }
    cases.push_back({.name = "lambda past the last level",
                     .source = whole(noiseMap(smallLatlong, 1.0, 5)),
                     .lobe = diffuseLobe(),
                     .target = smallCube,
                     .knobs = {.lambda = 32.0}});
    cases.push_back({.name = "one sample",
                     .source = whole(noiseMap(smallLatlong, 1.0, 5)),
                     .lobe = lobe,
                     .target = smallCube,
                     .knobs = {.samples = 1}});

    const int height = scale == StabilityScale::Large ? 8192 : 128;
    std::ostringstream name;
    name << "a probe of " << 2 * height << " x " << height << ", streamed, " << describe(lobe);
    cases.push_back({.name = name.str(),
                     .source = [height](const JobControl& job) { return streamedGradient(height, 96, job); },
                     .lobe = lobe,
                     .target = smallCube,
                     .expected = [](const glm::dvec3& r) { return glm::dvec3(1.0 + 0.5 * 21.0 / 22.0 * r.y); }});
}

EnvironmentMap expectedMap(const StabilityCase& test, FilterSource& source, const JobControl& job)
{
    if (!test.expected) {
        PrefilterOptions options{.lobe = test.lobe, .target = test.target, .method = Method::Reference};
        return prefilter(source, options, job).map;
    }
    EnvironmentMap map(test.target);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const glm::vec3 value(test.expected(texelDirection(test.target, x, y)));
            std::copy_n(&value.x, 3, map.image.texel(x, y));
        }
    return map;
}

double brightness(const glm::dvec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3.0; }

} // namespace

std::vector<StabilityCase> stabilityCases(StabilityScale scale)
{
    std::vector<StabilityCase> cases;
    addExponents(cases);
    addPlaces(cases);
    addProbes(cases, scale);
    return cases;
}

ApproximationBounds approximationBounds(Method method, double predictedError)
{
    // The targets' few hundred texels sample a sun's image coarsely, and the image as expected and as it came out at different phases, so
    // that their means differ though the filters keep the energy.
    constexpr double sampling = 2e-3;
    switch (method) {
    // A sun in a pole's row is smeared around the pole, which no spectrum tells. Samples that meet a sun or miss it scatter by hundredths.
    case Method::Importance:
        return {.prediction = 5.0, .energy = 0.01 + sampling};
    // Bilinear weights take a coarse level's texels for equal, which differ by up to 3 sqrt(3): a sun gains or loses what its texel has
    // less or more than those around it. A lone sun scatters more than photographs, which the prediction is calibrated on.
    case Method::Mip:
        return {.prediction = 3.2, .energy = 0.12};
    // The prediction is of light everywhere, and a lone sun may stand where the method is worst. The kernel is read between texels by a
    // cubic that overshoots where it bends: by no more than it errs at all.
    case Method::Paraboloid:
        return {.prediction = 2.5, .energy = sampling, .negative = 2.5 * predictedError};
    // The kernel of nine coefficients, (1 + 2c + (5/8)(3c^2 - 1)) / 4 pi, dips to -0.1583 / 4 pi at c = -8/15, beside the lobe's
    // own peak of 4 / 4 pi, which a texel sees a little less of than the sun stands for.
    case Method::Sh9:
        return {.prediction = 1.1, .energy = sampling, .negative = 0.04};
    case Method::Auto:
    case Method::Reference:
    case Method::Spectral:
    case Method::Direct:
    case Method::Hierarchical:
        break;
    }
    return {};
}

namespace {

/// Notes what is beyond its bound, or no number.
void demand(StabilityRow& row, const char* what, double value, double bound)
{
    if (value <= bound)
        return;
    std::ostringstream text;
    text << what << ' ' << value << ", beyond " << bound;
    row.failures.push_back(text.str());
}

double meanOf(const EnvironmentMap& map) { return brightness(meanRadiance(map)); }

void judgePromise(const StabilityCase& test, const EnvironmentMap& map, double mean, StabilityRow& row)
{
    const ErrorLimits limits = errorLimits(test.tolerance);
    demand(row, "rel_rms", row.error.relRms, limits.relRms);
    demand(row, "median_rel", row.error.medianRel, limits.medianRel);
    demand(row, "p99_rel", row.error.p99Rel, limits.p99Rel);
    const double least = *std::min_element(map.image.texels.begin(), map.image.texels.end());
    if (test.nonNegative)
        demand(row, "negative, over the mean,", mean > 0.0 ? -least / mean : -least, limits.negative);
}

} // namespace

StabilityRow judgeStability(const StabilityCase& test, const PrefilterOutcome& outcome, double predictedError,
                            const EnvironmentMap& expected)
{
    StabilityRow row{.name = test.name, .method = outcome.method, .predictedError = predictedError, .promised = outcome.promised};
    const std::vector<float>& values = outcome.map.image.texels;
    row.finite = std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
    if (!row.finite) {
        row.failures.push_back("not finite");
        return row;
    }
    row.error = errorMetrics(outcome.map, expected);
    const double mean = meanOf(expected);
    if (mean != 0.0)
        row.energy = meanOf(outcome.map) / mean;
    const float peak = *std::max_element(expected.image.texels.begin(), expected.image.texels.end());
    if (peak > 0.0f)
        row.lowest = static_cast<double>(*std::min_element(values.begin(), values.end())) / static_cast<double>(peak);
    if (outcome.promised) {
        judgePromise(test, outcome.map, mean, row);
        demand(row, "energy off by", std::abs(row.energy - 1.0), 1e-3);
    } else {
        const ApproximationBounds bounds = approximationBounds(outcome.method, predictedError);
        if (outcome.filtered)
            demand(row, "rel_rms", row.error.relRms, bounds.prediction * predictedError);
        demand(row, "energy off by", std::abs(row.energy - 1.0), bounds.energy);
        if (test.nonNegative)
            demand(row, "negative", -row.lowest, bounds.negative);
    }
    if (test.constant) {
        for (const float v : values)
            row.constantError = std::max(row.constantError, std::abs(static_cast<double>(v) / *test.constant - 1.0));
        demand(row, "constant off by", row.constantError, 1e-6);
    }
    return row;
}

StabilityRow runStability(const StabilityCase& test, Method method, const JobControl& job, std::shared_ptr<ParaboloidDevice> device)
{
    FilterSource source = test.source(job);
    source.useParaboloidDevice(std::move(device));
    const PrefilterOptions options{
        .lobe = test.lobe, .target = test.target, .method = method, .tolerance = test.tolerance, .knobs = test.knobs};
    const auto refused = [&](const std::string& why) { return StabilityRow{.name = test.name, .method = method, .refused = why}; };
    if (const std::string why = refusal(method, options, traits(source)); !why.empty())
        return refused(why);

    const auto start = std::chrono::steady_clock::now();
    PrefilterOutcome outcome;
    try {
        outcome = prefilter(source, options, job);
    } catch (const InvalidArgument& why) { // the tolerance cannot be kept
        return refused(why.what());
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    StabilityRow row = judgeStability(test, outcome, informedErrors(outcome, options, source, job).relRms, expectedMap(test, source, job));
    row.method = method;
    row.seconds = seconds;
    return row;
}

double expectedStabilitySeconds(std::span<const Method> methods, StabilityScale scale, const Pace& pace)
{
    return pace.seconds(1.0 * static_cast<double>(methods.size()) + (scale == StabilityScale::Large ? 10.0 : 0.0));
}

} // namespace mirrorball
