/// Files as other programs write them, kind by kind. Each is made by the test, of the field of support/field.h, in the way of its kind.
///
/// | kind | test |
/// |---|---|
/// | depth, normals, albedo before the colors; parts, layers, channels; X Y Z; luminance alone | TakesTheColors..., NoVector... |
/// | crop, overscan, windows that do not meet | PlacesACrop..., CutsOverscan... |
/// | crosses and strips of a mirrored world, another face order | MirrorAndFaceOrder... (cube_sheet_test: turned faces, borders) |
/// | six files, two halves | ReadsSixFiles..., HalvesAreBlended... |
/// | Exif orientation 1 to 8 | SetsEveryOrientationUpright |
/// | gAMA 45455, 55556, 100000; sRGB; cHRM of P3 and Adobe RGB; cICP; ICC linear, 1.8, 2.2, beside and against others | DecodesWhat... |
/// | a color space that the user knows better | AColorSpaceThatIsAskedFor... |
/// | alpha of integer pictures, over it as opacity | ColorsAreAsDrawn..., OpacityMultiplies... |
/// | almost 2:1, partial panoramas, fisheyes, not square | AlmostTwoToOne..., PartialPanoramas..., AFisheye..., NotSquare... |
/// | a mirror ball in a photograph | FindsTheBall... |
/// | rows without a value, nothing finite | FillsRows..., RefusesAProbeWithoutAFiniteTexel (repair_test: streams) |
/// | careless .hdr headers | hdr_format_test |
/// | DDS and KTX | container_test |

#include "core/image/color.h"
#include "core/image/image_io.h"
#include "support/foreign_file.h"

#include <algorithm>

