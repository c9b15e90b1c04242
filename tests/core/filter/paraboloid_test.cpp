#include "core/filter/paraboloid_lattice.h"

#include "core/base/error.h"
#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/image_io.h"
#include "core/report/error_metrics.h"
#include "support/probe_builders.h"
#include "support/shared_data.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

namespace mirrorball {
namespace {

/// Directions spread evenly over the sphere: a Fibonacci spiral.
std::vector<glm::dvec3> evenDirections(int count)
{
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count, s = std::sqrt(1.0 - z * z), turn = 2.399963229728653 * i;
        directions.emplace_back(s * std::cos(turn), s * std::sin(turn), z);
    }
    return directions;
}

ErrorMetrics errorOf(const EnvironmentMap& probe, const Lobe& lobe, const ParaboloidKnobs& knobs, const std::vector<glm::dvec3>& directions,
                     const std::vector<glm::dvec3>& reference)
{
    return errorMetrics(paraboloidSum(layOutHalves(probe, lobe, resolved(knobs, probe.layout.size)), directions), reference);
}

TEST(Paraboloid, AConstantEnvironmentStaysConstant)
{
    const EnvironmentMap furnace = test::constantProbe(32, 0.7f);
    const std::vector<glm::dvec3> directions = evenDirections(200);
    for (const ParaboloidKernel kernel : {ParaboloidKernel::Blended, ParaboloidKernel::Exact})
        for (const Lobe& lobe : {phongLobe(0), phongLobe(1), phongLobe(20), phongLobe(300), diffuseLobe(), ggxLobe(0.3), ggxLobe(1.0),
                                 tabulatedLobe({0.0, 0.0, 1.0, 0.5})})
            for (const int border : {0, 4}) {
                const ParaboloidKnobs knobs{.kernel = kernel, .half = 64, .border = border};
                for (const glm::dvec3& value : paraboloidSum(layOutHalves(furnace, lobe, resolved(knobs, 32)), directions))
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(value[c], static_cast<double>(0.7f), 1e-6) << describe(lobe);
            }
}

/// Blended, the geometry of the map limits the error, however many texels the kernel has; exact, cubic interpolation has an error of the
/// fourth order, so that twice the kernel takes most of it away.
TEST(Paraboloid, TheExactKernelConvergesToTheReferenceAndTheBlendedOneDoesNot)
{
    const EnvironmentMap probe = test::sunProbe(64, 1e4f, 40, 20);
    const std::vector<glm::dvec3> directions = evenDirections(1500);
    const Lobe lobe = phongLobe(40);
    const std::vector<glm::dvec3> reference = referenceSum(probe, lobe, directions);
    double previous = 0.0;
    for (const int kernel : {12, 24, 48}) {
        const double error = errorOf(probe, lobe, {.clamp = 1e-7, .largestKernel = kernel}, directions, reference).relRms;
        if (previous > 0.0) {
            EXPECT_LT(error, previous / 10.0) << kernel;
        }
        previous = error;
    }
    EXPECT_LT(previous, 3e-4);
    const ParaboloidKnobs blended{.kernel = ParaboloidKernel::Blended, .clamp = 1e-4, .largestKernel = 63, .half = 256};
    EXPECT_GT(errorOf(probe, lobe, blended, directions, reference).relRms, 0.03);
}

/// Same clamp, same kernel size: what is left is the clamp, which is the same for both.
TEST(Paraboloid, TheExactKernelRemovesMostOfTheError)
{
    const EnvironmentMap probe = test::sunProbe(64, 1e4f, 30, 15);
    const std::vector<glm::dvec3> directions = evenDirections(1500);
    for (const double exponent : {10.0, 50.0}) {
        const Lobe lobe = phongLobe(exponent);
        const std::vector<glm::dvec3> reference = referenceSum(probe, lobe, directions);
        const double blended = errorOf(probe, lobe, {.kernel = ParaboloidKernel::Blended, .half = 256}, directions, reference).relRms;
        const double sameKnobs = errorOf(probe, lobe, {.clamp = 0.1, .largestKernel = 7}, directions, reference).relRms;
        const double ownKnobs = errorOf(probe, lobe, {}, directions, reference).relRms;
        EXPECT_LT(sameKnobs, 0.75 * blended) << exponent;
        EXPECT_LT(ownKnobs, 0.05 * blended) << exponent;
    }
}

/// A sun is the probe that the prediction is for; noise and real probes show less. The first stands behind, the second in the middle of the
/// front half, the last at the rim.
// Against the sum over every texel of both halves, the kernel evaluated as it is.
TEST(Paraboloid, SumsOnTheCpuAreTheKernelsOverAllTexels)
{
    const EnvironmentMap probe = test::sunProbe(48, 1e3f, 70, 12);
    const std::vector<glm::dvec3> directions = evenDirections(300);
    for (const Lobe& lobe : {phongLobe(1), phongLobe(10), phongLobe(500), ggxLobe(0.05), ggxLobe(0.7), diffuseLobe()}) {
        const ParaboloidHalves halves = layOutHalves(probe, lobe, resolved({}, 48));
        const LobeShape shape(lobe);
        const std::vector<glm::dvec3> sums = paraboloidSum(halves, directions);
        double peak = 0.0, worst = 0.0;
        for (size_t n = 0; n < directions.size(); ++n) {
            glm::dvec4 sum(0.0);
            for (int y = 0; y < halves.side; ++y)
                for (int x = 0; x < 2 * halves.side; ++x) {
                    const bool isBack = x >= halves.side;
                    const glm::dvec2 q = glm::dvec2(x % halves.side + 0.5 - 0.5 * halves.side, 0.5 * halves.side - y - 0.5) / halves.radius;
                    const double q2 = glm::dot(q, q), z = (1.0 - q2) / (1.0 + q2);
                    const double c = glm::dot(directions[n], glm::dvec3(2.0 / (1.0 + q2) * q, isBack ? -z : z));
                    if (c >= std::cos(halves.reach))
                        sum += shape.relative(c) * glm::dvec4(halves.texels[static_cast<size_t>(2 * halves.side * y + x)]);
                }
            peak = std::max(peak, sums[n].x);
            worst = std::max(worst, glm::distance(sums[n], glm::dvec3(sum) / sum.w));
        }
        EXPECT_LT(worst, 3e-6 * peak) << describe(lobe);
    }
}

// A sun of one texel shows the lobe itself. What is read between the points of the lattice is nearer to the sums than these are to the
// truth, and its error against that no larger. What is left between the two is the step at the clamp, which the lattice smooths.
TEST(Paraboloid, ManyDirectionsAreReadFromALatticeOfSumsAtNoLossOfAccuracy)
{
    const EnvironmentMap probe = test::sunProbe(128, 1e4f, 100, 40);
    const std::vector<glm::dvec3> directions = evenDirections(100000);
    struct Case {
        Lobe lobe;
        ParaboloidKnobs knobs{};
    };
    for (const auto& [lobe, knobs] :
         {Case{phongLobe(10)}, Case{phongLobe(50)}, Case{phongLobe(50), {.clamp = 1e-5, .largestKernel = 41}}, Case{ggxLobe(0.3)}}) {
        const ParaboloidHalves halves = layOutHalves(probe, lobe, resolved(knobs, 128));
        size_t summed = 0;
        const std::vector<glm::vec3> read = paraboloidSums(halves, directions, [&](std::span<const glm::dvec3> some) {
            summed = some.size();
            const std::vector<glm::dvec3> sums = paraboloidSum(halves, some);
            return std::vector<glm::vec3>(sums.begin(), sums.end());
        });
        EXPECT_LT(summed, directions.size() / 2) << describe(lobe);
        std::vector<glm::dvec3> sparse; // the reference takes a while
        std::vector<glm::dvec3> readThere;
        for (size_t i = 0; i < directions.size(); i += 40) {
            sparse.push_back(directions[i]);
            readThere.emplace_back(read[i]);
        }
        const std::vector<glm::dvec3> one = paraboloidSum(halves, sparse), truth = referenceSum(probe, lobe, sparse);
        const double own = errorMetrics(one, truth).relRms, withLattice = errorMetrics(readThere, truth).relRms;
        EXPECT_LT(withLattice, 1.02 * own) << describe(lobe);
        EXPECT_LT(errorMetrics(readThere, one).relRms, 0.3 * own) << describe(lobe);
    }
}

TEST(Paraboloid, TheLatticeServesOnlyWhereItSparesSumsAndTheLobeEndsSoftly)
{
    const EnvironmentMap probe = test::constantProbe(32, 1.0f);
    const auto serves = [&](const Lobe& lobe, const ParaboloidKnobs& knobs, size_t directions) {
        return latticeFor(layOutHalves(probe, lobe, resolved(knobs, 32)), directions).has_value();
    };
    EXPECT_TRUE(serves(phongLobe(50), {}, 524288));
    EXPECT_FALSE(serves(phongLobe(50), {}, 1000));
    EXPECT_FALSE(serves(phongLobe(50), {.clamp = 0.1}, 524288));
    EXPECT_FALSE(serves(diffuseLobe(), {}, 524288)) << "its horizon is a kink";
    EXPECT_FALSE(serves(phongLobe(50), {.kernel = ParaboloidKernel::Blended}, 524288));
}

TEST(Paraboloid, PredictsItsErrorForTheWorstSun)
{
    const std::vector<glm::dvec3> directions = evenDirections(1500);
    constexpr std::array<std::array<int, 2>, 4> suns{{{5, 15}, {64, 32}, {100, 45}, {32, 32}}};
    const std::vector<ParaboloidKnobs> knobs{
        {.kernel = ParaboloidKernel::Blended, .half = 256}, {.clamp = 0.1, .largestKernel = 7}, {}, {.clamp = 1e-5, .largestKernel = 31}};
    for (const double exponent : {10.0, 50.0}) {
        std::vector<double> worst(knobs.size(), 0.0);
        for (const auto& [x, y] : suns) {
            EnvironmentMap probe(MapLayout{Parameterization::Latlong, 64, 0});
            std::fill_n(probe.image.texel(x, y), 3, 1e4f);
            const std::vector<glm::dvec3> reference = referenceSum(probe, phongLobe(exponent), directions);
            for (size_t i = 0; i < knobs.size(); ++i)
                worst[i] = std::max(worst[i], errorOf(probe, phongLobe(exponent), knobs[i], directions, reference).relRms);
        }
        for (size_t i = 0; i < knobs.size(); ++i) {
            const double predicted = paraboloidError(phongLobe(exponent), resolved(knobs[i], 64));
            EXPECT_LT(worst[i], 1.1 * predicted) << exponent << ' ' << i;
            EXPECT_GT(worst[i], 0.3 * predicted) << exponent << ' ' << i;
        }
    }
}

/// Nothing shows where the halves meet: the sum is over both, whatever side of the equator the lookup is on.
TEST(Paraboloid, TheExactKernelHasNoSeamAtTheEquator)
{
    const EnvironmentMap probe = test::noiseProbe(32, 3);
    const ParaboloidHalves halves = layOutHalves(probe, phongLobe(20), resolved({}, 32));
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 64; ++i)
        for (const double z : {-1e-7, 1e-7})
            directions.push_back(glm::normalize(glm::dvec3(std::cos(0.1 * i), std::sin(0.1 * i), z)));
    const std::vector<glm::dvec3> values = paraboloidSum(halves, directions);
    for (size_t i = 0; i < values.size(); i += 2)
        EXPECT_NEAR(values[i].x, values[i + 1].x, 1e-5 * values[i].x);
}

