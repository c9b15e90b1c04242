#include "core/base/error.h"
#include "core/image/image_io.h"
#include "support/exr_builders.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mirrorball {
namespace {

using testing::HasSubstr;

const std::string plainHeader = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

/// (1, 0.5, 0.25) as RGBE: exponent 129 makes a mantissa step 2^-7.
const std::string warm("\x80\x40\x20\x81", 4);

class HdrFormat : public testing::Test {
protected:
    Image read(const std::string& bytes)
    {
        test::writeBytes(path, bytes);
        return readImage(path);
    }
    std::string error(const std::string& bytes)
    {
        try {
            read(bytes);
        } catch (const FileError& e) {
            return e.what();
        }
        return "no error";
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder / "picture.hdr";
};

/// A picture of distinct texels, `count` of them: red is the number, blue 0 and green 128, which fixes the exponent at step 1.
std::string numbered(int count)
{
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += std::string{static_cast<char>(i), '\x80', '\0', '\x88'};
    return bytes;
}

TEST_F(HdrFormat, DecodesMantissaTimesPowerOfTwo)
{
    const Image image = read(plainHeader + "-Y 1 +X 1\n" + warm);
    EXPECT_EQ(image.texels, (std::vector<float>{1.0f, 0.5f, 0.25f}));
}

TEST_F(HdrFormat, TakesExponentZeroForBlackAndKeepsTheWholeRange)
{
    const Image image = read(plainHeader + "-Y 1 +X 3\n" + std::string("\xff\xff\xff\0\x01\0\0\x01\xff\0\0\xff", 12));
    EXPECT_EQ(image.texel(0, 0)[0], 0.0f);
    EXPECT_EQ(image.texel(1, 0)[0], 0x1p-135f);
    EXPECT_EQ(image.texel(2, 0)[0], 0x1.FEp126f);
}

TEST_F(HdrFormat, AcceptsTheHeadersThatAreMetInTheWild)
{
    const std::vector<float> expected{1.0f, 0.5f, 0.25f};
    const std::string end = "\n-Y 1 +X 1\n" + warm;
    for (const std::string header :
         {"#?RGBE\nFORMAT=32-bit_rle_rgbe\n", "#?RADIANCE\n#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n",
          "#?RADIANCE\n# Made with Adobe Photoshop\nGAMMA=1\nPRIMARIES=0 0 0 0 0 0 0 0\nFORMAT=32-bit_rle_rgbe\n",
          "#?RADIANCE\nformat=32-bit_rle_rgbe\n", "#?RADIANCE\n", "#?RADIANCE\nrpict -vp 1 2 3\nFORMAT= 32-bit_rle_rgbe\n",
          "#?RADIANCE\nPRIMARIES=0.640 0.330 0.300 0.600 0.150 0.060 0.3127 0.3290\n"})
        EXPECT_EQ(read(header + end).texels, expected) << header;
    EXPECT_EQ(read("#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" + warm).texels, expected);
}

TEST_F(HdrFormat, DividesByTheProductOfAllExposuresAndColorCorrections)
{
    const Image image = read("#?RADIANCE\nEXPOSURE=2\nexposure= 4.0e+00\nCOLORCORR=1 2 0.5\nEXPOSURE=0.5\n\n-Y 1 +X 1\n" + warm);
    EXPECT_EQ(image.texels, (std::vector<float>{1.0f / 4, 0.5f / 8, 0.25f / 2}));
}

TEST_F(HdrFormat, LeavesOutHeaderLinesThatMakeNoSenseAndSaysSo)
{
    const std::string picture = "\n-Y 1 +X 1\n" + warm;
    const Image plain = read("#?RADIANCE\n" + picture);
    for (const std::string line : {"EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=bright", "EXPOSURE=inf", "COLORCORR=1 1", "PRIMARIES=1 2",
                                   "PRIMARIES=.3 .3 .3 .3 .3 .3 .3 .3", "EXPOSURE=1e-25\nEXPOSURE=1e-25"}) {
        EXPECT_EQ(read("#?RADIANCE\n" + line + "\n" + picture), plain) << line;
        const std::vector<std::string> notes = openImage(path)->info().notes;
        ASSERT_EQ(notes.size(), 1u) << line;
        EXPECT_THAT(notes.front(), HasSubstr(line.substr(0, 5))) << line;
    }
}

TEST_F(HdrFormat, ConvertsOtherPrimariesAndKeepsWhite)
{
    // Green of DCI-P3 lies outside Rec.709: its red is negative there. White has no hue in either.
    const std::string header = "#?RADIANCE\nPRIMARIES=0.680 0.320 0.265 0.690 0.150 0.060 0.3127 0.3290\n\n-Y 1 +X 2\n";
    const Image image = read(header + std::string("\x80\x80\x80\x81\0\x80\0\x81", 8));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image.texel(0, 0)[c], 1.0f, 1e-5f);
    EXPECT_LT(image.texel(1, 0)[0], -0.1f);
    EXPECT_GT(image.texel(1, 0)[1], 1.0f);
}

TEST_F(HdrFormat, ConvertsXyzAndKeepsGray)
{
    const Image image = read("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n" + std::string("\x80\x80\x80\x81\x80\0\0\x81", 8));
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image.texel(0, 0)[c], 1.0f, 1e-5f);
    EXPECT_GT(image.texel(1, 0)[0], 1.0f); // pure X is redder than any color
    EXPECT_LT(image.texel(1, 0)[1], 0.0f);
}

