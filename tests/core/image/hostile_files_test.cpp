#include "core/base/error.h"
#include "core/image/image_io.h"
#include "support/exr_builders.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <ImfRgbaFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/// Whatever the bytes, reading ends in an image or in a FileError of one line: no crash, no other exception, no runaway memory.
namespace mirrorball {
namespace {

using testing::HasSubstr;

/// The error of reading a file, empty when it was read. Checks that it is fit to be shown.
std::string readError(const std::filesystem::path& path)
{
    try {
        const int levels = openImage(path)->info().levels;
        readImage(path);
        readLevel(path, levels - 1);
        return {};
    } catch (const FileError& e) {
        const std::string text = e.what();
        EXPECT_THAT(text, HasSubstr(path.string()));
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_NE(text.find(';'), std::string::npos) << "no remedy: " << text;
        return text;
    } catch (const std::exception& e) {
        ADD_FAILURE() << "not a FileError: " << e.what();
        return e.what();
    }
}

long peakKilobytes()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

class HostileFiles : public testing::Test {
protected:
    std::string errorOf(const std::string& bytes, const std::string& name = "picture.exr")
    {
        test::writeBytes(folder / name, bytes);
        return readError(folder / name);
    }
    std::string valid(const std::string& name, const WriteOptions& options = {})
    {
        writeImage(folder / name, test::smallIntegerImage(17, 9), options);
        return test::readBytes(folder / name);
    }

