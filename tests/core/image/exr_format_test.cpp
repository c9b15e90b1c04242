#include "core/base/error.h"
#include "core/image/image_io.h"
#include "support/exr_builders.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <ImfChromaticities.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mirrorball {
namespace {

using test::ExrChannel;
using testing::HasSubstr;

class ExrFormat : public testing::Test {
protected:
    std::string readError()
    {
        try {
            readImage(path);
        } catch (const FileError& e) {
            return e.what();
        }
        return "no error";
    }

    /// A file of 2 x 1 texels whose channels hold 1 and 2 times their place in the list.
    void writeNamed(const std::vector<std::string>& names, Imf::PixelType type = Imf::FLOAT)
    {
        std::vector<ExrChannel> channels;
        for (size_t i = 0; i < names.size(); ++i)
            channels.push_back({names[i], {static_cast<float>(i + 1), static_cast<float>(2 * (i + 1))}});
        test::writeScanlineExr(path, test::exrHeader(2, 1, channels, type), channels);
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder / "image.exr";
};

TEST_F(ExrFormat, GivesBackFloatsBitForBit)
{
    const Image image = test::wildImage(131, 77);
    writeImage(path, image);
    EXPECT_EQ(readImage(path), image);
    EXPECT_EQ(openImage(path)->info().sampleType, "float");
}

TEST_F(ExrFormat, GivesBackHalvesExactlyAndClampsWhatIsTooLarge)
{
    Image image = test::smallIntegerImage(70, 300);
    image.texel(0, 0)[0] = 1e9f;
    image.texel(0, 0)[1] = -std::numeric_limits<float>::infinity();
    image.texel(69, 299)[2] = 65519.0f; // the last value that rounds to a finite half
    writeImage(path, image, {.sampleType = SampleType::Half});
    image.texel(0, 0)[0] = 65504.0f;
    image.texel(0, 0)[1] = -65504.0f;
    image.texel(69, 299)[2] = 65504.0f;
    EXPECT_EQ(readImage(path), image);
    EXPECT_EQ(openImage(path)->info().sampleType, "half");
}

TEST_F(ExrFormat, CompressesWhatDeflateCanShortenAndNothingElse)
{
    writeImage(path, test::smallIntegerImage(64, 64));
    EXPECT_EQ(openImage(path)->info().compression, "zip");
    writeImage(path, test::wildImage(64, 64));
    EXPECT_EQ(openImage(path)->info().compression, "none");
}

TEST_F(ExrFormat, WritesTheSameBytesForTheSameImage)
{
    const Image image = test::wildImage(200, 100);
    writeImage(path, image);
    writeImage(folder / "again.exr", image);
    EXPECT_TRUE(test::readBytes(path) == test::readBytes(folder / "again.exr"));
}

TEST_F(ExrFormat, ReadsEveryLosslessCompressionInScanlinesAndTiles)
{
    const Image image = test::smallIntegerImage(100, 70); // sizes that no block divides
    const auto channels = test::exrChannels(image);
    for (const Imf::Compression compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
                                               Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
        for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
            const Imf::Header header = test::exrHeader(100, 70, channels, type, compression);
            test::writeScanlineExr(path, header, channels);
            EXPECT_EQ(readImage(path), image) << compression;
            test::writeTiledExr(path, header, channels, 32, 16);
            EXPECT_EQ(readImage(path), image) << compression;
        }
    }
}

TEST_F(ExrFormat, ReadsTheLossyCompressionsWithinTheirTolerance)
{
    Image image(96, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x)
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = 0.5f + 0.3f * std::sin(0.05f * static_cast<float>(x + 2 * y + 10 * c));
    const auto channels = test::exrChannels(image);
    for (const Imf::Compression compression : {Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        test::writeScanlineExr(path, test::exrHeader(96, 64, channels, Imf::HALF, compression), channels);
        const Image back = readImage(path);
        for (size_t i = 0; i < image.texels.size(); ++i) // smooth content: both keep it to about a hundredth
            ASSERT_NEAR(back.texels[i], image.texels[i], 0.02f) << compression;
    }
}

TEST_F(ExrFormat, StreamsRowsInBlocksOfAnySize)
{
    const Image image = test::smallIntegerImage(50, 90);
    const auto channels = test::exrChannels(image);
    const Imf::Header header = test::exrHeader(50, 90, channels, Imf::FLOAT);
    for (const bool tiled : {false, true}) {
        if (tiled)
            test::writeTiledExr(path, header, channels, 16, 16);
        else
            test::writeScanlineExr(path, header, channels);
        const auto reader = openImage(path);
        EXPECT_EQ(reader->info().tiled, tiled);
        Image back(50, 90);
        for (int y = 0; y < 90;) {
            const int rows = std::min(1 + y % 23, 90 - y);
            reader->readRows(y, rows, back.row(y));
            y += rows;
        }
        EXPECT_EQ(back, image);
    }
}

TEST_F(ExrFormat, CopiesGrayToThreeChannels)
{
    for (const std::string name : {"Y", "R", "gray"}) {
        writeNamed({name});
        EXPECT_EQ(readImage(path).texels, (std::vector<float>{1, 1, 1, 2, 2, 2})) << name;
    }
    writeImage(path, Image(2, 1, 1, 0.5f));
    EXPECT_EQ(readImage(path), Image(2, 1, 3, 0.5f));
    EXPECT_EQ(openImage(path)->info().channels, 1);
}

TEST_F(ExrFormat, DropsAlphaAndOtherChannels)
{
    writeNamed({"A", "B", "G", "R", "Z"});
    EXPECT_EQ(readImage(path).texels, (std::vector<float>{4, 3, 2, 8, 6, 4}));
    EXPECT_EQ(openImage(path)->info().channels, 5);
}

TEST_F(ExrFormat, TakesAMissingColorForBlack)
{
    writeNamed({"R", "G"});
    EXPECT_EQ(readImage(path).texels, (std::vector<float>{1, 2, 0, 2, 4, 0}));
}

TEST_F(ExrFormat, PrefersPlainColorThenBlendersCombinedPassThenTheFirstLayer)
{
    writeNamed({"AO.R", "AO.G", "AO.B", "R", "G", "B"});
    EXPECT_EQ(readImage(path).texel(0, 0)[0], 4.0f);
    writeNamed({"Layer.AO.R", "Layer.AO.G", "Layer.AO.B", "Layer.Combined.R", "Layer.Combined.G", "Layer.Combined.B"});
    EXPECT_EQ(readImage(path).texel(0, 0)[0], 4.0f);
    writeNamed({"left.Z", "left.R", "left.G", "left.B", "right.R", "right.G", "right.B"});
    EXPECT_EQ(readImage(path).texel(0, 0)[0], 2.0f);
}

TEST_F(ExrFormat, ReadsWholeNumbersAsTheyAre)
{
    writeNamed({"R", "G", "B"}, Imf::UINT);
    EXPECT_EQ(readImage(path).texels, (std::vector<float>{1, 2, 3, 2, 4, 6}));
    EXPECT_EQ(openImage(path)->info().sampleType, "uint");
}

TEST_F(ExrFormat, RefusesAFileWithoutColor)
{
    writeNamed({"N.X", "N.Z"});
    EXPECT_THAT(readError(), HasSubstr("R, G, B or Y"));
}

TEST_F(ExrFormat, ReadsTheDataWindowOnRequestAndTellsItsOffset)
{
    const Image image = test::smallIntegerImage(20, 40);
    const auto channels = test::exrChannels(image);
    for (const bool tiled : {false, true}) {
        Imf::Header header = test::exrHeader(20, 40, channels, Imf::FLOAT);
        header.displayWindow() = Imath::Box2i({-100, 0}, {99, 99});
        header.dataWindow() = Imath::Box2i({-7, -3}, {12, 36});
        if (tiled)
            test::writeTiledExr(path, header, channels, 8, 8);
        else
            test::writeScanlineExr(path, header, channels);
        EXPECT_EQ(readImage(path, {.window = PictureWindow::Data}, Channels::Color), image);
        const ImageFileInfo info = openImage(path)->info();
        EXPECT_EQ(info.offsetX, 93);
        EXPECT_EQ(info.offsetY, -3);
    }
}

TEST_F(ExrFormat, ReadsRowsStoredFromTheBottom)
{
    const Image image = test::smallIntegerImage(33, 50);
    const auto channels = test::exrChannels(image);
    Imf::Header header = test::exrHeader(33, 50, channels, Imf::FLOAT);
    header.lineOrder() = Imf::DECREASING_Y;
    test::writeScanlineExr(path, header, channels);
    EXPECT_EQ(readImage(path), image);
    test::writeTiledExr(path, header, channels, 16, 16);
    EXPECT_EQ(readImage(path), image);
}

TEST_F(ExrFormat, ReadsTheFirstPartThatHoldsColor)
{
    const std::vector<ExrChannel> normals{{"N.X", {9, 9}}, {"N.Y", {9, 9}}, {"N.Z", {9, 9}}};
    const std::vector<ExrChannel> color{{"R", {1, 2}}, {"G", {3, 4}}, {"B", {5, 6}}};
    std::vector<Imf::Header> headers{test::exrHeader(2, 1, {normals[0], normals[2]}, Imf::FLOAT), test::exrHeader(2, 1, color, Imf::FLOAT)};
    for (size_t i = 0; i < headers.size(); ++i) {
        headers[i].setName("part" + std::to_string(i));
        headers[i].setType(Imf::SCANLINEIMAGE);
    }
    {
        std::vector<std::vector<char>> storage;
        Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
        Imf::OutputPart first(file, 0);
        first.setFrameBuffer(test::exrFrameBuffer(headers[0], {normals[0], normals[2]}, storage));
        first.writePixels(1);
        Imf::OutputPart second(file, 1);
        second.setFrameBuffer(test::exrFrameBuffer(headers[1], color, storage));
        second.writePixels(1);
    }
    EXPECT_EQ(readImage(path).texels, (std::vector<float>{1, 3, 5, 2, 4, 6}));
    EXPECT_EQ(openImage(path)->info().parts, 2);
}

TEST_F(ExrFormat, RefusesDeepImages)
{
    {
        Imf::Header header(2, 1);
        header.channels().insert("R", Imf::Channel(Imf::FLOAT));
        header.setType(Imf::DEEPSCANLINE);
        header.compression() = Imf::ZIPS_COMPRESSION;
        float sample = 1.0f;
        std::vector<unsigned> counts{1, 1};
        std::vector<float*> samples{&sample, &sample};
        Imf::DeepFrameBuffer buffer;
        buffer.insertSampleCountSlice(
            Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), sizeof(unsigned), 2 * sizeof(unsigned)));
        buffer.insert(
            "R", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), sizeof(float*), 2 * sizeof(float*), sizeof(float)));
        Imf::DeepScanLineOutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    EXPECT_THAT(readError(), HasSubstr("flatten"));
}

