#include "core/image/image_io.h"
#include "support/exr_builders.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>

#include <algorithm>

/// OpenImageIO as an independent reader, linked here and nowhere else: it costs each start of this program a third of a second.
namespace mirrorball {
namespace {

/// The first three channels of one level, as OpenImageIO sees them.
Image readIndependently(const std::filesystem::path& path, int level = 0)
{
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) {
        ADD_FAILURE() << OIIO::geterror();
        return {};
    }
    const OIIO::ImageSpec spec = input->spec(0, level);
    const int channels = std::min(3, spec.nchannels);
    Image image(spec.width, spec.height, channels);
    EXPECT_TRUE(input->read_image(0, level, 0, channels, OIIO::TypeFloat, image.texels.data())) << input->geterror();
    return image;
}

std::vector<std::filesystem::path> sharedFiles(const std::string& extension)
{
    std::vector<std::filesystem::path> paths;
    if (std::filesystem::is_directory(test::sharedDataFolder()))
        for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sharedDataFolder()))
            if (entry.path().extension() == extension)
                paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// Bit for bit, so that NaN equals NaN.
bool sameBits(const Image& a, const Image& b)
{
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

TEST(OpenImageIoAgreement, RadiancePicturesDecodeBitForBitTheSame)
{
    const auto paths = sharedFiles(".hdr");
    if (paths.empty())
        GTEST_SKIP() << "needs shared/data beside this checkout";
    for (const auto& path : paths)
        EXPECT_TRUE(sameBits(readImage(path), readIndependently(path))) << path;
}

TEST(OpenImageIoAgreement, OpenExrFilesDecodeBitForBitTheSameInEveryLevel)
{
    int compared = 0;
    for (const auto& path : sharedFiles(".exr")) {
        const std::string name = path.filename().string();
        if (name.starts_with("damaged") || name == "Rec709_YC.exr")
            continue; // OpenImageIO reads neither
        for (int level = 0; level < openImage(path)->info().levels; ++level, ++compared)
            EXPECT_TRUE(sameBits(readLevel(path, level), readIndependently(path, level))) << path << " level " << level;
    }
    if (compared == 0)
        GTEST_SKIP() << "needs shared/data beside this checkout";
}

TEST(OpenImageIoAgreement, WhatWeWriteReadsTheSameElsewhere)
{
    const test::TemporaryFolder folder;
    const Image exact = test::smallIntegerImage(75, 50); // held exactly by half and RGBE
    for (const std::string extension : {".exr", ".hdr", ".tif"}) {
        writeImage(folder / ("a" + extension), exact);
        EXPECT_TRUE(sameBits(readIndependently(folder / ("a" + extension)), exact)) << extension;
    }
    const Image wild = test::wildImage(75, 50);
    for (const std::string extension : {".exr", ".tif"}) {
        writeImage(folder / ("w" + extension), wild);
        EXPECT_TRUE(sameBits(readIndependently(folder / ("w" + extension)), wild)) << extension;
        writeImage(folder / ("h" + extension), exact, {.sampleType = SampleType::Half});
        EXPECT_TRUE(sameBits(readIndependently(folder / ("h" + extension)), exact)) << extension;
    }
}

TEST(OpenImageIoAgreement, MipChainsReadTheSameElsewhere)
{
    const test::TemporaryFolder folder;
    const std::vector<Image> levels{test::wildImage(70, 140, 1), test::wildImage(35, 70, 2), test::wildImage(17, 35, 3)};
    for (const std::string name : {"a.exr", "a.tif"}) {
        writeMips(folder / name, levels);
        for (int level = 0; level < 3; ++level)
            EXPECT_TRUE(sameBits(readIndependently(folder / name, level), levels[static_cast<size_t>(level)]))
                << name << " level " << level;
        const auto input = OIIO::ImageInput::open((folder / name).string());
        EXPECT_TRUE(input->seek_subimage(0, 7)) << name; // 140, 70, 35, 17, 8, 4, 2, 1
        EXPECT_EQ(input->spec().width, 1);
        EXPECT_EQ(input->spec().height, 1);
        EXPECT_FALSE(input->seek_subimage(0, 8)) << name;
        EXPECT_EQ(input->spec(0, 0).tile_width, 64) << name;
    }
}

TEST(OpenImageIoAgreement, AttributesAreSeenElsewhere)
{
    const test::TemporaryFolder folder;
    writeImage(folder / "a.exr", Image(4, 2, 3, 1.0f), {.attributes = {{"mirrorball:lobe", "phong 50"}, {"envmap", "latlong"}}});
    const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
    EXPECT_EQ(input->spec().get_string_attribute("mirrorball:lobe"), "phong 50");
    EXPECT_EQ(input->spec().get_string_attribute("textureformat"), "LatLong Environment");
}

} // namespace
} // namespace mirrorball
