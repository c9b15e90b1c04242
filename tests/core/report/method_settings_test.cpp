#include "core/report/lobe_words.h"
#include "core/report/method_settings.h"

#include "core/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(LobeWords, AreReadBackAsTheyAreDescribed)
{
    for (const Lobe& lobe : {phongLobe(50), phongLobe(0), phongLobe(2.5), ggxLobe(0.3), ggxLobe(1), diffuseLobe()})
        EXPECT_EQ(lobeFromWord(describe(lobe)), lobe) << describe(lobe);
    const std::vector<Lobe> expected{phongLobe(50), ggxLobe(0.3), diffuseLobe()};
    EXPECT_EQ(lobesFromWords("phong:50,ggx:0.3,diffuse"), expected);
}

TEST(LobeWords, RefuseOthersNamingTheWord)
{
    for (const char* word :
         {"", "phong", "phong:", "phong:x", "phong:5x", "phong:-1", "ggx:2", "ggx:nan", "phong:inf", "cone:3", "diffuse:1", "phong:50,"})
        EXPECT_THROW(lobesFromWords(word), InvalidArgument) << word;
    try {
        lobesFromWords("phong:50,cone:3");
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("cone:3"));
    }
}

TEST(MethodSettings, GoFromCheapToDearAndHoldTheTolerance)
{
    for (const Sweep sweep : {Sweep::Few, Sweep::Usual})
        for (const Method method : allMethods) {
            const auto settings = methodSettings(method, sweep, 3e-4);
            ASSERT_FALSE(settings.empty());
            bool hasTolerance = false;
            for (size_t i = 0; i < settings.size(); ++i) {
                EXPECT_EQ(settings[i].method, method);
                hasTolerance = hasTolerance || settings[i].tolerance == 3e-4;
                if (i > 0) {
                    EXPECT_LE(settings[i].tolerance, settings[i - 1].tolerance);
                    EXPECT_GE(settings[i].knobs.samples, settings[i - 1].knobs.samples);
                    EXPECT_NE(settings[i].label, settings[i - 1].label);
                }
            }
            if (method == Method::Auto || method == Method::Spectral) {
                EXPECT_TRUE(hasTolerance);
            }
        }
}

TEST(MethodSettings, SpellNumbersShort)
{
    const std::pair<double, const char*> cases[] = {{1e-3, "1e-3"},   {0.25, "0.25"},   {50, "50"},
                                                    {1024, "1.02e3"}, {1.5e7, "1.5e7"}, {2.345e-5, "2.35e-5"},
                                                    {0, "0"},         {-1e-6, "-1e-6"}, {123, "123"}};
    for (const auto& [value, text] : cases)
        EXPECT_EQ(shortNumber(value), text);
    EXPECT_EQ(shortNumber(16384, 6), "16384");
    EXPECT_EQ(exactNumber(0.1), "0.1");
    EXPECT_EQ(std::stod(exactNumber(1.0 / 3.0)), 1.0 / 3.0);
}

TEST(MethodSettings, SpellTheCommandThatMakesTheMap)
{
    const MapLayout cube{Parameterization::Cube, 64, 0};
    EXPECT_EQ(filterCommand("a b.hdr", {.lobe = phongLobe(50), .target = cube, .method = Method::Importance, .knobs = {.samples = 256}}),
              "mirrorball filter 'a b.hdr' -o map.exr --lobe phong --exponent 50 --to cube --size 64 --method importance --samples 256");
    EXPECT_EQ(filterCommand("builtin:sky", {.lobe = ggxLobe(0.3), .target = cube, .method = Method::Spectral, .tolerance = 1e-4}),
              "mirrorball filter builtin:sky -o map.exr --lobe ggx --alpha 0.3 --to cube --size 64 --method spectral --tolerance 1e-4");
    EXPECT_EQ(filterCommand("p.hdr", {.lobe = diffuseLobe(),
                                      .target = cube,
                                      .method = Method::Paraboloid,
                                      .knobs = {.paraboloid = {.kernel = ParaboloidKernel::Blended, .clamp = 0.1, .largestKernel = 7}}}),
              "mirrorball filter p.hdr -o map.exr --lobe diffuse --to cube --size 64 --method paraboloid --paraboloid blended "
              "--paraboloid-clamp 0.1 "
              "--paraboloid-kernel 7");
}

} // namespace
} // namespace mirrorball