TEST_F(HdrFormat, TurnsEveryOrderOfTheResolutionLineTopToBottomLeftToRight)
{
    // Texel (x, y) of the picture below holds 3 y + x: width 3, height 2. Stored in each order by its definition.
    struct Stored {
        std::string line;
        std::vector<int> order;
    };
    const std::vector<Stored> cases{{"-Y 2 +X 3", {0, 1, 2, 3, 4, 5}}, {"-Y 2 -X 3", {2, 1, 0, 5, 4, 3}}, {"+Y 2 +X 3", {3, 4, 5, 0, 1, 2}},
                                    {"+Y 2 -X 3", {5, 4, 3, 2, 1, 0}}, {"+X 3 -Y 2", {0, 3, 1, 4, 2, 5}}, {"-X 3 -Y 2", {2, 5, 1, 4, 0, 3}},
                                    {"+X 3 +Y 2", {3, 0, 4, 1, 5, 2}}, {"-X 3 +Y 2", {5, 2, 4, 1, 3, 0}}};
    const std::string texels = numbered(6);
    for (const Stored& stored : cases) {
        std::string bytes = plainHeader + stored.line + "\n";
        for (const int i : stored.order)
            bytes += texels.substr(4 * static_cast<size_t>(i), 4);
        const Image image = read(bytes);
        ASSERT_EQ(image.width, 3) << stored.line;
        ASSERT_EQ(image.height, 2) << stored.line;
        for (int i = 0; i < 6; ++i)
            EXPECT_EQ(image.texel(i % 3, i / 3)[0], static_cast<float>(i)) << stored.line;
    }
}

TEST_F(HdrFormat, DecodesRunsAndLiterals)
{
    // Two scanlines of 10: a run of 10; 4 literals and a run of 6, for each of the four components.
    std::string bytes = plainHeader + "-Y 2 +X 10\n";
    bytes += std::string("\x02\x02\0\x0a", 4);
    for (const char value : {'\x10', '\x20', '\x80', '\x88'})
        bytes += std::string{'\x8a', value};
    bytes += std::string("\x02\x02\0\x0a", 4);
    for (int c = 0; c < 3; ++c)
        bytes += std::string("\x04\x01\x02\x03\x80\x86\x07", 7);
    bytes += std::string("\x8a\x88", 2);
    const Image image = read(bytes);
    EXPECT_EQ(image.texel(9, 0)[0], 16.0f);
    EXPECT_EQ(image.texel(0, 0)[2], 128.0f);
    EXPECT_EQ(image.texel(2, 1)[1], 3.0f);
    EXPECT_EQ(image.texel(3, 1)[1], 128.0f);
    EXPECT_EQ(image.texel(9, 1)[2], 7.0f);
}