TEST_F(ExrFormat, RefusesSubsampledColor)
{
    std::vector<float> samples(8, 1.0f);
    {
        Imf::Header header(4, 2);
        Imf::FrameBuffer buffer;
        for (const char* name : {"R", "G", "B"}) {
            const int sampling = *name == 'B' ? 2 : 1;
            header.channels().insert(name, Imf::Channel(Imf::FLOAT, sampling, sampling));
            buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), 4, 16, sampling, sampling));
        }
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(2);
    }
    EXPECT_THAT(readError(), HasSubstr("channel B is subsampled"));
}

TEST_F(ExrFormat, ConvertsOtherPrimariesAndKeepsWhite)
{
    const std::vector<ExrChannel> channels{{"R", {1, 0}}, {"G", {1, 1}}, {"B", {1, 0}}};
    Imf::Header header = test::exrHeader(2, 1, channels, Imf::FLOAT);
    // ACES AP0: a white that is not D65, a green outside all that is visible.
    Imf::addChromaticities(header, Imf::Chromaticities({0.7347f, 0.2653f}, {0.0f, 1.0f}, {0.0001f, -0.077f}, {0.32168f, 0.33767f}));
    test::writeScanlineExr(path, header, channels);
    const Image image = readImage(path);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image.texel(0, 0)[c], 1.0f, 1e-5f);
    EXPECT_LT(image.texel(1, 0)[0], 0.0f);
    EXPECT_GT(image.texel(1, 0)[1], 1.0f);
}

