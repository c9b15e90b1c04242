/// Files that users of other programs reported, in ../shared/reports beside the checkout: each shows the field of support/field.h, whatever
/// its kind does to it. The same kinds are made by foreign_files_test; these are of other hands.

#include "core/base/error.h"
#include "core/image/probe_file.h"
#include "support/field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace mirrorball {
namespace {

using testing::HasSubstr;

struct Reports : testing::Test {
    const std::filesystem::path folder = std::filesystem::path(MIRRORBALL_SHARED_DATA) / "../reports";

    void SetUp() override
    {
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << folder << " is not there";
    }
    Probe read(const std::string& name, const ProbeReading& reading = {}) const
    {
        return readProbe((folder / name).string(), {.reading = reading});
    }
    static Assumption assumed(const Probe& probe, const std::string& topic)
    {
        for (const Assumption& a : probe.assumed)
            if (a.topic == topic)
                return a;
        return {};
    }
};

struct Expected {
    const char* name;
    Parameterization kind;
    double within; ///< of the field: the step of what the file stores
    ProbeReading reading{};
};

TEST_F(Reports, AreReadAsTheFieldThatTheyShow)
{
    const std::vector<Expected> files{
        {"e-plain.exr", Parameterization::Latlong, 1e-6},
        {"h-plain.hdr", Parameterization::Latlong, 0.004}, // rgbe: a step of 1/256 of the largest channel
        {"e-part0-depth.exr", Parameterization::Latlong, 1e-3},
        {"e-normal-xyz-before-beauty.exr", Parameterization::Latlong, 1e-3},
        {"c-strip-6x1.exr", Parameterization::Cube, 1e-3},
        {"c-hcross-gl.exr", Parameterization::Cube, 1e-3, {.mirror = MirrorAxis::X}},
        {"c-face_%s.hdr", Parameterization::Cube, 0.004},
        {"d-cube-dx10-half.dds", Parameterization::Cube, 1e-3},
        {"x-cube.ktx", Parameterization::Cube, 1e-3},
        {"h-exposure-zero.hdr", Parameterization::Latlong, 0.004},
        {"e-1917x938ish.exr", Parameterization::Latlong, 0.01}, // stretched: bilinear between texels of 3 degrees
    };
    for (const Expected& file : files) {
        const Probe probe = read(file.name, file.reading);
        EXPECT_EQ(probe.map.layout.kind, file.kind) << file.name;
        EXPECT_LE(test::distanceFromField(probe.map), file.within) << file.name;
    }
}

TEST_F(Reports, SayWhatWasChosenAndWhatElseThereIs)
{
    EXPECT_THAT(assumed(read("e-part0-depth.exr"), "part").others, testing::Not(testing::IsEmpty()));
    const Assumption layer = assumed(read("e-normal-xyz-before-beauty.exr"), "layer");
    EXPECT_THAT(layer.value, HasSubstr("beauty"));
    EXPECT_THAT(layer.others, testing::Not(testing::IsEmpty()));
    EXPECT_EQ(assumed(read("c-hcross-gl.exr"), "handedness").certainty, Certainty::Likely);
    EXPECT_THAT(assumed(read("c-hcross-gl.exr"), "handedness").others, testing::Contains(HasSubstr("--mirror x")));
    EXPECT_THAT(read("h-exposure-zero.hdr").notes, testing::Contains(HasSubstr("EXPOSURE")));
    EXPECT_THAT(read("e-1917x938ish.exr").notes, testing::Contains(HasSubstr("2:1")));
    EXPECT_THAT(assumed(read("p-gama45455.png"), "encoding").value, HasSubstr("gamma 2.2"));
    EXPECT_THAT(assumed(read("p-icc-linear-16.png"), "encoding").value, HasSubstr("ICC"));
}

TEST_F(Reports, ACropLiesInItsDisplayWindow)
{
    const Probe probe = read("e-crop-2to1.exr");
    ASSERT_EQ(probe.map.layout, (MapLayout{Parameterization::Latlong, 32, 0}));
    int black = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const float* texel = probe.map.image.texel(x, y);
            const bool isBlack = texel[0] == 0.0f && texel[1] == 0.0f && texel[2] == 0.0f;
            black += isBlack ? 1 : 0;
            for (int c = 0; c < 3 && !isBlack; ++c)
                EXPECT_NEAR(texel[c], test::fieldAt(texelDirection(probe.map.layout, x, y))[c], 1e-3);
        }
    EXPECT_GT(black, 0);
    EXPECT_LT(black, 64 * 32);
    EXPECT_THAT(probe.notes, testing::Contains(HasSubstr(std::to_string(black) + " of 2048")));
}

TEST_F(Reports, EncodedPicturesHaveTheMeanOfTheField)
{
    for (const char* name : {"p-gama45455.png", "p-icc-linear-16.png", "p-rgba.png"}) {
        const Probe probe = read(name);
        EXPECT_LT(test::distanceFromField(probe.map), 0.01) << name;
    }
    // Upright: upside down it would be off by 0.8. JPEG's coarser steps of color, times the slope of sRGB where it is steepest.
    EXPECT_LT(test::distanceFromField(read("j-orient3.jpg").map), 0.05);
}

TEST_F(Reports, RowsWithoutAValueAreFilled)
{
    const Probe probe = read("s-nan-rows.exr");
    EXPECT_EQ(*std::min_element(probe.map.image.texels.begin(), probe.map.image.texels.end()), 1.0f);
    EXPECT_EQ(*std::max_element(probe.map.image.texels.begin(), probe.map.image.texels.end()), 1.0f);
    EXPECT_GT(probe.repaired.nan, 0);
    EXPECT_GT(probe.repaired.filledRows, 0);
}

TEST_F(Reports, HalfAlphaIsOpacityOfASphereMapAndNothingOfAProbe)
{
    const Image colors = readImage(folder / "k-half-alpha.png");
    const Image rgba = readImage(folder / "k-half-alpha.png", {}, Channels::ColorAndOpacity);
    size_t halfOpaque = 0;
    for (size_t i = 0; i < colors.texels.size() / 3; ++i) {
        const float alpha = rgba.texels[4 * i + 3];
        ASSERT_TRUE(alpha >= 0.0f && alpha <= 1.0f);
        halfOpaque += std::abs(alpha - 128.0f / 255.0f) < 1e-6f ? 1 : 0;
        for (size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(rgba.texels[4 * i + c], colors.texels[3 * i + c] * alpha, 1e-6f);
    }
    EXPECT_GT(halfOpaque, 0u);
}

TEST_F(Reports, HostileFilesAreRefused)
{
    for (const char* name : {"abort_dpx_named.hdr", "segv_iff_1.iff", "3.7GB_10s.psd"})
        EXPECT_THROW(read(name), FileError) << name;
}

} // namespace
} // namespace mirrorball