TEST_F(HdrFormat, DecodesTheOldRunsWithCountsOfSeveralDigits)
{
    // 1 texel, repeated 0x02 + 0x0100 times = 258, then another texel: 260 in all.
    const Image image = read(plainHeader + "-Y 1 +X 260\n" + warm + std::string("\x01\x01\x01\x02\x01\x01\x01\x01", 8) + numbered(1));
    EXPECT_EQ(image.texel(258, 0)[0], 1.0f);
    EXPECT_EQ(image.texel(259, 0)[1], 128.0f);
}

TEST_F(HdrFormat, ReadsPicturesTooNarrowOrTooWideForRuns)
{
    for (const int width : {1, 7, 32768}) {
        const Image image = test::smallIntegerImage(width, 2);
        writeImage(path, image);
        EXPECT_EQ(readImage(path), image) << width;
    }
}

TEST_F(HdrFormat, GivesBackWhatItWroteExactlyWhereRgbeHoldsIt)
{
    for (const int width : {8, 127, 128, 129, 1000, 32767}) {
        Image image = test::smallIntegerImage(width, 3);
        for (int x = width / 4; x < width / 2; ++x) // runs as well
            std::fill_n(image.texel(x, 1), 3, 0.5f);
        writeImage(path, image);
        EXPECT_EQ(readImage(path), image) << width;
    }
}

TEST_F(HdrFormat, RoundsToTheNearestMantissa)
{
    Image image = test::wildImage(500, 20);
    for (float& value : image.texels)
        value = std::abs(value);
    writeImage(path, image);
    const Image back = readImage(path);
    for (size_t i = 0; i < image.texels.size(); i += 3) {
        const float brightest = std::max({image.texels[i], image.texels[i + 1], image.texels[i + 2]});
        // The brightest mantissa lies in [128, 255]: a step is at most brightest / 127.5, the nearest value half of that away.
        for (size_t c = 0; c < 3; ++c)
            ASSERT_LE(std::abs(back.texels[i + c] - image.texels[i + c]), brightest / 255.0f);
    }
}

TEST_F(HdrFormat, WritesNoNegativeNanOrInfiniteValues)
{
    Image image(2, 2);
    image.texels = {-1, 2, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1, 1, 3e38f, 0, 0, 1e-40f,
                    0,  0};
    writeImage(path, image);
    EXPECT_EQ(readImage(path).texels, (std::vector<float>{0, 2, 0, 0x1.FEp126f, 0, 0, 0x1.FEp126f, 0, 0, 0, 0, 0}));
}

TEST_F(HdrFormat, WritesTheHeaderThatAllToolsReadAndNothingElse)
{
    writeImage(path, Image(9, 2, 3, 1.0f), {.attributes = {{"mirrorball:parameterization", "latlong"}}});
    EXPECT_TRUE(test::readBytes(path).starts_with("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n\x02\x02"));
}

TEST_F(HdrFormat, StreamsRowsInBlocksOfAnySizeAndFromTheTopAgain)
{
    const Image image = test::smallIntegerImage(40, 30);
    writeImage(path, image);
    const auto reader = openImage(path);
    for (int pass = 0; pass < 2; ++pass) {
        Image back(40, 30);
        for (int y = 0; y < 30;) {
            const int rows = std::min(1 + y % 4, 30 - y);
            reader->readRows(y, rows, back.row(y));
            y += rows;
        }
        EXPECT_EQ(back, image);
    }
}

TEST_F(HdrFormat, OpensOnTheHeaderAlone)
{
    // The texels are garbage, which opening must not notice.
    test::writeBytes(path, plainHeader + "-Y 2 +X 9\n" + std::string("\x02\x02\x7f\x7f", 4) + std::string(100, '\x02'));
    EXPECT_EQ(openImage(path)->info().width, 9);
    EXPECT_THROW(readImage(path), FileError);
}

} // namespace
} // namespace mirrorball