TEST_F(ExrFormat, RefusesPrimariesThatSpanNothing)
{
    const std::vector<ExrChannel> channels{{"R", {1}}, {"G", {1}}, {"B", {1}}};
    Imf::Header header = test::exrHeader(1, 1, channels, Imf::FLOAT);
    Imf::addChromaticities(header, Imf::Chromaticities({0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}));
    test::writeScanlineExr(path, header, channels);
    EXPECT_THAT(readError(), HasSubstr("chromaticities"));
}

TEST_F(ExrFormat, ReadsLuminanceAndChroma)
{
    constexpr int width = 40;
    constexpr int height = 30;
    const Imf::Rgba color(0.75f, 0.5f, 0.25f, 1.0f);
    {
        const std::vector<Imf::Rgba> texels(width * height, color);
        Imf::RgbaOutputFile file(path.c_str(), width, height, Imf::WRITE_YC);
        file.setFrameBuffer(texels.data(), 1, width);
        file.writePixels(height);
    }
    const Image image = readImage(path);
    for (int i = 0; i < width * height; ++i) {
        // Y, RY and BY are rounded to half (11 bits), so the sums are off by a few of its steps.
        EXPECT_NEAR(image.texels[static_cast<size_t>(3 * i)], 0.75f, 0.004f);
        EXPECT_NEAR(image.texels[static_cast<size_t>(3 * i + 1)], 0.5f, 0.004f);
        EXPECT_NEAR(image.texels[static_cast<size_t>(3 * i + 2)], 0.25f, 0.004f);
    }
}