namespace mirrorball {
namespace {

using test::ExrChannel;
using test::latlong;
using testing::HasSubstr;

struct ForeignFiles : test::ForeignFile {};

TEST_F(ForeignFiles, TakesTheColorsAmongLayers)
{
    const std::vector<std::vector<ExrChannel>> beside[]{
        {constants({"N.X", "N.Y", "N.Z"}, -1.0f)},
        {constants({"Z", "A"}, 9.0f)},
        {constants({"albedo.R", "albedo.G", "albedo.B"}, 0.1f), constants({"normal.R", "normal.G", "normal.B"}, -1.0f)},
        {constants({"P.X", "P.Y", "P.Z"}, 5.0f), constants({"depth.Y"}, 7.0f)},
        {constants({"X", "Y", "Z"}, 5.0f)}};
    for (const std::string layer : {"", "beauty.", "rgba.", "ViewLayer.Combined.", "Image."})
        for (const auto& others : beside) {
            auto layers = others;
            layers.push_back(colors(layer));
            write(layers);
            const Probe probe = read();
            EXPECT_LT(distance(probe), 1e-6) << layer << others[0][0].name;
            EXPECT_EQ(assumed(probe, "layer").value, layer.empty() ? "default" : layer.substr(0, layer.size() - 1));
        }
}

TEST_F(ForeignFiles, TakesTheColorsAmongParts)
{
    for (const std::string name : {"rgba", "beauty", "anything"}) {
        writeParts({{"depth", constants({"Z"}, 12.5f)}, {"albedo", constants({"R", "G", "B"}, 0.1f)}, {name, colors()}});
        const Probe probe = read();
        EXPECT_LT(distance(probe), 1e-6) << name;
        EXPECT_EQ(assumed(probe, "part").value, "2 (" + name + ")");
        EXPECT_THAT(assumed(probe, "part").others, testing::Contains("1 (albedo)"));
    }
    for (const std::string part : {"1", "albedo"})
        EXPECT_EQ(read({.part = part}).map.image.texel(3, 3)[0], 0.1f);
    EXPECT_EQ(read({.part = "depth"}).map.image.texel(3, 3)[0], 12.5f) << "asked for, it is taken whatever it is";
    EXPECT_EQ(read({.layer = "albedo"}).map.image.texel(3, 3)[0], 0.1f) << "in files of many parts a layer is a part";
    EXPECT_THAT([&] { read({.part = "3"}); }, testing::Throws<FileError>(testing::Property(&std::exception::what, HasSubstr("albedo"))));
    EXPECT_THAT([&] { read({.layer = "gone"}); }, testing::Throws<FileError>(testing::Property(&std::exception::what, HasSubstr("gone"))));
}

TEST_F(ForeignFiles, NoVectorOrDepthIsAColorUnlessAskedFor)
{
    for (const auto& names : std::vector<std::vector<std::string>>{{"N.X", "N.Y", "N.Z"}, {"X", "Y", "Z"}, {"Z"}, {"depth"}, {"A"}}) {
        write({constants(names, -1.0f)});
        EXPECT_THROW(read(), FileError) << names[0];
    }
    write({constants({"N.X", "N.Y", "N.Z"}, -1.0f)});
    EXPECT_EQ(read({.layer = "N"}).map.image.texel(0, 0)[1], -1.0f);
}

TEST_F(ForeignFiles, TwoPicturesOfTheSameStandingAreAGuess)
{
    write({colors("one."), constants({"two.R", "two.G", "two.B"}, 1.0f)});
    EXPECT_FALSE(read().certain);
    EXPECT_LT(distance(read({.layer = "one"})), 1e-6);
    EXPECT_TRUE(read({.layer = "one"}).certain);
}

TEST_F(ForeignFiles, PlacesACropInItsDisplayWindow)
{
    for (const bool tiled : {false, true}) {
        Image crop(20, 10, 3);
        for (int y = 0; y < 10; ++y)
            std::copy_n(field.texel(16, 8 + y), 60, crop.row(y));
        const auto channels = test::exrChannels(crop);
        Imf::Header header = test::exrHeader(20, 10, channels, Imf::FLOAT);
        header.displayWindow() = Imath::Box2i({-5, 3}, {58, 34}); // 64 x 32
        header.dataWindow() = Imath::Box2i({11, 11}, {30, 20});
        if (tiled)
            test::writeTiledExr(path, header, channels, 8, 8);
        else
            test::writeScanlineExr(path, header, channels);
        const Probe probe = read();
        ASSERT_EQ(probe.map.layout, latlong);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                for (int c = 0; c < 3; ++c)
                    EXPECT_EQ(probe.map.image.texel(x, y)[c], x >= 16 && x < 36 && y >= 8 && y < 18 ? field.texel(x, y)[c] : 0.0f);
        ASSERT_EQ(probe.notes.size(), 1u);
        EXPECT_THAT(probe.notes[0], HasSubstr("1848 of 2048")); // 64 * 32 - 20 * 10
        EXPECT_EQ(read({.window = PictureWindow::Data}).map.layout.size, 10);
    }
}

TEST_F(ForeignFiles, CutsOverscanAndSaysWhereWindowsDoNotMeet)
{
    Image wide(72, 40, 3, 9.0f);
    for (int y = 0; y < 32; ++y)
        std::copy_n(field.row(y), 64 * 3, wide.texel(4, 4 + y));
    const auto channels = test::exrChannels(wide);
    Imf::Header header = test::exrHeader(72, 40, channels, Imf::FLOAT);
    header.displayWindow() = Imath::Box2i({0, 0}, {63, 31});
    header.dataWindow() = Imath::Box2i({-4, -4}, {67, 35});
    test::writeScanlineExr(path, header, channels);
    EXPECT_LT(distance(read()), 1e-6);
    header.dataWindow() = Imath::Box2i({100, 0}, {171, 39});
    test::writeScanlineExr(path, header, channels);
    EXPECT_THAT([&] { read(); }, testing::Throws<FileError>(testing::Property(&std::exception::what, HasSubstr("--window data"))));
    header.displayWindow() = Imath::Box2i({0, 0}, {16383, 16383}); // asks for 3 GB
    test::writeScanlineExr(path, header, channels);
    EXPECT_THROW(read(), FileError);
}

TEST_F(ForeignFiles, SetsEveryOrientationUpright)
{
    // Asymmetric in both axes. What Exif's number says of the stored picture's first row and column.
    Image upright(16, 8, 3);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                upright.texel(x, y)[c] = y < 4 && x < 4 ? 1.0f : y < 4 ? 0.6f : x < 4 ? 0.3f : 0.1f;
    const auto storedAs = [&](int orientation) {
        const bool turned = orientation >= 5;
        Image stored(turned ? 8 : 16, turned ? 16 : 8, 3);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 16; ++x) {
                // The visual position of stored row r and column c: 1 top left, 2 top right, 3 bottom right, 4 bottom left, 5 left top, ...
                const bool fromRight = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
                const bool fromBottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
                const int across = fromRight ? 15 - x : x, down = fromBottom ? 7 - y : y;
                std::copy_n(upright.texel(x, y), 3, turned ? stored.texel(down, across) : stored.texel(across, down));
            }
        return stored;
    };
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const auto jpeg = folder / "o.jpg";
        writeImage(jpeg, toDisplay(storedAs(orientation), 0.0, ToneCurve::None), {.encoding = Encoding::Display});
        std::string bytes = test::readBytes(jpeg);
        const std::string tiff =
            std::string("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 19) + static_cast<char>(orientation) + std::string(6, '\0');
        const std::string exif = "Exif" + std::string(2, '\0') + tiff;
        bytes.insert(2, "\xff\xe1" + test::bigEndian(static_cast<std::uint32_t>(exif.size() + 2), 2) + exif);
        test::writeBytes(jpeg, bytes);
        const Image back = readImage(jpeg);
        ASSERT_EQ(back.width, 16) << orientation;
        for (const auto& [x, y] : {std::pair(1, 1), {12, 1}, {1, 6}, {12, 6}})
            EXPECT_NEAR(back.texel(x, y)[1], upright.texel(x, y)[1], 0.05) << orientation;
    }
}

/// The field as a file stores it: light^(1/exponent), in other primaries where a matrix is given.
Image stored(const Image& light, double exponent, const glm::dmat3& fromRec709 = glm::dmat3(1.0))
{
    Image image = light;
    for (size_t i = 0; i < image.texels.size(); i += 3) {
        const glm::dvec3 v = fromRec709 * glm::dvec3(image.texels[i], image.texels[i + 1], image.texels[i + 2]);
        for (int c = 0; c < 3; ++c)
            image.texels[i + static_cast<size_t>(c)] = static_cast<float>(std::pow(std::clamp(v[c], 0.0, 1.0), 1.0 / exponent));
    }
    return image;
}

TEST_F(ForeignFiles, DecodesWhatAPngSaysOfItsColors)
{
    path = folder / "file.png";
    const Chromaticities p3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
    const Chromaticities adobe{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, {0.3127, 0.3290}};
    const glm::dmat3 none(1.0), toP3 = glm::inverse(toRec709(p3)), toAdobe = glm::inverse(toRec709(adobe));
    const std::string p3Chunk = test::chromaticityChunk({0.3127, 0.3290, 0.680, 0.320, 0.265, 0.690, 0.150, 0.060});
    const std::string adobeChunk = test::chromaticityChunk({0.3127, 0.3290, 0.64, 0.33, 0.21, 0.71, 0.15, 0.06});
    const std::string srgb = test::pngChunk("sRGB", std::string(1, '\0'));
    struct Case {
        const char* what;
        std::string chunks;
        double exponent;
        glm::dmat3 matrix;
    };
    const std::vector<Case> cases{
        {"gAMA 45455", test::gammaChunk(1 / 2.2), 2.2, none},
        {"gAMA 55556", test::gammaChunk(1 / 1.8), 1.8, none},
        {"gAMA 100000", test::gammaChunk(1.0), 1.0, none},
        {"P3 primaries", test::gammaChunk(1 / 2.2) + p3Chunk, 2.2, toP3},
        {"Adobe RGB", test::gammaChunk(256.0 / 563.0) + adobeChunk, 563.0 / 256.0, toAdobe},
        {"ICC linear", test::iccChunk(test::iccProfile(1.0)), 1.0, none},
        {"ICC gamma 1.8", test::iccChunk(test::iccProfile(1.8)), 1.8, none},
        {"ICC wins over gAMA", test::iccChunk(test::iccProfile(1.0)) + test::gammaChunk(1 / 2.2), 1.0, none},
        {"a damaged ICC profile is left out", test::iccChunk("no profile at all") + test::gammaChunk(1 / 1.8), 1.8, none},
        {"cICP of linear P3", test::pngChunk("cICP", std::string("\x0c\x08\0\x01", 4)), 1.0, toP3}};
    for (const Case& c : cases)
        for (const int bits : {8, 16}) {
            test::writePng(path, stored(field, c.exponent, c.matrix), bits, c.chunks);
            const Probe probe = read();
            // Half a step of 256 times the slope of the curve, and the matrix' rows; profiles store their numbers with 1.5e-5 and D50.
            EXPECT_LT(distance(probe), bits == 8 ? 0.009 : 0.001) << c.what << ", " << bits << " bits";
        }
    Image display = toDisplay(field, 0.0, ToneCurve::None);
    for (const std::string& chunks : {std::string(), srgb, srgb + test::gammaChunk(1.0)}) {
        test::writePng(path, display, 16, chunks);
        EXPECT_LT(distance(read()), 1e-4);
        EXPECT_EQ(assumed(read(), "encoding").certainty, chunks.empty() ? Certainty::Likely : Certainty::Certain);
    }
}

TEST_F(ForeignFiles, AColorSpaceThatIsAskedForWinsOverTheFile)
{
    path = folder / "file.png";
    test::writePng(path, stored(field, 1.8), 16, test::gammaChunk(1 / 2.2));
    EXPECT_LT(distance(read({.colorSpace = "gamma1.8"})), 1e-4);
    EXPECT_EQ(assumed(read({.colorSpace = "gamma1.8"}), "encoding").why, "asked for");
    path = folder / "file.exr"; // ACEScg without a word about it
    const Chromaticities ap1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};
    writeImage(path, stored(field, 1.0, glm::inverse(toRec709(ap1))));
    EXPECT_LT(distance(read({.colorSpace = "acescg"})), 1e-5);
    EXPECT_THROW(read({.colorSpace = "no such space"}), InvalidArgument);
}

