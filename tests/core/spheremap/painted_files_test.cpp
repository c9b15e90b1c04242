#include "core/spheremap/evaluation/painted_files.h"

#include "core/base/error.h"
#include "core/image/image_io.h"
#include "support/stroke_builders.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

SphereMapDocument opaqueMap()
{
    SphereMapDocument document;
    document.layers = {{.content = GradientLayer{}},
                       {.opacity = 0.7, .content = PaintLayer{.strokes = handDrawnStrokes(6, 3, 0.05, 0.5, 10)}},
                       {.content = SilhouetteLayer{.unit = WidthUnit::Pixels}}};
    return document;
}

/// What a file holds of what evaluating the map at once gives, its border and its opacity too.
void expectAsAWhole(const SphereMapDocument& document, const PaintedOptions& options, int channels)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "map.exr";
    const PaintedFiles made = writePainted(file, document, options, SampleType::Float, {.threads = 2});
    ASSERT_EQ(made.files, std::vector{file});
    ASSERT_EQ(made.levels.size(), 1u);
    EXPECT_EQ(made.levels.front().edge, options.size);
    EXPECT_EQ(made.levels.front().channels, channels);
    const Image whole = paintedPictures(document, options).front();
    ASSERT_EQ(whole.channels, channels);
    EXPECT_TRUE(readImage(file, {}, channels == 4 ? Channels::ColorAndOpacity : Channels::Color) == whole);
}

// 2048 is where bands begin, and 2060 is no multiple of theirs.
TEST(PaintedFiles, OfALargeMapMadeBandByBandHoldTheBytesOfTheWhole)
{
    expectAsAWhole(opaqueMap(), {.size = 2048}, 3);
    expectAsAWhole(opaqueMap(), {.size = 2060, .border = 6}, 3);
    SphereMapDocument translucent = opaqueMap();
    translucent.layers.erase(translucent.layers.begin());
    expectAsAWhole(translucent, {.size = 2060, .border = 6}, 4);
}

// One texel in four million is enough for an alpha channel.
TEST(PaintedFiles, KeepTheOpacityOfADot)
{
    SphereMapDocument document;
    document.layers = {
        {.content = FillLayer{},
         .mask = Mask{.content = PaintLayer{.strokes = {dab({0.0, 0.0},
                                                            {.color = {1, 1, 1}, .radius = smallestRadius, .hardness = 1.0, .flow = 1.0})}},
                      .channel = MaskChannel::Opacity,
                      .invert = true}}};
    expectAsAWhole(document, {.size = 2048}, 4);
}

TEST(PaintedFiles, RefuseWhatPicturesRefuse)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(writePainted(folder.path() / "map.exr", opaqueMap(), {.size = 2048, .border = 1024}, SampleType::Half), InvalidArgument);
    EXPECT_THROW(writePainted(folder.path() / "map.exr", opaqueMap(), {.size = 16384}, SampleType::Half), InvalidArgument);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
} // namespace mirrorball