TEST_F(ExrFormat, GivesARealLuminanceChromaPictureItsStoredLuminance)
{
    SHARED_DATA_OR_SKIP(picture, "edgecases/Rec709_YC.exr");
    const Image image = readImage(picture);
    std::vector<float> luminance(static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
    Imf::InputFile file(picture.c_str());
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, luminance.data(), file.header().dataWindow()));
    file.setFrameBuffer(buffer);
    file.readPixels(file.header().dataWindow().min.y, file.header().dataWindow().max.y);
    size_t off = 0;
    for (size_t i = 0; i < luminance.size(); ++i) {
        const float y = 0.2126f * image.texels[3 * i] + 0.7152f * image.texels[3 * i + 1] + 0.0722f * image.texels[3 * i + 2];
        off += std::abs(y - luminance[i]) > 0.003f + 0.003f * luminance[i] ? 1 : 0;
    }
    EXPECT_EQ(off, 0u); // three halves are rounded on the way
}

TEST_F(ExrFormat, KeepsTheAttributesOfMirrorballAndNoOthers)
{
    writeImage(path, Image(2, 1, 3, 1.0f), {.attributes = {{"mirrorball:parameterization", "cube"}, {"owner", "someone"}}});
    EXPECT_EQ(openImage(path)->info().attributes, (std::map<std::string, std::string>{{"mirrorball:parameterization", "cube"}}));
}

TEST_F(ExrFormat, KeepsTheEnvmapAttribute)
{
    for (const std::string kind : {"latlong", "cube"}) {
        writeImage(path, Image(2, 1, 3, 1.0f), {.attributes = {{"envmap", kind}}});
        EXPECT_EQ(openImage(path)->info().envmap, kind);
    }
    writeImage(path, Image(2, 1, 3, 1.0f));
    EXPECT_EQ(openImage(path)->info().envmap, "");
}

TEST_F(ExrFormat, TellsTheEnvironmentMapsOfOpenExrApart)
{
    SHARED_DATA_OR_SKIP(cube, "probes/openexr/KernerEnvCube.exr");
    const ImageFileInfo info = openImage(cube)->info();
    EXPECT_EQ(info.envmap, "cube");
    EXPECT_EQ(info.levels, 11);
    EXPECT_TRUE(info.tiled);
    EXPECT_EQ(openImage(test::sharedDataFolder() / "probes/openexr/KernerEnvLatLong.exr")->info().envmap, "latlong");
}

TEST_F(ExrFormat, GivesBackEveryMipLevel)
{
    const std::vector<Image> levels{test::wildImage(100, 600, 1), test::wildImage(50, 300, 2), test::wildImage(25, 150, 3)};
    writeMips(path, levels);
    for (int level = 0; level < 3; ++level)
        EXPECT_EQ(readLevel(path, level), levels[static_cast<size_t>(level)]);
    EXPECT_EQ(readImage(path), levels[0]);
    const ImageFileInfo info = openImage(path)->info();
    EXPECT_TRUE(info.tiled);
    EXPECT_EQ(info.levels, 10); // 600 = 2^9.2
    EXPECT_EQ(readLevel(path, 9).width * readLevel(path, 9).height, 1);
    EXPECT_THROW(readLevel(path, 10), FileError);
    EXPECT_THROW(readLevel(path, -1), FileError);
}

TEST_F(ExrFormat, FillsTheMissingMipLevelsWithBoxAverages)
{
    Image image(4, 2);
    for (size_t i = 0; i < image.texels.size(); ++i)
        image.texels[i] = static_cast<float>(i / 3); // 0 1 2 3 above 4 5 6 7
    writeMips(path, {image});
    EXPECT_EQ(readLevel(path, 1), ([] {
                  Image half(2, 1);
                  half.texels = {2.5f, 2.5f, 2.5f, 4.5f, 4.5f, 4.5f};
                  return half;
              }()));
    EXPECT_EQ(readLevel(path, 2), Image(1, 1, 3, 3.5f));
}

TEST_F(ExrFormat, AveragesOddSizesOverTheirWholeArea)
{
    Image image(3, 1);
    image.texels = {1, 1, 1, 2, 2, 2, 6, 6, 6};
    writeMips(path, {image}, {.sampleType = SampleType::Half});
    EXPECT_EQ(readLevel(path, 1), Image(1, 1, 3, 3.0f));
}

} // namespace
} // namespace mirrorball
