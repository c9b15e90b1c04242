#include "core/base/error.h"
#include "core/image/color.h"
#include "core/image/image_format.h"
#include "support/exr_builders.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>

#include <sys/resource.h>
#include <unistd.h>

namespace mirrorball {
namespace {

using testing::HasSubstr;

const std::vector<std::string> writtenFormats = [] {
    std::vector<std::string> extensions;
    for (const ImageFormat& format : imageFormats())
        if (format.write)
            extensions.emplace_back(format.extensions.front());
    return extensions;
}();

size_t filesIn(const std::filesystem::path& folder)
{
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

template <class Failure, class Action>
std::string message(const Action& action)
{
    try {
        action();
    } catch (const Failure& e) {
        return e.what();
    } catch (const std::exception& e) {
        return std::string("another kind of error: ") + e.what();
    }
    return "no error";
}

class ImageIo : public testing::Test {
protected:
    test::TemporaryFolder folder;
};

TEST_F(ImageIo, GivesBackTiffFloatsBitForBit)
{
    const Image image = test::wildImage(90, 61);
    writeImage(folder / "a.tif", image);
    EXPECT_EQ(readImage(folder / "a.tif"), image);
    EXPECT_EQ(openImage(folder / "a.tif")->info().sampleType, "float");
    EXPECT_EQ(openImage(folder / "a.tif")->info().format, "tiff");
}

TEST_F(ImageIo, GivesBackTiffHalvesExactly)
{
    Image image = test::smallIntegerImage(90, 61);
    image.texel(0, 0)[0] = 1e9f;
    writeImage(folder / "a.tif", image, {.sampleType = SampleType::Half});
    image.texel(0, 0)[0] = 65504.0f;
    EXPECT_EQ(readImage(folder / "a.tif"), image);
    EXPECT_EQ(openImage(folder / "a.tif")->info().sampleType, "half");
}

TEST_F(ImageIo, GivesBackEveryTiffMipLevel)
{
    const std::vector<Image> levels{test::wildImage(100, 80, 1), test::wildImage(50, 40, 2)};
    writeMips(folder / "a.tif", levels);
    EXPECT_EQ(openImage(folder / "a.tif")->info().levels, 7);
    EXPECT_EQ(readLevel(folder / "a.tif", 0), levels[0]);
    EXPECT_EQ(readLevel(folder / "a.tif", 1), levels[1]);
    EXPECT_EQ(readLevel(folder / "a.tif", 6).texels.size(), 3u);
    EXPECT_THROW(readLevel(folder / "a.tif", 7), FileError);
}

TEST_F(ImageIo, WritesPngAsTheDisplayShowsIt)
{
    const Image image = test::smallIntegerImage(40, 30);
    writeImage(folder / "a.png", image);
    const Image shown = toDisplay(image, 0.0, ToneCurve::Filmic);
    const Image back = readImage(folder / "a.png");
    for (size_t i = 0; i < shown.texels.size(); ++i) // half of one of 255 steps
        ASSERT_NEAR(encodeSrgb(back.texels[i]), shown.texels[i], 0.5f / 255.0f + 1e-5f);
    EXPECT_EQ(openImage(folder / "a.png")->info().sampleType, "uint8");
}

TEST_F(ImageIo, LinearizesAn8BitPicture)
{
    SHARED_DATA_OR_SKIP(png, "matcaps/jade_srgb8.png");
    const Image image = readImage(png);
    // The largest weighted sum of its encoded values is 0.83904, computed once with another program from the bytes as they are.
    for (size_t i = 0; i < image.texels.size(); ++i)
        ASSERT_TRUE(image.texels[i] >= 0.0f && image.texels[i] <= 1.0f);
    float brightest = 0.0f;
    for (size_t i = 0; i < image.texels.size(); i += 3)
        brightest = std::max(brightest, 0.2126f * encodeSrgb(image.texels[i]) + 0.7152f * encodeSrgb(image.texels[i + 1]) +
                                            0.0722f * encodeSrgb(image.texels[i + 2]));
    EXPECT_NEAR(brightest, 0.83904f, 1e-5f);
}

TEST_F(ImageIo, CopiesGrayAndDropsAlphaInAllFormats)
{
    for (const std::string extension : {".exr", ".tif"}) {
        writeImage(folder / ("gray" + extension), Image(4, 3, 1, 0.5f));
        EXPECT_EQ(readImage(folder / ("gray" + extension)), Image(4, 3, 3, 0.5f)) << extension;
        Image rgba(4, 3, 4, 1.0f);
        rgba.texel(1, 1)[2] = 0.25f;
        Image rgb(4, 3, 3, 1.0f);
        rgb.texel(1, 1)[2] = 0.25f;
        writeImage(folder / ("alpha" + extension), rgba);
        EXPECT_EQ(readImage(folder / ("alpha" + extension)), rgb) << extension;
        EXPECT_EQ(openImage(folder / ("alpha" + extension))->info().channels, 4) << extension;
    }
}

TEST_F(ImageIo, KeepsAttributesWhereTheFormatHoldsStrings)
{
    const std::map<std::string, std::string> attributes{{"mirrorball:lobe", "phong 50"}, {"mirrorball:parameterization", "cube"}};
    for (const std::string extension : {".exr", ".tif", ".png"}) {
        writeImage(folder / ("a" + extension), Image(8, 8, 3, 0.5f), {.attributes = attributes});
        EXPECT_EQ(openImage(folder / ("a" + extension))->info().attributes, attributes) << extension;
    }
}

TEST_F(ImageIo, WritesTheSameBytesForTheSameImage)
{
    const Image image = test::smallIntegerImage(64, 48);
    for (const std::string& extension : writtenFormats)
        writeImage(folder / ("a" + extension), image);
    // Sizes that no tile divides: what lies beyond the picture must not be whatever was in memory.
    for (const std::string extension : {".exr", ".tif"})
        writeMips(folder / ("mips a" + extension), {image}, {.sampleType = SampleType::Half});
    ::usleep(1100000); // a time stamp would have changed by now
    for (const std::string& extension : writtenFormats) {
        writeImage(folder / ("b" + extension), image);
        EXPECT_TRUE(test::readBytes(folder / ("a" + extension)) == test::readBytes(folder / ("b" + extension))) << extension;
    }
    for (const std::string extension : {".exr", ".tif"}) {
        writeMips(folder / ("mips b" + extension), {image}, {.sampleType = SampleType::Half});
        EXPECT_TRUE(test::readBytes(folder / ("mips a" + extension)) == test::readBytes(folder / ("mips b" + extension))) << extension;
    }
}

TEST_F(ImageIo, TellsTheFormatByContentNotByName)
{
    const Image image = test::smallIntegerImage(20, 10);
    for (const std::string& extension : writtenFormats) {
        if (extension == ".tga")
            continue; // the one format without a signature
        const auto named = folder / ("a" + extension);
        writeImage(named, image);
        const Image expected = readImage(named);
        for (const std::string wrong : {"a.exr", "a.hdr", "a.png", "a.tif", "a", "a.txt"}) {
            const auto renamed = folder / ("renamed" + wrong);
            std::filesystem::copy_file(named, renamed, std::filesystem::copy_options::overwrite_existing);
            EXPECT_EQ(readImage(renamed), expected) << extension << " as " << wrong;
        }
    }
}

TEST_F(ImageIo, ReplacesAnExistingFileAndLeavesNothingElse)
{
    for (const std::string& extension : writtenFormats) {
        const auto path = folder / ("a" + extension);
        test::writeBytes(path, "old");
        std::filesystem::permissions(path, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
        writeImage(path, Image(4, 4, 3, 0.5f));
        EXPECT_EQ(readImage(path).width, 4);
        EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }
    EXPECT_EQ(filesIn(folder.path()), writtenFormats.size());
}

TEST_F(ImageIo, WritesThroughASymbolicLink)
{
    std::filesystem::create_symlink("real.exr", folder / "link.exr");
    writeImage(folder / "link.exr", Image(4, 4, 3, 0.5f));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.exr"));
    EXPECT_EQ(readImage(folder / "real.exr").width, 4);
}

TEST_F(ImageIo, RefusesExtensionsThatCannotBeWritten)
{
    for (const std::string name : {"a", "a.txt", "a.psd", "a.sgi"}) {
        EXPECT_THAT(message<InvalidArgument>([&] { writeImage(folder / name, Image(2, 2)); }), HasSubstr(name)) << name;
        EXPECT_EQ(filesIn(folder.path()), 0u);
    }
    EXPECT_THAT(message<InvalidArgument>([&] { writeImage(folder / "a.exr", Image{}); }), HasSubstr("0 x 0"));
}

TEST_F(ImageIo, FailsInOneLineWhereTheFolderIsMissingOrTheTargetIsAFolder)
{
    for (const std::string& extension : writtenFormats) {
        const std::string missing = message<WorkError>([&] { writeImage(folder / ("nowhere/a" + extension), Image(2, 2)); });
        EXPECT_THAT(missing, HasSubstr("create the folder")) << extension;
        EXPECT_EQ(missing.find('\n'), std::string::npos);
    }
    std::filesystem::create_directory(folder / "a.exr");
    EXPECT_THAT(message<WorkError>([&] { writeImage(folder / "a.exr", Image(2, 2)); }), HasSubstr("is a folder"));
    EXPECT_THAT(message<WorkError>([&] { writeImage("/dev/full/a.exr", Image(2, 2)); }), HasSubstr("cannot be written"));
}

/// No file of this process may grow beyond `bytes` while this lives: what a full disk does, for one process.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limited{bytes, m_before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    rlimit m_before{};
};

TEST_F(ImageIo, LeavesTheOldFileAndNoRestsWhenTheDiskIsFull)
{
    const Image image = test::wildImage(300, 300);
    for (const std::string& extension : writtenFormats) {
        const auto path = folder / ("a" + extension);
        writeImage(path, image);
        const std::string whole = test::readBytes(path);
        // From nothing at all to all but the last byte: the error comes at the first write or only at the very end.
        for (const size_t limit : {size_t{0}, size_t{100}, whole.size() / 2, whole.size() - 1}) {
            test::writeBytes(path, "old");
            const std::string error = [&] {
                const FileSizeLimit limited(limit);
                return message<WorkError>([&] { writeImage(path, image); });
            }();
            EXPECT_THAT(error, HasSubstr("cannot be written: File too large")) << extension << " at " << limit;
            EXPECT_THAT(error, HasSubstr(path.string())) << extension << " at " << limit;
            EXPECT_EQ(test::readBytes(path), "old") << extension << " at " << limit;
            EXPECT_EQ(filesIn(folder.path()), 1u) << extension << " at " << limit;
        }
        std::filesystem::remove(path);
    }
}

TEST_F(ImageIo, LeavesNothingWhenAMipChainFails)
{
    for (const std::string name : {"a.exr", "a.tif"}) {
        writeMips(folder / name, {test::wildImage(200, 200)});
        const size_t whole = std::filesystem::file_size(folder / name);
        std::filesystem::remove(folder / name);
        for (const size_t limit : {size_t{0}, whole / 2, whole - 1}) {
            const std::string error = [&] {
                const FileSizeLimit limited(limit);
                return message<WorkError>([&] { writeMips(folder / name, {test::wildImage(200, 200)}); });
            }();
            EXPECT_THAT(error, HasSubstr("cannot be written")) << name << " at " << limit;
            EXPECT_EQ(filesIn(folder.path()), 0u) << name << " at " << limit;
        }
    }
}

TEST_F(ImageIo, RefusesMipChainsThatNoFormatHolds)
{
    EXPECT_TRUE(holdsMips("a.EXR"));
    EXPECT_TRUE(holdsMips("a.tif"));
    EXPECT_FALSE(holdsMips("a.hdr"));
    EXPECT_FALSE(holdsMips("a.png"));
    const Image image(8, 8);
    EXPECT_THROW(writeMips(folder / "a.hdr", {image}), InvalidArgument);
    EXPECT_THROW(writeMips(folder / "a.exr", {}), InvalidArgument);
    EXPECT_THROW(writeMips(folder / "a.exr", {image, Image(4, 3)}), InvalidArgument);
    EXPECT_THROW(writeMips(folder / "a.exr", {Image(1, 1), Image(1, 1)}), InvalidArgument);
    EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST_F(ImageIo, TakesAStackedCubesChainDownToOneTexel)
{
    std::vector<Image> levels;
    for (int edge = 16; edge >= 1; edge /= 2)
        levels.emplace_back(edge, 6 * edge, 3, static_cast<float>(edge));
    for (const std::string name : {"a.exr", "a.tif"}) {
        writeMips(folder / name, levels);
        EXPECT_EQ(openImage(folder / name)->info().levels, 7) << name; // 96 = 2^6.6
        EXPECT_EQ(readLevel(folder / name, 4), levels[4]) << name;
        EXPECT_EQ(readLevel(folder / name, 6), Image(1, 1, 3, 1.0f)) << name;
    }
}

TEST_F(ImageIo, StopsBetweenBlocksAndReportsProgress)
{
    writeImage(folder / "a.exr", Image(2048, 2048, 3, 1.0f));
    std::vector<float> fractions;
    std::stop_source source;
    JobControl job;
    job.stop = source.get_token();
    job.progress = [&](float fraction) { fractions.push_back(fraction); };
    readImage(folder / "a.exr", job);
    EXPECT_GT(fractions.size(), 2u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0f);
    source.request_stop();
    EXPECT_THROW(readImage(folder / "a.exr", job), Cancelled);
}

} // namespace
} // namespace mirrorball