TEST_F(ForeignFiles, AColorSpaceMayBeOfAnOpenColorIoConfiguration)
{
    test::writeBytes(folder / "c.ocio",
                     "ocio_profile_version: 2\nroles:\n  default: lin_rec709\n  scene_linear: lin_rec709\nfile_rules:\n"
                     "  - !<Rule> {name: Default, colorspace: default}\ndisplays:\n  d:\n    - !<View> {name: v, colorspace: lin_rec709}\n"
                     "colorspaces:\n  - !<ColorSpace>\n    name: lin_rec709\n  - !<ColorSpace>\n    name: a camera\n"
                     "    to_scene_reference: !<MatrixTransform> {matrix: [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]}\n");
    Image half = field;
    for (float& value : half.texels)
        value *= 0.5f;
    writeImage(path, half);
    ::setenv("OCIO", (folder / "c.ocio").c_str(), 1);
    EXPECT_LT(distance(read({.colorSpace = "a camera"})), 1e-6);
    EXPECT_THROW(read({.colorSpace = "another"}), InvalidArgument);
    ::unsetenv("OCIO");
}

TEST_F(ForeignFiles, ColorsAreAsDrawnWhateverTheAlpha)
{
    path = folder / "file.png";
    Image rgba(64, 32, 4);
    const Image display = toDisplay(field, 0.0, ToneCurve::None);
    for (int i = 0; i < 64 * 32; ++i) {
        std::copy_n(&display.texels[static_cast<size_t>(3 * i)], 3, &rgba.texels[static_cast<size_t>(4 * i)]);
        rgba.texels[static_cast<size_t>(4 * i + 3)] = i % 3 == 0 ? 0.0f : i % 3 == 1 ? 0.5f : 1.0f;
    }
    test::writePng(path, rgba, 8);
    EXPECT_LT(distance(read()), 0.006);
    const Image multiplied = readImage(path, {}, Channels::ColorAndOpacity);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(multiplied.texel(i, 4)[3], rgba.texel(i, 4)[3], 0.003);
        EXPECT_NEAR(multiplied.texel(i, 4)[0], field.texel(i, 4)[0] * rgba.texel(i, 4)[3], 0.006) << "light times opacity";
    }
}

TEST_F(ForeignFiles, FillsRowsWithoutAValueAndRefusesAProbeWithoutAFiniteTexel)
{
    Image image(64, 32, 3, 1.0f);
    for (const int y : {0, 1, 12, 30, 31})
        std::fill_n(image.row(y), 64 * 3, std::numeric_limits<float>::quiet_NaN());
    writeImage(path, image);
    const Probe probe = read();
    EXPECT_EQ(probe.map.image, Image(64, 32, 3, 1.0f));
    EXPECT_EQ(probe.repaired.filledRows, 15);
    EXPECT_EQ(probe.repaired.nan, 5 * 64 * 3);
    writeImage(path, Image(64, 32, 3, std::numeric_limits<float>::infinity()));
    EXPECT_THAT([&] { read(); }, testing::Throws<FileError>(testing::Property(&std::exception::what, HasSubstr("no finite value"))));
}

} // namespace
} // namespace mirrorball
