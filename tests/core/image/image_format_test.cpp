#include "core/image/image_format.h"

#include "core/base/error.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace mirrorball {
namespace {

using testing::HasSubstr;

std::filesystem::path fileOf(const test::TemporaryFolder& folder, const ImageFormat& format, std::string_view extension)
{
    return folder / (std::string(format.label) + std::string(extension));
}

TEST(ImageFormats, EachExtensionBelongsToOneFormatInLowerCase)
{
    std::set<std::string_view> extensions;
    for (const ImageFormat& format : imageFormats()) {
        ASSERT_FALSE(format.extensions.empty()) << format.label;
        for (const std::string_view extension : format.extensions) {
            EXPECT_TRUE(extensions.insert(extension).second) << extension;
            EXPECT_EQ(findFormat("a" + std::string(extension)), &format) << extension;
        }
    }
    EXPECT_EQ(findFormat("A.EXR"), findFormat("a.exr"));
    EXPECT_EQ(findFormat("a.foo"), nullptr);
    EXPECT_EQ(findFormat("exr"), nullptr);
}

TEST(ImageFormats, WhatARowClaimsIsInTheFile)
{
    const test::TemporaryFolder folder;
    Image rgba(8, 4, 4, 0.25f);
    const WriteOptions half{.sampleType = SampleType::Half, .attributes = {{"mirrorball:index", "normal"}}};
    for (const ImageFormat& format : imageFormats())
        for (const std::string_view extension : format.extensions) {
            if (!format.write)
                continue;
            const std::filesystem::path file = fileOf(folder, format, extension);
            writeImage(file, rgba, half);
            const ImageFileInfo info = openImage(file)->info();
            const bool isTexture = format.faces; // its texels are RGBA for the graphics card's sake; opacity is not kept
            EXPECT_EQ(info.channels == 4, format.alpha || isTexture) << file;
            EXPECT_EQ(info.attributes.count("mirrorball:index") == 1, format.attributes) << file;
            EXPECT_EQ(info.sampleType, isTexture ? "rgba16f" : sampleWord(format, SampleType::Half)) << file;
            writeImage(file, rgba);
            EXPECT_EQ(openImage(file)->info().sampleType, isTexture ? "rgba32f" : sampleWord(format, SampleType::Float)) << file;
        }
}

TEST(ImageFormats, WithoutAnAlphaChannelShowWhatIsTransparentOverBlack)
{
    const test::TemporaryFolder folder;
    Image rgba(8, 4, 4, 0.25f); // white, a quarter opaque: colors come multiplied
    for (const ImageFormat& format : imageFormats()) {
        if (!format.write || format.alpha)
            continue;
        const std::filesystem::path file = fileOf(folder, format, format.extensions.front());
        writeImage(file, rgba);
        const Image read = readImage(file);
        writeImage(file, Image(8, 4, 3, 0.25f));
        EXPECT_EQ(read, readImage(file)) << file;
    }
}

TEST(ImageFormats, KeepLevelsWhereTheRowSaysSo)
{
    const test::TemporaryFolder folder;
    const std::vector<Image> levels{Image(8, 8), Image(4, 4), Image(2, 2), Image(1, 1)};
    for (const ImageFormat& format : imageFormats()) {
        const std::filesystem::path file = fileOf(folder, format, format.extensions.front());
        EXPECT_EQ(holdsMips(file), format.write && format.levels);
        if (holdsMips(file)) {
            writeMips(file, levels);
            EXPECT_EQ(openImage(file)->info().levels, 4) << file;
        } else {
            EXPECT_THROW(writeMips(file, levels), InvalidArgument) << file;
        }
    }
}

TEST(ImageFormats, ADisplayPictureGoesOnlyIntoFormatsThatShowOne)
{
    const test::TemporaryFolder folder;
    for (const ImageFormat& format : imageFormats()) {
        const std::filesystem::path file = fileOf(folder, format, format.extensions.front());
        if (format.write && format.samples == StoredSamples::Byte)
            EXPECT_NO_THROW(writeImage(file, Image(2, 2), {.encoding = Encoding::Display})) << file;
        else
            EXPECT_THROW(writeImage(file, Image(2, 2), {.encoding = Encoding::Display}), InvalidArgument) << file;
    }
}

TEST(ImageFormats, CountTheBytesOfATexelBeforeCompression)
{
    EXPECT_EQ(texelBytes(writableFormat("a.exr"), SampleType::Float), 12);
    EXPECT_EQ(texelBytes(writableFormat("a.exr"), SampleType::Half, 4), 8);
    EXPECT_EQ(texelBytes(writableFormat("a.pic"), SampleType::Half), 4);
    EXPECT_EQ(texelBytes(writableFormat("a.png"), SampleType::Half), 3);
}

TEST(ImageFormats, ANameThatCannotBeWrittenIsRefusedWithWhatCan)
{
    const auto message = [](const std::filesystem::path& path) {
        try {
            writableFormat(path);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_THAT(message("a.foo"), HasSubstr("a.foo: no image can be written with the extension \".foo\"; use .exr, .hdr, .tif or .png"));
    EXPECT_THAT(message("a"), HasSubstr("has no extension"));
    EXPECT_FALSE(isWritable("a.pfm"));
    EXPECT_THROW(passFormat("a.png"), InvalidArgument);
}

} // namespace
} // namespace mirrorball