TEST(Paraboloid, DoesNotDependOnTheNumberOfThreads)
{
    const EnvironmentMap probe = test::noiseProbe(32, 5);
    const std::vector<glm::dvec3> directions = evenDirections(500);
    for (const ParaboloidKernel kernel : {ParaboloidKernel::Blended, ParaboloidKernel::Exact}) {
        const ParaboloidKnobs knobs = resolved({.kernel = kernel}, 32);
        const ParaboloidHalves one = layOutHalves(probe, phongLobe(30), knobs, {.threads = 1});
        const ParaboloidHalves two = layOutHalves(probe, phongLobe(30), knobs, {.threads = 2});
        EXPECT_EQ(one.texels, two.texels);
        EXPECT_EQ(paraboloidSum(one, directions, {.threads = 1}), paraboloidSum(one, directions, {.threads = 3}));
    }
}

TEST(Paraboloid, RefusesLobesItHasNoTexelsFor)
{
    EXPECT_EQ(paraboloidRefusal(phongLobe(500), resolved({}, 512)), "");
    EXPECT_NE(paraboloidRefusal(phongLobe(1e9), resolved({}, 512)), "");
    EXPECT_NE(paraboloidRefusal(ggxLobe(0.0), resolved({}, 512)), "");
    EXPECT_NE(paraboloidRefusal(phongLobe(1e6), resolved({.kernel = ParaboloidKernel::Blended}, 512)), "");
    EXPECT_NE(paraboloidRefusal(phongLobe(50), resolved({.largestKernel = 2}, 512)), "");
    EXPECT_THROW(layOutHalves(test::constantProbe(16), phongLobe(1e9), resolved({}, 16)), InvalidArgument);
}

