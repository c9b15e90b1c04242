#include "core/shading/brdf.h"

#include "core/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

glm::dvec3 direction(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double value(const Brdf& brdf, const glm::dvec3& l, const glm::dvec3& v) { return evaluate(brdf, l, v).g; }

const glm::dvec3 l = direction(0.7, 0.3), v = direction(0.4, 2.9);

std::vector<Brdf> reciprocalModels()
{
    return {{WardBrdf{0.2}},
            {CookTorranceBrdf{0.3}},
            {BeckmannBrdf{0.3}},
            {GgxBrdf{0.25}},
            {GgxBrdf{0.5}, {.kind = BrdfFresnelKind::Dielectric, .index = 1.5}},
            {GgxBrdf{0.1}, {.kind = BrdfFresnelKind::Metal, .metal = "gold"}},
            {LafortuneBrdf{{{-1.0, 1.0, 10.0, 0.5}, {0.9, 0.9, 5.0, 0.2}}}}};
}

TEST(Brdf, IsReciprocalWhereTheModelIs)
{
    for (const Brdf& brdf : reciprocalModels())
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 a = direction(1.5 * std::fmod(0.618 * i, 1.0), 2.4 * i),
                             b = direction(1.5 * std::fmod(0.412 * i, 1.0), 0.9 * i);
            EXPECT_LE(glm::distance(evaluate(brdf, a, b), evaluate(brdf, b, a)), 1e-12 * glm::length(evaluate(brdf, a, b)))
                << describe(brdf);
        }
}

// Equation 16 divides by the cosine of the light alone, so exchanging the directions changes the value by the quotient of the cosines.
TEST(Brdf, OfPhongAsPublishedIsNotReciprocal)
{
    const Brdf phong{PhongBrdf{20.0}};
    EXPECT_NEAR(value(phong, l, v) / value(phong, v, l), v.z / l.z, 1e-12);
    EXPECT_GT(std::abs(v.z / l.z - 1.0), 0.1);
}

TEST(Brdf, OfPhongIsItsLobeOverTheCosine)
{
    const glm::dvec3 r(-v.x, -v.y, v.z);
    const double expected = 21.0 / (2.0 * pi) * std::pow(std::max(glm::dot(r, l), 0.0), 20.0) / l.z;
    EXPECT_NEAR(value({PhongBrdf{20.0}}, l, v), expected, 1e-12 * expected);
    EXPECT_NEAR(value({PhongBrdf{20.0, 3.0}}, l, v), 3.0 * expected, 1e-11 * expected);
}

// The model's own formulas, with the half vector made as a vector.
TEST(Brdf, OfMicrofacetsFollowsItsEquations)
{
    const glm::dvec3 h = glm::normalize(l + v);
    const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z), cos4 = std::pow(h.z, 4.0), hv = glm::dot(h, v);
    {
        const double m = 0.3, d = std::exp(-tan2 / (m * m)) / (m * m * cos4);
        const double g = std::min({1.0, 2.0 * h.z * l.z / hv, 2.0 * h.z * v.z / hv});
        EXPECT_NEAR(value({CookTorranceBrdf{m}}, l, v), d * g / (pi * l.z * v.z), 1e-10);
    }
    {
        const double a = 0.2;
        EXPECT_NEAR(value({WardBrdf{a}}, l, v), std::exp(-tan2 / (a * a)) / (4.0 * pi * a * a * std::sqrt(l.z * v.z)), 1e-10);
    }
    {
        const double a2 = 0.25 * 0.25, d = a2 / (pi * cos4 * std::pow(a2 + tan2, 2.0));
        const auto lambda = [&](double c) { return 0.5 * (std::sqrt(1.0 + a2 * (1.0 - c * c) / (c * c)) - 1.0); };
        EXPECT_NEAR(value({GgxBrdf{0.25}}, l, v), d / ((1.0 + lambda(l.z) + lambda(v.z)) * 4.0 * l.z * v.z), 1e-10);
    }
}

TEST(Brdf, OfLafortuneReturnsTheLightWhereItsLobeDoes)
{
    const Brdf retro{LafortuneBrdf{{{1.0, 1.0, 40.0, 1.0}}}};
    EXPECT_GT(value(retro, v, v), 100.0 * value(retro, glm::dvec3(-v.x, -v.y, v.z), v));
    const Brdf modified{LafortuneBrdf{{{-1.0, 1.0, 40.0, 1.0}}}};
    EXPECT_NEAR(value(modified, glm::dvec3(-v.x, -v.y, v.z), v), 42.0 / (2.0 * pi), 1e-12) << "1 at the mirror direction, (n+2)/(2 pi)";
}

TEST(Brdf, HasItsFresnelTermAtTheHalfVector)
{
    const double hl = glm::dot(glm::normalize(l + v), l);
    const BrdfFresnel glass{.kind = BrdfFresnelKind::Dielectric, .index = 1.5};
    EXPECT_NEAR(value({GgxBrdf{0.25}, glass}, l, v), value({GgxBrdf{0.25}}, l, v) * FresnelCurve(glass).at(hl).g, 1e-12);
}

TEST(Brdf, IsZeroBelowTheHorizon)
{
    EXPECT_EQ(evaluate({GgxBrdf{0.5}}, {0.0, 0.6, -0.8}, v), glm::dvec3(0.0));
    EXPECT_EQ(evaluate({GgxBrdf{0.5}}, l, {0.6, 0.0, -0.8}), glm::dvec3(0.0));
}

TEST(Brdf, IsReadFromTextAndWrittenAsTheSame)
{
    for (const char* text : {"phong:exponent=50", "phong:exponent=50,strength=2", "ward:alpha=0.15", "cook-torrance:m=0.2,ior=1.5",
                             "beckmann:alpha=0.3,f0=0.04", "ggx:alpha=0.09,metal=copper",
                             "lafortune:exponent=20,cxy=-1,cz=1,weight=0.7/exponent=5,cxy=0.9,cz=0.9,weight=0.2"})
        EXPECT_EQ(describe(brdfFromText(text)), text);
    EXPECT_EQ(brdfFromText("ggx:roughness=0.3"), brdfFromText("ggx:alpha=0.09"));
}

TEST(Brdf, SaysWhatIsWrongWithAText)
{
    const std::pair<const char*, const char*> cases[] = {{"ggx", "alpha is missing"},
                                                         {"ggx:alpha=2", "alpha: must be a number from 0.001 to 1"},
                                                         {"ggx:alpha=x", "it is \"x\""},
                                                         {"ggx:alpha=0.1,bogus=1", "does not know \"bogus\""},
                                                         {"ggx:alpha=0.1,alpha=0.2", "given twice"},
                                                         {"ggx:alpha", "expected key=value"},
                                                         {"ggx:alpha=0.1,ior=1.5,metal=gold", "give one of them"},
                                                         {"ggx:alpha=0.1,metal=mithril", "choose one of silver"},
                                                         {"blinn:exponent=3", "choose phong, lafortune"},
                                                         {"missing.brdf", "is not there"}};
    for (const auto& [text, expected] : cases)
        try {
            brdfFromText(text);
            FAIL() << text;
        } catch (const InvalidArgument& e) {
            EXPECT_THAT(e.what(), testing::HasSubstr(expected));
            EXPECT_THAT(e.what(), testing::Not(testing::HasSubstr("\n")));
        }
}

} // namespace
} // namespace mirrorball
