#include "core/base/error.h"
#include "core/image/container/babylon_env.h"
#include "core/image/container/byte_source.h"
#include "core/image/container/container_file.h"
#include "core/image/container/dds.h"
#include "core/image/container/ktx1.h"
#include "core/image/container/ktx2.h"
#include "core/image/container/packed_texel.h"
#include "core/image/container/play_canvas_atlas.h"
#include "core/image/container/png_codec.h"
#include "core/image/container/zstd_codec.h"
#include "core/image/probe_file.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <random>

#include <zlib.h>

namespace mirrorball {
namespace {

using testing::HasSubstr;

std::uint32_t u32(const std::string& bytes, size_t at) { return littleAt<std::uint32_t>(bytes, at); }

/// Every texel tells its level, picture and place; values are halves.
Texture numbered(int width, int height, int faces, int slices, int levels, TexelFormat format)
{
    Texture texture;
    texture.faces = faces;
    texture.slices = slices;
    texture.format = format;
    for (int level = 0; level < levels; ++level) {
        Image image(std::max(1, width >> level), texture.pictures() * std::max(1, height >> level));
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const glm::vec3 rgb(0.25f * static_cast<float>(x % 8), 0.25f * static_cast<float>(y % 8), 0.5f + static_cast<float>(level));
                std::copy_n(&rgb.x, 3, image.texel(x, y));
            }
        texture.levels.push_back(std::move(image));
    }
    return texture;
}

Texture cube(TexelFormat format) { return numbered(8, 8, 6, 1, 4, format); }

babylon_env::Environment smallEnvironment()
{
    babylon_env::Environment environment;
    environment.levels = cube(TexelFormat::Half).levels;
    environment.irradiance.emplace();
    for (size_t i = 0; i < 9; ++i)
        (*environment.irradiance)[i] = glm::dvec3(0.1, 0.2, 0.3) + static_cast<double>(i);
    return environment;
}

// The header that Filament's WebAssembly loads, and the one of the specification, which it aborts on.
TEST(Ktx1, HeaderOfFilamentsLightIsByteForByteTheOneItsReaderTakes)
{
    Texture texture = numbered(256, 256, 6, 1, 5, TexelFormat::R11G11B10);
    texture.metadata["sh"] = std::string(200, '1');
    const std::string bytes = ktx1::write(texture, ktx1::SmallFloatType::Filament);
    EXPECT_EQ(bytes.substr(0, 12), "\xABKTX 11\xBB\r\n\x1A\n");
    const std::vector<std::uint32_t> expected{0x04030201, 0x8c3a, 4, 0x1907, 0x8c3a, 0x1907, 256, 256, 0, 0, 6, 5};
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(u32(bytes, 12 + 4 * i), expected[i]) << "word " << i;
    const size_t metadata = u32(bytes, 60);
    EXPECT_EQ(u32(bytes, 64), 3 + 201u);
    EXPECT_EQ(bytes.substr(68, 3), std::string("sh\0", 3));
    EXPECT_EQ(metadata % 4, 0u);
    EXPECT_EQ(bytes.size() - 64 - metadata, 4u * 6 * (256 * 256 + 128 * 128 + 64 * 64 + 32 * 32 + 16 * 16) + 5 * 4);
    EXPECT_EQ(u32(bytes, 64 + metadata), 256u * 256 * 4) << "imageSize counts one face of a cube";
    EXPECT_EQ(u32(ktx1::write(texture), 16), 0x8c3bu) << "the specification's glType";
}

TEST(Ktx1, BothKindsOfSmallFloatsAreRead)
{
    const Texture texture = cube(TexelFormat::R11G11B10);
    for (const auto type : {ktx1::SmallFloatType::Khronos, ktx1::SmallFloatType::Filament})
        EXPECT_EQ(ktx1::read(ktx1::write(texture, type), "x.ktx").levels, texture.levels);
}

// PlayCanvas compares pixel format flags and caps2 exactly, Babylon.js reads fourCC 113.
TEST(Dds, HeaderOfACubeIsTheOneThatBabylonAndPlayCanvasTake)
{
    const std::string bytes = dds::write(cube(TexelFormat::Half));
    EXPECT_EQ(bytes.substr(0, 4), "DDS ");
    EXPECT_EQ(u32(bytes, 4), 124u);
    EXPECT_EQ(u32(bytes, 8), 0x2100fu);
    EXPECT_EQ(u32(bytes, 28), 4u) << "levels";
    EXPECT_EQ(u32(bytes, 76), 32u);
    EXPECT_EQ(u32(bytes, 80), 4u);
    EXPECT_EQ(u32(bytes, 84), 113u);
    EXPECT_EQ(u32(bytes, 108), 0x401008u);
    EXPECT_EQ(u32(bytes, 112), 0xfe00u);
    EXPECT_EQ(bytes.size(), 128u + 6 * 8 * (64 + 16 + 4 + 1));
    // Face-major: behind the first face's 85 texels stands the second face's first one, which is texel (0, 8) of the stack.
    EXPECT_EQ(littleAt<std::uint16_t>(bytes, 128 + 8 * 85 + 2), packHalf(0.0f));
    EXPECT_EQ(littleAt<std::uint16_t>(bytes, 128 + 8 * 64 + 4), packHalf(1.5f)) << "its own level 1 follows level 0";
}

TEST(Dds, Dx10HeaderNamesFormatAndArray)
{
    const std::string bytes = dds::write(numbered(16, 16, 1, 2, 5, TexelFormat::Half), dds::Header::Dx10);
    EXPECT_EQ(bytes.substr(84, 4), "DX10");
    EXPECT_EQ(u32(bytes, 112), 0u) << "no cube";
    const std::vector<std::uint32_t> expected{10, 3, 0, 2, 0};
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(u32(bytes, 128 + 4 * i), expected[i]);
    EXPECT_EQ(u32(dds::write(cube(TexelFormat::Half), dds::Header::Dx10), 136), 4u) << "misc flag of a cube";
    EXPECT_THROW(dds::write(cube(TexelFormat::R11G11B10)), InvalidArgument) << "Direct3D 9 has no number for it";
}

TEST(Ktx2, LevelsAreStoredSmallestFirstAndIndexedLargestFirst)
{
    const std::string bytes = ktx2::write(cube(TexelFormat::Half));
    EXPECT_EQ(bytes.substr(0, 12), "\xABKTX 20\xBB\r\n\x1A\n");
    EXPECT_EQ(u32(bytes, 12), 97u) << "VK_FORMAT_R16G16B16A16_SFLOAT";
    EXPECT_EQ(u32(bytes, 16), 2u);
    EXPECT_EQ(u32(bytes, 36), 6u);
    EXPECT_EQ(u32(bytes, 40), 4u);
    std::uint64_t previous = bytes.size();
    for (size_t level = 0; level < 4; ++level) {
        const auto offset = littleAt<std::uint64_t>(bytes, 80 + 24 * level), length = littleAt<std::uint64_t>(bytes, 88 + 24 * level);
        EXPECT_EQ(length, 6u * 8 * (8u >> level) * (8u >> level));
        EXPECT_EQ(offset + length, previous) << "level " << level;
        EXPECT_EQ(offset % 8, 0u);
        previous = offset;
    }
    EXPECT_THAT(bytes, HasSubstr(std::string("KTXorientation\0rd\0", 18)));
}

TEST(Ktx2, DescriptorOfSharedExponentsNamesTheExponentOnceAChannel)
{
    const std::string bytes = ktx2::write(cube(TexelFormat::E5B9G9R9));
    const size_t at = u32(bytes, 48);
    EXPECT_EQ(u32(bytes, at), u32(bytes, 52));
    EXPECT_EQ(u32(bytes, at), 4u + 24 + 6 * 16);
    EXPECT_EQ(u32(bytes, at + 28 + 16), 27u | 4u << 16 | 0x20u << 24) << "bits 27-31, exponent of red";
}

struct Format {
    const char* name;
    std::string (*write)(const Texture&);
    Texture (*read)(std::string_view, const std::string&);
};

class Containers : public testing::TestWithParam<Format> {};

TEST_P(Containers, GiveBackWhatWasWritten)
{
    for (const TexelFormat format : allTexelFormats())
        for (const Texture& texture : {cube(format), numbered(12, 6, 1, 1, 3, format), numbered(8, 8, 1, 3, 2, format)}) {
            if (std::string(GetParam().name) == "ktx" && texture.slices > 1)
                continue; // arrays of KTX 1 are read, but nothing here asks for them
            const Texture back = GetParam().read(GetParam().write(texture), "x");
            EXPECT_EQ(back.faces, texture.faces);
            EXPECT_EQ(back.slices, texture.slices);
            EXPECT_EQ(back.levels, texture.levels) << traits(format).name;
        }
}

TEST_P(Containers, RefuseACutOrAlteredFileInOneLine)
{
    const std::string bytes = GetParam().write(cube(TexelFormat::Half));
    std::mt19937 generator(5);
    for (int i = 0; i < 200; ++i) {
        const std::string cut = bytes.substr(0, 12 + generator() % (bytes.size() - 12));
        try {
            GetParam().read(cut, "cut");
            FAIL() << "a file cut to " << cut.size() << " bytes was read";
        } catch (const FileError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
    for (int i = 0; i < 4000; ++i) { // lying headers: whatever comes of it, it is a texture or a FileError
        std::string altered = bytes;
        for (int k = 0; k < 3; ++k)
            altered[12 + generator() % 260] = static_cast<char>(generator());
        try {
            const Texture texture = GetParam().read(altered, "altered");
            EXPECT_LE(texture.levels.front().texels.size() * 4, 4 * 4 * altered.size());
        } catch (const FileError&) {
        }
    }
}

const Format ktx{"ktx", [](const Texture& t) { return ktx1::write(t); }, ktx1::read};
const Format plainKtx2{"ktx2", [](const Texture& t) { return ktx2::write(t); }, ktx2::read};
const Format compressedKtx2{"ktx2_zstd", [](const Texture& t) { return ktx2::write(t, ktx2::Compression::Zstandard); }, ktx2::read};
const Format dx10{"dds", [](const Texture& t) { return dds::write(t, dds::Header::Dx10); }, dds::read};
std::string nameOf(const testing::TestParamInfo<Format>& tested) { return tested.param.name; }
INSTANTIATE_TEST_SUITE_P(Formats, Containers, testing::Values(ktx, plainKtx2, compressedKtx2, dx10), nameOf);

TEST(Ktx2, ACompressedLevelLongerThanItsSizeIsDamage)
{
    Texture small = cube(TexelFormat::Half), large = numbered(64, 64, 6, 1, 1, TexelFormat::Half);
    small.levels.resize(1);
    std::string bytes = ktx2::write(large, ktx2::Compression::Zstandard);
    bytes[20] = 8, bytes[24] = 8; // width and height lie
    EXPECT_THROW(ktx2::read(bytes, "lie.ktx2"), FileError);
}

/// A .ktx2 file of one texel, eight bytes, whose level is this frame.
std::string ktx2Of(const std::string& frame)
{
    Texture texel = numbered(1, 1, 1, 1, 1, TexelFormat::Half);
    std::string bytes = ktx2::write(texel, ktx2::Compression::Zstandard);
    std::string length;
    appendLittle(length, std::uint64_t{frame.size()});
    bytes.replace(88, 8, length); // of the only level, which ends the file
    return bytes.substr(0, littleAt<std::uint64_t>(bytes, 80)) + frame;
}

std::string errorOfKtx2(const std::string& bytes)
{
    try {
        ktx2::read(bytes, "bad.ktx2");
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
    return {};
}

TEST(Ktx2, AFrameOfMoreThanItsLevelIsGivenUpAtOnce)
{
    // RFC 8878: a header without a size, then 2^13 blocks that repeat one byte 2^17 times.
    std::string frame("\x28\xb5\x2f\xfd\x00\x38", 6);
    for (int i = 0; i < 1 << 13; ++i)
        frame += std::string(i + 1 < 1 << 13 ? "\x02\x00\x10" : "\x03\x00\x10", 3) + '\0';
    EXPECT_THAT(errorOfKtx2(ktx2Of(frame)), HasSubstr("longer than its size asks for"));
    const std::string whole = ktx2Of(zstd::packed(std::string(8, 'x')));
    EXPECT_EQ(errorOfKtx2(whole), "");
    for (size_t cut = 1; cut < zstd::packed(std::string(8, 'x')).size(); ++cut)
        EXPECT_NE(errorOfKtx2(ktx2Of(zstd::packed(std::string(8, 'x')).substr(0, cut))), "") << cut;
    EXPECT_THAT(errorOfKtx2(ktx2Of(zstd::packed(std::string(7, 'x')))), HasSubstr("shorter than its size asks for"));
    // One that claims a window, and so memory, of 2^30 bytes.
    EXPECT_THAT(errorOfKtx2(ktx2Of(std::string("\x28\xb5\x2f\xfd\x00\xa0\x03\x00\x10\x00", 10))), HasSubstr("cannot be decompressed"));
}

TEST(Ktx2, FramesLargerThanAPieceComeThroughWhole)
{
    Texture texture; // noise, which does not compress: 18 MiB of it, and half of that
    std::mt19937 generator(3);
    for (const int size : {768, 384}) {
        Image image(size, 6 * size);
        for (float& value : image.texels)
            value = static_cast<float>(generator() % 65536);
        texture.levels.push_back(std::move(image));
    }
    texture.format = TexelFormat::Float;
    EXPECT_EQ(ktx2::read(ktx2::write(texture, ktx2::Compression::Zstandard), "x.ktx2").levels, texture.levels);
}

TEST(BabylonEnv, ManifestSaysWhereEveryFaceOfEveryLevelLies)
{
    const std::string bytes = babylon_env::write(smallEnvironment());
    EXPECT_EQ(bytes.substr(0, 8), "\x86\x16\x87\x96\xF6\xD6\x96\x36");
    const size_t end = bytes.find('\0', 8);
    const std::string manifest = bytes.substr(8, end - 8);
    EXPECT_THAT(manifest, HasSubstr("\"imageType\":\"image/png\""));
    EXPECT_THAT(manifest, HasSubstr("\"lodGenerationScale\":0.8"));
    EXPECT_THAT(manifest, HasSubstr("\"width\":8"));
    EXPECT_EQ(bytes.substr(end + 1, 8), "\x89PNG\r\n\x1A\n") << "positions count from behind the NUL";
}

TEST(BabylonEnv, GivesBackItsLevelsAndPolynomial)
{
    const babylon_env::Environment written = smallEnvironment();
    const babylon_env::Environment back = babylon_env::read(babylon_env::write(written), "x.env");
    ASSERT_EQ(back.levels.size(), written.levels.size());
    for (size_t level = 0; level < back.levels.size(); ++level)
        for (size_t i = 0; i < back.levels[level].texels.size(); ++i)
            EXPECT_NEAR(back.levels[level].texels[i], written.levels[level].texels[i], 0.012 * 3.5) << "RGBD's step at the brightest";
    for (size_t i = 0; i < 9; ++i)
        EXPECT_EQ((*back.irradiance)[i], (*written.irradiance)[i]);
}

TEST(BabylonEnv, RefusesSizesThatBabylonThrowsOn)
{
    babylon_env::Environment odd = smallEnvironment(), unfinished = smallEnvironment();
    odd.levels = numbered(12, 12, 6, 1, 4, TexelFormat::Half).levels;
    unfinished.levels.pop_back();
    EXPECT_THROW(babylon_env::write(odd), InvalidArgument);
    EXPECT_THROW(babylon_env::write(unfinished), InvalidArgument);
}

TEST(BabylonEnv, RefusesACutOrAlteredFileInOneLine)
{
    const std::string bytes = babylon_env::write(smallEnvironment());
    std::mt19937 generator(6);
    for (int i = 0; i < 200; ++i)
        EXPECT_THROW(babylon_env::read(bytes.substr(0, 8 + generator() % (bytes.size() - 8)), "cut"), FileError);
    for (int i = 0; i < 2000; ++i) {
        std::string altered = bytes;
        for (int k = 0; k < 3; ++k)
            altered[8 + generator() % (bytes.size() - 8)] = static_cast<char>(generator());
        try {
            babylon_env::read(altered, "altered");
        } catch (const FileError&) {
        }
    }
}

// Its pictures may lie beyond what a file of this length can tell of, and still be more than is held of any other.
TEST(BabylonEnv, RefusesMoreTexelsThanAreHeldOfAnyPicture)
{
    std::string bytes = babylon_env::write(smallEnvironment());
    const size_t at = bytes.find("\"width\":");
    ASSERT_NE(at, std::string::npos);
    const size_t number = at + 8, end = bytes.find_first_of(",}", number);
    bytes.replace(number, end - number, "8192");
    bytes.append(size_t{2} << 20, '\0');
    try {
        babylon_env::read(bytes, "large.env");
        ADD_FAILURE() << "6 x 8192 x 8192 texels were accepted";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("at most 2^28 are read"));
    }
}

// 200 of them, a megabyte and a half, are 1.6 GB; unpacking those twice, as libpng does, takes longer than the helper may.
TEST(PngCodec, TextsBesideAPictureAreNotUnpacked)
{
    const std::string packed = [] {
        const std::string text(7'900'000, 'x');
        std::string bytes("Comment\0\0", 9);
        uLongf size = ::compressBound(text.size());
        bytes.resize(9 + size);
        ::compress2(reinterpret_cast<Bytef*>(bytes.data()) + 9, &size, reinterpret_cast<const Bytef*>(text.data()), text.size(), 9);
        bytes.resize(9 + size);
        return bytes;
    }();
    const auto big = [](std::uint64_t number) {
        return std::string{static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
                           static_cast<char>(number)};
    };
    const std::string named = "zTXt" + packed;
    const std::string chunk =
        big(packed.size()) + named + big(::crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size())));
    const png::Picture picture{1, 1, {Rgba8{1, 2, 3, 4}}};
    std::string bytes = png::encode(picture);
    constexpr size_t header = 8 + 25;
    for (int i = 0; i < 200; ++i)
        bytes.insert(header, chunk);
    EXPECT_EQ(png::decode(bytes, "texts.png", 1).texels, picture.texels);
}

TEST(PlayCanvasAtlas, ItsRectanglesDoNotOverlapAndItsTexelsAreTheLatlongsWithABorder)
{
    using namespace play_canvas_atlas;
    std::vector<int> covered(size * size, 0);
    for (const Rectangle& r : rectangles) {
        for (int y = 0; y < r.height; ++y)
            for (int x = 0; x < r.width; ++x)
                ++covered[static_cast<size_t>((r.y + y) * size + r.x + x)];
        const glm::dvec3 left = direction(r, 0, r.height / 2), wrapped = direction(r, r.width - 2, r.height / 2);
        EXPECT_NEAR(glm::distance(left, wrapped), 0.0, 1e-12) << "the border column shows what lies beyond the seam";
        EXPECT_EQ(direction(r, 3, 0), direction(r, 3, 1)) << "and the border row the row before it";
    }
    EXPECT_LE(*std::max_element(covered.begin(), covered.end()), 1);
    EXPECT_NEAR(direction({0, 0, 512, 256}, 128, 127).x, 1.0, 1e-3) << "the left quarter is +X, the middle row the horizon";
}

TEST(PlayCanvasAtlas, GivesBackItsRadiance)
{
    Image atlas(play_canvas_atlas::size, play_canvas_atlas::size, 3, 0.5f);
    atlas.texel(7, 9)[1] = 40.0f;
    for (const PackedColor form : {PackedColor::Rgbp, PackedColor::Rgbm}) {
        const Image back = play_canvas_atlas::read(play_canvas_atlas::write(atlas, form), "x.png", form);
        EXPECT_NEAR(back.texel(7, 9)[1], 40.0f, 0.5f);
        EXPECT_NEAR(back.texel(300, 300)[2], 0.5f, 0.01f);
    }
}

TEST(ContainerFiles, AreProbesLikeAnyOther)
{
    const test::TemporaryFolder folder;
    const Texture texture = cube(TexelFormat::Half);
    std::ofstream(folder / "map.ktx2", std::ios::binary) << ktx2::write(texture);
    const Probe probe = readProbe((folder / "map.ktx2").string());
    EXPECT_EQ(probe.map.layout, (MapLayout{Parameterization::Cube, 8, 0}));
    EXPECT_EQ(probe.map.image, texture.levels.front());
    EXPECT_EQ(readLevel(folder / "map.ktx2", 2), texture.levels[2]);
    EXPECT_EQ(openImage(folder / "map.ktx2")->info().levels, 4);
}

// Whatever its length, a file with holes takes no place on the disk.
TEST(ContainerFiles, OneThatIsLongerThanAnyTextureIsRefusedBeforeItIsRead)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "long.ktx";
    std::ofstream(path, std::ios::binary) << ktx1::write(cube(TexelFormat::Half));
    std::error_code error;
    std::filesystem::resize_file(path, std::uintmax_t{1} << 40, error);
    if (error)
        GTEST_SKIP() << "no file of that length can be made here: " << error.message();
    EXPECT_THROW(readContainer(path), FileError);
}

// Direct3D's chains end at one texel; a header may claim any number of levels, and OpenImageIO finds as many as there are bytes for.
TEST(ContainerFiles, ACompressedTextureHasNoMoreLevelsThanHalvings)
{
    const test::TemporaryFolder folder;
    std::string bytes = dds::write(numbered(4, 4, 1, 1, 3, TexelFormat::Half)).substr(0, 128);
    bytes.replace(28, 1, 1, '\x1f'); // levels
    bytes.replace(84, 4, "DXT1");
    bytes += std::string(4096, '\0');
    std::ofstream(folder / "many.dds", std::ios::binary) << bytes;
    EXPECT_EQ(readContainer(folder / "many.dds").texture.levels.size(), 3u);
}

} // namespace
} // namespace mirrorball