    test::TemporaryFolder folder;
};

TEST_F(HostileFiles, NamesWhatIsNotAFile)
{
    EXPECT_THAT(readError(folder / "missing.exr"), HasSubstr("no such file"));
    EXPECT_THAT(readError(folder.path()), HasSubstr("folder"));
    EXPECT_THAT(errorOf(""), HasSubstr("empty"));
    ASSERT_EQ(::mkfifo((folder / "pipe.hdr").c_str(), 0600), 0);
    EXPECT_THAT(readError(folder / "pipe.hdr"), HasSubstr("not a regular file"));
    EXPECT_THAT(readError("/dev/zero"), HasSubstr("not a regular file"));
    std::filesystem::create_symlink("nowhere", folder / "dangling.exr");
    EXPECT_THAT(readError(folder / "dangling.exr"), HasSubstr("no such file"));
}

TEST_F(HostileFiles, SaysThatAFileMayNotBeRead)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "the superuser may read everything";
    valid("a.exr");
    std::filesystem::permissions(folder / "a.exr", std::filesystem::perms::none);
    EXPECT_THAT(readError(folder / "a.exr"), HasSubstr("permissions"));
}

TEST_F(HostileFiles, RefusesGarbageUnderAnyName)
{
    std::mt19937 random(7);
    std::string garbage(4000, '\0');
    for (char& c : garbage)
        c = static_cast<char>(random());
    garbage[0] = 'x'; // no signature by chance
    for (const std::string name : {"a.exr", "a.hdr", "a", "a.xyz", "a.png", "a.jpg", "a.tif"})
        EXPECT_NE(errorOf(garbage, name), "") << name;
    EXPECT_NE(errorOf("just a line of text\n", "a.txt"), "");
}

TEST_F(HostileFiles, QuotesNoControlCharactersFromAFile)
{
    const std::string text = errorOf(std::string("#?RADIANCE\nFORMAT=odd\0\x1b[31m\x07\n\n-Y 1 +X 1\n....", 44));
    EXPECT_THAT(text, HasSubstr("\"odd??[31m?\""));
}

TEST_F(HostileFiles, QuotesOnlyValidUtf8FromAFile)
{
    const std::string text = errorOf(std::string("#?RADIANCE\nFORMAT=\xc3\xbc\xff\x80z\xe2\x82\n\n-Y 1 +X 1\n...."));
    EXPECT_THAT(text, HasSubstr("\"\xc3\xbc??z??\""));
}

TEST_F(HostileFiles, RefusesTheDamagedFilesOfOpenExr)
{
    for (const std::string name : {"damaged_1.exr", "damaged_2.exr", "damaged_3.exr"}) {
        SHARED_DATA_OR_SKIP(path, "edgecases/" + name);
        EXPECT_NE(readError(path), "") << name;
    }
}

TEST_F(HostileFiles, RefusesSizesBeyondTheLimitWithoutTakingMemory)
{
    const long before = peakKilobytes();
    const std::string header = "#?RADIANCE\n\n";
    EXPECT_THAT(errorOf(header + "-Y 32769 +X 32768\n" + std::string(5000, '\x02')), HasSubstr("2^30"));
    EXPECT_THAT(errorOf(header + "-Y 99999999999999999999 +X 99999999999999999999\n"), HasSubstr("2^30"));
    EXPECT_THAT(errorOf(header + "-Y 0 +X 5\n"), HasSubstr("damaged"));
    EXPECT_THAT(errorOf(header + "-Y -5 +X 5\n"), HasSubstr("damaged"));
    EXPECT_THAT(errorOf(header + "-Y 8192 +X 16384\n" + std::string(5000, '\x02')), HasSubstr("too short"));
    // Long enough for rows of old runs, but the data ends in the first of them: no more memory than those few rows.
    EXPECT_NE(errorOf(header + "-Y 8192 +X 16384\n" + std::string(200000, '\x02')), "");
    EXPECT_NE(errorOf(header + "+X 8192 -Y 16384\n" + std::string(200000, '\x02')), "");

    std::string exr = valid("a.exr");
    const size_t window = exr.find("dataWindow") + sizeof("dataWindow") + sizeof("box2i") + 4;
    const auto patched = [&](std::int32_t width, std::int32_t height) {
        const std::int32_t box[4] = {0, 0, width - 1, height - 1};
        std::string bytes = exr;
        return bytes.replace(window, sizeof box, reinterpret_cast<const char*>(box), sizeof box);
    };
    EXPECT_EQ(errorOf(patched(17, 9)), "");
    EXPECT_NE(errorOf(patched(16384, 16384)), "");
    EXPECT_NE(errorOf(patched(1 << 30, 1 << 30)), "");
    EXPECT_NE(errorOf(patched(1 << 28, 9)), "");
    EXPECT_NE(errorOf(patched(17, 1 << 29)), "");
    EXPECT_NE(errorOf(patched(-5, -5)), "");
    EXPECT_LT(peakKilobytes() - before, 300 * 1024);
}

// OpenEXR fills the memory of a text with zeros before it reads it: 1.7 GB here, and two seconds of them.
TEST_F(HostileFiles, RefusesATextThatIsLongerThanItsFile)
{
    std::string exr = valid("a.exr", {.attributes = {{"mirrorball:note", "a text"}}});
    const std::string type("string\0", 7);
    const size_t size = exr.find(type, exr.find("mirrorball:note")) + type.size();
    ASSERT_EQ(exr.substr(size, 4), std::string("\6\0\0\0", 4));
    // OpenEXR does not look at the size of a list of channels: a wrong one hides nothing that stands behind.
    const std::string list("channels\0chlist\0", 16);
    std::string hidden = exr;
    hidden[hidden.find(list) + list.size()] = 19;
    EXPECT_EQ(errorOf(exr), "");
    EXPECT_EQ(errorOf(hidden), "");
    // Nor does the size of a list of texts tell that of each.
    std::string texts = exr;
    texts.insert(size + 10, std::string("a\0stringvector\0\10\0\0\0\0\0\0\x66"
                                        "text",
                                        27));
    const long before = peakKilobytes();
    EXPECT_THAT(errorOf(texts), HasSubstr("its attribute a claims 1711276032 bytes"));
    for (std::string* bytes : {&exr, &hidden}) {
        (*bytes)[size + 3] = '\x66';
        EXPECT_THAT(errorOf(*bytes), HasSubstr("its attribute mirrorball:note claims 1711276038 bytes"));
    }
    EXPECT_LT(peakKilobytes() - before, 300 * 1024);
}

TEST_F(HostileFiles, RefusesTilesThatWouldFillTheMemory)
{
    const Image image = test::smallIntegerImage(17, 9);
    const auto channels = test::exrChannels(image);
    test::writeTiledExr(folder / "a.exr", test::exrHeader(17, 9, channels, Imf::FLOAT), channels, 16, 16);
    std::string exr = test::readBytes(folder / "a.exr");
    const size_t tiles = exr.find("tiledesc", exr.find("tiledesc") + 0) + sizeof("tiledesc") + 4;
    const std::uint32_t size[2] = {60000, 60000};
    exr.replace(tiles, sizeof size, reinterpret_cast<const char*>(size), sizeof size);
    const long before = peakKilobytes();
    EXPECT_NE(errorOf(exr), "");
    EXPECT_LT(peakKilobytes() - before, 300 * 1024);
}

/// A small valid file of each kind that is worth damaging.
std::vector<std::pair<std::string, std::string>> specimens(const test::TemporaryFolder& folder)
{
    std::vector<std::pair<std::string, std::string>> files;
    const auto keep = [&](const std::string& name) { files.emplace_back(name, test::readBytes(folder / name)); };
    Image image = test::smallIntegerImage(37, 21);
    for (int y = 5; y < 12; ++y) // something for every compressor to find
        std::fill_n(image.texel(3, y), 3 * 30, 0.5f);
    writeImage(folder / "runs.hdr", image);
    keep("runs.hdr");
    writeImage(folder / "flat.hdr", test::smallIntegerImage(7, 9));
    keep("flat.hdr");
    test::writeBytes(folder / "columns.hdr", "#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_xyze\n\n+X 3 +Y 2\n" + std::string(24, '\x83'));
    keep("columns.hdr");
    const auto channels = test::exrChannels(image);
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
            const Imf::Header header = test::exrHeader(37, 21, channels, type, static_cast<Imf::Compression>(compression));
            const std::string name = "kind" + std::to_string(compression) + (type == Imf::HALF ? "half" : "float");
            test::writeScanlineExr(folder / (name + "_lines.exr"), header, channels);
            keep(name + "_lines.exr");
            test::writeTiledExr(folder / (name + "_tiles.exr"), header, channels, 16, 8);
            keep(name + "_tiles.exr");
        }
    writeMips(folder / "mips.exr", {image}, {.sampleType = SampleType::Half});
    keep("mips.exr");
    {
        const std::vector<Imf::Rgba> texels(20 * 12, Imf::Rgba(0.75f, 0.5f, 0.25f));
        Imf::RgbaOutputFile file((folder / "chroma.exr").c_str(), 20, 12, Imf::WRITE_YC);
        file.setFrameBuffer(texels.data(), 1, 20);
        file.writePixels(12);
    }
    keep("chroma.exr");
    return files;
}