TEST(Paraboloid, IsExactOnRealProbesToItsPrediction)
{
    const MapLayout target{Parameterization::Octahedral, 48, 0};
    const std::vector<glm::dvec3> directions = lookupDirections(target, 0.0);
    for (const char* name : {"probes/kloppenheim_05_1k.hdr", "probes/studio_small_03_1k.hdr"}) {
        SHARED_DATA_OR_SKIP(path, name);
        FilterSource source(EnvironmentMap({Parameterization::Latlong, 512, 0}, readImage(path)));
        for (const double exponent : {10.0, 50.0, 500.0}) {
            const Lobe lobe = phongLobe(exponent);
            const EnvironmentMap reference = prefilter(source, {.lobe = lobe, .target = target, .method = Method::Spectral}).map; // to 1e-5
            std::vector<glm::dvec3> values;
            for (size_t i = 0; i < directions.size(); ++i)
                values.emplace_back(reference.image.texels[3 * i], reference.image.texels[3 * i + 1], reference.image.texels[3 * i + 2]);
            const ParaboloidKnobs blended{.kernel = ParaboloidKernel::Blended};
            const double published = errorOf(*source.latlong(), lobe, blended, directions, values).relRms;
            const double exact = errorOf(*source.latlong(), lobe, {}, directions, values).relRms;
            EXPECT_LT(exact, paraboloidError(lobe, resolved({}, 512))) << name << ' ' << exponent;
            EXPECT_LT(published, paraboloidError(lobe, resolved(blended, 512))) << name << ' ' << exponent;
            EXPECT_LT(exact, 0.1 * published) << name << ' ' << exponent;
        }
    }
}

/// A machine without a working driver gets its map all the same, and is told.
TEST(Paraboloid, RunsOnTheCpuWhereThereIsNoDeviceOrItFails)
{
    class Failing : public ParaboloidDevice {
    public:
        std::vector<glm::vec3> sum(const ParaboloidHalves&, std::span<const glm::dvec3>, const JobControl&) override
        {
            throw WorkError("no driver today");
        }
        std::string description() override { return "none"; }
    };
    const PrefilterOptions options{.lobe = phongLobe(20), .target = {Parameterization::Cube, 4, 0}, .method = Method::Paraboloid};
    FilterSource without(test::noiseProbe(16, 4)), failing(test::noiseProbe(16, 4));
    failing.useParaboloidDevice(std::make_shared<Failing>());
    const PrefilterOutcome own = prefilter(without, options), after = prefilter(failing, options);
    EXPECT_EQ(own.map.image, after.map.image);
    EXPECT_EQ(after.stages.back().name, "paraboloid sums on the CPU");
    EXPECT_EQ(after.stages.back().why, "no driver today");
}

} // namespace
} // namespace mirrorball
