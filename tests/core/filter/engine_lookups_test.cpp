#include "core/filter/engine_lookups.h"

#include "core/filter/lookup_table.h"
#include "core/shading/reflection_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mirrorball {
namespace {

glm::dvec3 sumOf(const LookupFit& fit)
{
    glm::dvec3 sum(0.0);
    for (const BrdfLookup& lookup : fit.lookups)
        sum += lookup.weight;
    return sum;
}

// The split sum's two factors are made for Schlick's F, which is linear in F0: with it they are the albedo.
TEST(EngineLookups, OfTheSplitSumAreTheAlbedoUnderSchlicksFresnelTerm)
{
    for (const char* text : {"ggx:alpha=0.25", "ggx:alpha=0.4,f0=0.04", "beckmann:alpha=0.2,f0=0.5", "phong:exponent=20"})
        for (const double view : {0.0, 0.8, 1.3}) {
            const Brdf brdf = brdfFromText(text);
            EXPECT_LT(glm::distance(sumOf(splitSum(brdf, view)), directionalAlbedo(brdf, view)), 1e-9) << text << ' ' << view;
        }
}

// White furnace, F0 = 1: what one bounce leaves out comes back in three and Filament, and not in the split sum.
TEST(EngineLookups, InAWhiteFurnaceReflectEverythingButTheSplitSumsOneBounce)
{
    for (const double alpha : {0.04, 0.25, 0.8})
        for (const double view : {0.1, 0.9, 1.4}) {
            const Brdf white{GgxBrdf{alpha}};
            EXPECT_NEAR(sumOf(threeLookups(engineMaterial(white), view)).g, 1.0, 1e-12) << alpha << ' ' << view;
            EXPECT_NEAR(sumOf(filamentLookups(engineMaterial(white), view)).g, 1.0, 1e-12) << alpha << ' ' << view;
            EXPECT_NEAR(sumOf(splitSum(white, view)).g, directionalAlbedo(white, view).g, 1e-9) << alpha << ' ' << view;
        }
    EXPECT_LT(sumOf(splitSum({GgxBrdf{0.8}}, 0.9)).g, 0.85);
}

// Bounce after bounce: of what the surface keeps, 1 - E, it reflects F on the mean, again and again.
TEST(EngineLookups, OfThreeAddTheSeriesOfBounces)
{
    const EngineMaterial copper{.roughness = 0.8, .f0 = {0.95, 0.64, 0.54}};
    const LookupFit fit = threeLookups(copper, 1.0);
    ASSERT_EQ(fit.lookups.size(), 2u);
    const double kept = 1.0 - directionalAlbedo({GgxBrdf{0.64}}, 1.0).g;
    const glm::dvec3 mean = copper.f0 * (20.0 / 21.0) + 1.0 / 21.0;
    glm::dvec3 bounce = fit.lookups[0].weight, sum(0.0);
    for (int i = 0; i < 200; ++i)
        sum += bounce *= mean * kept;
    EXPECT_LT(glm::distance(fit.lookups[1].weight, sum), 1e-9);
    EXPECT_DOUBLE_EQ(fit.lookups[1].offset, 1.0) << "the irradiance is looked up by the normal";
    EXPECT_DOUBLE_EQ(fit.lookups[1].alpha, 1.0);
}

// Filament's correction scales by F0: nothing is added to what reflects nothing straight on.
TEST(EngineLookups, OfFilamentAddNothingToABlackMaterial)
{
    const double bias = directionalAlbedo(brdfFromText("ggx:roughness=0.7,f0=0"), 0.9).g;
    EXPECT_NEAR(sumOf(filamentLookups({.roughness = 0.7, .f0 = glm::dvec3(0.0)}, 0.9)).g, bias, 1e-9);
}

// A mirror shows Schlick's F, whichever the engine: F0 + (1 - F0)(1 - n.v)^5.
TEST(EngineLookups, OfASmoothSurfaceAreSchlicksMirror)
{
    const EngineMaterial glass{.roughness = 0.045, .f0 = glm::dvec3(0.04)};
    for (const double view : {0.0, 0.7, 1.2}) {
        const double expected = 0.04 + 0.96 * std::pow(1.0 - std::cos(view), 5.0);
        EXPECT_NEAR(sumOf(threeLookups(glass, view)).g, expected, 2e-3) << view;
        EXPECT_NEAR(sumOf(filamentLookups(glass, view)).g, expected, 2e-3) << view;
        EXPECT_NEAR(threeLookups(glass, view).lookups[0].offset, 0.0, 1e-5) << view;
    }
}

TEST(EngineLookups, OfTheRoughestSurfaceAreReadAtTheNormal)
{
    for (const double view : {0.3, 1.2}) {
        EXPECT_NEAR(threeLookups({.roughness = 1.0}, view).lookups[0].offset, view, 1e-12);
        EXPECT_NEAR(filamentLookups({.roughness = 1.0}, view).lookups[0].offset, view, 1e-12);
    }
    // mix(r, n, 1/16) of directions 90 degrees apart, by its tangent
    EXPECT_NEAR(std::tan(filamentLookups({.roughness = 0.5}, 0.5 * pi - 1e-9).lookups[0].offset), 1.0 / 15.0, 1e-6);
}

TEST(EngineLookups, KnowAMaterialByItsReflectanceStraightOn)
{
    EXPECT_NEAR(engineMaterial(brdfFromText("ggx:alpha=0.25,ior=1.5")).f0.g, 0.04, 1e-12);
    EXPECT_NEAR(engineMaterial(brdfFromText("ggx:alpha=0.25")).roughness, 0.5, 1e-12);
    const glm::dvec3 gold = engineMaterial(brdfFromText("ggx:alpha=0.25,metal=gold")).f0;
    EXPECT_GT(gold.r, gold.g);
    EXPECT_GT(gold.g, gold.b);
    EXPECT_GE(engineMaterial(brdfFromText("ggx:alpha=0.001")).roughness, 0.045);
}

TEST(LookupChoice, IsReadFromTheWordThatItIsWrittenAs)
{
    for (const LookupChoice& choice :
         {LookupChoice{LookupKind::Fitted, 1}, LookupChoice{LookupKind::Fitted, 8}, LookupChoice{LookupKind::SplitSum},
          LookupChoice{LookupKind::Three}, LookupChoice{LookupKind::Filament}})
        EXPECT_EQ(lookupChoiceFromWord(describe(choice)), choice) << describe(choice);
    EXPECT_EQ(lookupChoiceFromWord("3"), (LookupChoice{LookupKind::Fitted, 3}));
    for (const char* word : {"", "0", "9", "fitted", "lookups", "lookups:", "lookups:12", "unity"})
        EXPECT_FALSE(lookupChoiceFromWord(word)) << word;
}

// A column of a table is what its engine does at that view.
TEST(LookupTable, HoldsWhatAnEngineDoesAtEveryView)
{
    const Brdf brdf = brdfFromText("ggx:alpha=0.36,metal=copper");
    for (const LookupKind kind : {LookupKind::SplitSum, LookupKind::Three, LookupKind::Filament}) {
        const Image table = makeLookupTable(brdf, {kind}, 8);
        for (const int column : {0, 5}) {
            const double view = std::acos((column + 0.5) / 8.0);
            const LookupFit read = lookupsAt(table, view), expected = lookupsFor(brdf, view, {kind});
            ASSERT_EQ(read.lookups.size(), expected.lookups.size());
            for (size_t k = 0; k < read.lookups.size(); ++k) {
                EXPECT_NEAR(read.lookups[k].offset, expected.lookups[k].offset, 1e-6);
                EXPECT_NEAR(read.lookups[k].alpha, expected.lookups[k].alpha, 1e-6);
                EXPECT_LT(glm::distance(read.lookups[k].weight, expected.lookups[k].weight), 1e-6);
            }
        }
    }
}

} // namespace
} // namespace mirrorball
