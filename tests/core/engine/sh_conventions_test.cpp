#include "core/engine/sh_conventions.h"

#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "support/probe_builders.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirrorball {
namespace {

RadianceSh axesSh() { return radianceSh(analyze(renderBuiltinProbe("axes", {Parameterization::Latlong, 128, 0}), 2)); }

/// Filament's shader: a polynomial of the normal with the coefficients as they stand.
glm::dvec3 filamentShader(const std::array<glm::dvec3, 9>& c, const glm::dvec3& n)
{
    return c[0] + c[1] * n.y + c[2] * n.z + c[3] * n.x + c[4] * (n.y * n.x) + c[5] * (n.y * n.z) + c[6] * (3.0 * n.z * n.z - 1.0) +
           c[7] * (n.z * n.x) + c[8] * (n.x * n.x - n.y * n.y);
}

TEST(ShConventions, FilamentsShaderMakesIrradianceOverPiOfThem)
{
    const RadianceSh sh = axesSh();
    for (const glm::dvec3& n : {glm::dvec3(1, 0, 0), glm::normalize(glm::dvec3(1, -2, 3)), glm::normalize(glm::dvec3(-3, 1, 1))})
        EXPECT_LT(glm::distance(filamentShader(inConvention(sh, ShConvention::Filament), n), irradianceOverPi(sh, n)), 1e-12);
}

// three.js' shGetIrradianceAt (lights_pars_begin), whose constants are A_l Y_lm rounded to six digits; it gives E.
TEST(ShConventions, ThreesShaderMakesIrradianceOfThem)
{
    const RadianceSh sh = axesSh();
    const auto c = inConvention(sh, ShConvention::Three);
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, -2, 3));
    const glm::dvec3 e = c[0] * 0.886227 + c[1] * 2.0 * 0.511664 * n.y + c[2] * 2.0 * 0.511664 * n.z + c[3] * 2.0 * 0.511664 * n.x +
                         c[4] * 2.0 * 0.429043 * n.x * n.y + c[5] * 2.0 * 0.429043 * n.y * n.z + c[6] * (0.743125 * n.z * n.z - 0.247708) +
                         c[7] * 2.0 * 0.429043 * n.x * n.z + c[8] * 0.429043 * (n.x * n.x - n.y * n.y);
    EXPECT_LT(glm::distance(e, pi * irradianceOverPi(sh, n)), 1e-5);
}

TEST(ShConventions, OfTheAxesProbeAreTheFiguresThatBabylonComputes)
{
    const babylon_env::Polynomial p = babylonPolynomial(axesSh());
    const auto expect = [](const glm::dvec3& value, double r, double g, double b) {
        EXPECT_LT(glm::distance(value, glm::dvec3(r, g, b)), 4e-3);
    };
    expect(p[0], -.081, .053, .057);
    expect(p[1], -.051, .054, -.041);
    expect(p[2], -.097, -.052, .084);
    expect(p[3], .376, .315, .322);
}

TEST(ShConventions, GltfIsIrradianceInOrthonormalHarmonics)
{
    const RadianceSh constant = radianceSh(analyze(test::constantProbe(64), 2));
    EXPECT_NEAR(inConvention(constant, ShConvention::Gltf)[0].r * shNorm(0), pi, 1e-4) << "E of a constant 1 is pi";
}

// filament.js splits at every single blank: two in a row would be NaN.
TEST(ShConventions, FilamentsMetadataHas27NumbersPartedByOneBlankEach)
{
    const std::string text = filamentMetadata(axesSh());
    EXPECT_EQ(std::count_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }), 27);
    std::istringstream numbers(text);
    double number = 0.0;
    int count = 0;
    while (numbers >> number)
        ++count;
    EXPECT_EQ(count, 27);
    EXPECT_EQ(text.find("  "), std::string::npos);
}

TEST(ShConventions, ErrorIsWhatHigherDegreesHold)
{
    const EnvironmentMap noise = test::noiseProbe(32, 9);
    FilterSource source(noise);
    const EnvironmentMap exact = prefilter(source, {.lobe = diffuseLobe(), .target = {Parameterization::Latlong, 32, 0}}).map;
    const RadianceSh sh = radianceSh(source.spectrum(2));
    RadianceSh wrong = sh;
    wrong.coefficients[0] *= 1.1;
    EXPECT_LT(shError(sh, exact), 0.02);
    EXPECT_NEAR(shError(wrong, exact), 0.1, 0.01) << "a tenth too bright";
}

} // namespace
} // namespace mirrorball