TEST_F(HostileFiles, SurvivesTruncationAtEveryLength)
{
    for (const auto& [name, bytes] : specimens(folder)) {
        // Every length of the header, where decisions are made, and some hundred beyond.
        const size_t step = std::max<size_t>(1, bytes.size() / 150);
        for (size_t length = 0; length < bytes.size(); length += length < 420 ? 7 : step)
            EXPECT_NE(errorOf(bytes.substr(0, length), name), "") << name << " cut to " << length << " of " << bytes.size();
        if (testing::Test::HasFailure())
            return;
    }
}

TEST_F(HostileFiles, SurvivesDamageAnywhere)
{
    std::mt19937 random(20240229);
    size_t read = 0;
    size_t refused = 0;
    for (const auto& [name, bytes] : specimens(folder))
        for (int trial = 0; trial < 120; ++trial) {
            std::string damaged = bytes;
            // Half of the cases hit the header and the offsets behind it, half anything.
            const size_t reach = trial % 2 == 0 ? std::min<size_t>(bytes.size(), 500) : bytes.size();
            for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
                damaged[random() % reach] = static_cast<char>(random() % 3 == 0 ? 0xff : random());
            ++(errorOf(damaged, name).empty() ? read : refused);
            if (testing::Test::HasFailure())
                FAIL() << name << ", trial " << trial;
        }
    EXPECT_GT(read, 500u); // damage to mantissas and to names that nobody asks for is no error
    EXPECT_GT(refused, 500u);
}

TEST_F(HostileFiles, SurvivesDamageInOtherFormats)
{
    std::mt19937 random(5);
    for (const std::string name : {"a.png", "a.tif", "a.jpg"}) {
        const std::string bytes = valid(name);
        for (size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 60)
            errorOf(bytes.substr(0, length), name);
        for (int trial = 0; trial < 100; ++trial) {
            std::string damaged = bytes;
            damaged[random() % bytes.size()] = static_cast<char>(random());
            errorOf(damaged, name);
        }
    }
}

} // namespace
} // namespace mirrorball
