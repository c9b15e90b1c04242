#include "core/shading/reflection_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

glm::dvec3 direction(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Another way to the albedo: the midpoint rule over the hemisphere about the normal, even in solid angle.
double midpointAlbedo(const Brdf& brdf, double view, int steps)
{
    const glm::dvec3 v = direction(view, 0.0);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < 2 * steps; ++j) {
            const double z = (i + 0.5) / steps, phi = pi * (j + 0.5) / (2 * steps);
            const glm::dvec3 l(std::sqrt(1.0 - z * z) * std::cos(phi), std::sqrt(1.0 - z * z) * std::sin(phi), z);
            sum += evaluate(brdf, l, v).g * z;
        }
    return sum * 2.0 * pi / (2.0 * steps * steps);
}

TEST(ReflectionKernel, IsTheBrdfTimesTheCosine)
{
    for (const char* text : {"phong:exponent=50", "ward:alpha=0.15", "cook-torrance:m=0.2,ior=1.5", "beckmann:alpha=0.3,f0=0.04",
                             "ggx:alpha=0.09,metal=copper", "lafortune:exponent=20/exponent=5,cxy=0.9,cz=0.9"}) {
        const Brdf brdf = brdfFromText(text);
        const double view = 0.9;
        const ReflectionKernel kernel(brdf, view);
        const glm::dvec3 v = direction(view, 0.0);
        std::vector<double> nl, lv;
        std::vector<glm::dvec3> expected;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 l = direction(pi * std::fmod(0.618 * i, 1.0), 2.4 * i);
            nl.push_back(l.z);
            lv.push_back(glm::dot(l, v));
            expected.push_back(evaluate(brdf, l, v) * std::max(l.z, 0.0));
        }
        std::array<std::vector<double>, 3> values;
        for (auto& channel : values)
            channel.resize(nl.size());
        kernel.evaluate(nl, lv, {values[0].data(), values[1].data(), values[2].data()});
        for (size_t i = 0; i < nl.size(); ++i)
            for (size_t c = 0; c < kernel.channels(); ++c)
                EXPECT_NEAR(values[c][i], expected[i][static_cast<int>(c)],
                            (text == std::string("ggx:alpha=0.09,metal=copper") ? 1e-6 : 1e-11) * std::max(expected[i].g, 1.0))
                    << text << ' ' << i;
    }
}

TEST(DirectionalAlbedo, AgreesWithAnotherQuadrature)
{
    for (const char* text : {"phong:exponent=20", "ward:alpha=0.3", "cook-torrance:m=0.3,ior=1.5", "beckmann:alpha=0.4", "ggx:alpha=0.3",
                             "ggx:alpha=0.25,f0=0.5", "lafortune:exponent=20/exponent=5,cxy=0.9,cz=0.9,weight=0.3"})
        for (const double view : {0.0, 0.5, 1.0, 1.3}) {
            const Brdf brdf = brdfFromText(text);
            const double expected = midpointAlbedo(brdf, view, 300);
            EXPECT_NEAR(directionalAlbedo(brdf, view).g, expected, 4e-4 * std::max(expected, 1.0)) << text << " at " << view;
        }
}

// Phong as published: the lobe about r has the integral 1 as long as the horizon does not cut it, which it never does at view 0. Where it
// does, for n = 1 the clamped cosine about r over the hemisphere about n is (1 + cos t)/2 of pi.
TEST(DirectionalAlbedo, OfPhongHasItsClosedForms)
{
    for (const double n : {0.0, 1.0, 5.0, 1000.0})
        EXPECT_NEAR(directionalAlbedo({PhongBrdf{n}}, 0.0).g, 1.0, 1e-10) << n;
    for (const double view : {0.3, 0.8, 1.3, 1.5})
        EXPECT_NEAR(directionalAlbedo({PhongBrdf{1.0}}, view).g, 0.5 * (1.0 + std::cos(view)), 1e-5) << view;
}

// (n + 2)/(2 pi) cos^n times the cosine, at normal incidence: exactly 1. A retro-reflecting lobe is the same one turned about n.
TEST(DirectionalAlbedo, OfLafortuneIsOneAtNormalIncidence)
{
    for (const double n : {0.0, 3.0, 80.0})
        EXPECT_NEAR(directionalAlbedo(brdfFromText("lafortune:exponent=" + std::to_string(n)), 0.0).g, 1.0, 1e-9) << n;
    EXPECT_NEAR(directionalAlbedo(brdfFromText("lafortune:exponent=30,cxy=1,cz=1"), 0.7).g,
                directionalAlbedo(brdfFromText("lafortune:exponent=30"), 0.7).g, 1e-7);
}

// The white furnace. Masking only ever takes light away, so what these send back of a constant environment never exceeds 1; narrow lobes
// lose almost nothing.
TEST(WhiteFurnace, MicrofacetsWithSmithMaskingNeverSendBackMoreThanArrives)
{
    for (const char* model : {"ggx", "beckmann"})
        for (const double alpha : {0.01, 0.09, 0.25, 0.64, 1.0})
            for (const double deg : {0.0, 30.0, 60.0, 75.0, 85.0, 89.0}) {
                const double albedo =
                    directionalAlbedo(brdfFromText(std::string(model) + ":alpha=" + std::to_string(alpha)), deg * pi / 180).g;
                EXPECT_LE(albedo, 1.0 + 1e-3) << model << ' ' << alpha << ' ' << deg;
                EXPECT_GT(albedo, 0.3);
                if (alpha == 0.01 && deg < 80.0) {
                    EXPECT_GT(albedo, 0.99);
                }
            }
}

// What the others miss it by. Cook and Torrance's term is D/pi where energy asks for D/(4 pi): four times the light at normal incidence.
// Phong as published divides by the cosine of the light: seen from the other side, of light that comes in flat it sends out more than there
// was. Ward's root of the cosines loses light at flat views.
TEST(WhiteFurnace, ShowsWhatThePublishedModelsMissItBy)
{
    EXPECT_NEAR(directionalAlbedo({CookTorranceBrdf{0.05}}, 0.0).g, 4.0, 0.05);
    EXPECT_NEAR(directionalAlbedo({WardBrdf{0.05}}, 0.0).g, 1.0, 0.02);
    EXPECT_LT(directionalAlbedo({WardBrdf{0.2}}, 1.45).g, 0.3);
    const glm::dvec3 l = direction(1.5, 0.0);
    double out = 0.0;
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 400; ++j) {
            const double z = (i + 0.5) / 200, phi = 2 * pi * (j + 0.5) / 400, s = std::sqrt(1.0 - z * z);
            out += evaluate({PhongBrdf{5.0}}, l, {s * std::cos(phi), s * std::sin(phi), z}).g * z * 2 * pi / (200.0 * 400.0);
        }
    EXPECT_GT(out, 1.1);
}

} // namespace
} // namespace mirrorball
