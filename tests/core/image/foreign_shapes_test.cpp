/// The kinds of foreign_files_test that are about shape: sheets, files, angles, balls.

#include "core/image/ball_finder.h"
#include "core/image/map_file.h"
#include "core/image/probe_picture.h"
#include "support/foreign_file.h"

#include <algorithm>

namespace mirrorball {
namespace {

using test::latlong;
using testing::HasSubstr;

struct ForeignShapes : test::ForeignFile {};

TEST_F(ForeignShapes, MirrorAndFaceOrderUndoWhatAFileDid)
{
    const EnvironmentMap cube = test::fieldMap({Parameterization::Cube, 8, 0});
    for (const MirrorAxis axis : {MirrorAxis::X, MirrorAxis::Y, MirrorAxis::Z}) {
        Image mirrored = field; // a latlong's texels map onto texels under each
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                std::copy_n(field.texel(axis == MirrorAxis::X   ? 63 - x
                                        : axis == MirrorAxis::Z ? (95 - x) % 64
                                                                : x,
                                        axis == MirrorAxis::Y ? 31 - y : y),
                            3, mirrored.texel(x, y));
        writeImage(path, mirrored);
        EXPECT_GT(distance(read()), 0.5);
        EXPECT_LT(distance(read({.mirror = axis})), 1e-6);
    }
    Image shuffled(48, 8, 3); // nz py px nx ny pz in a row
    const int order[]{5, 2, 0, 1, 3, 4};
    for (int i = 0; i < 6; ++i)
        for (int y = 0; y < 8; ++y)
            std::copy_n(cube.image.row(order[i] * 8 + y), 24, shuffled.texel(8 * i, y));
    writeImage(path, shuffled);
    EXPECT_GT(distance(read()), 0.5);
    EXPECT_LT(distance(read({.faces = "nz py px nx ny pz"})), 1e-6);
    EXPECT_THROW(read({.faces = "nz py px nx ny ny"}), InvalidArgument);
}

TEST_F(ForeignShapes, ATurnLevelsAHorizon)
{
    // The field turned by R is 0.5 + 0.4 R^T d: what was tipped by (0, 10, -20) degrees comes upright by the inverse, here as a quaternion.
    const ProbeReading tipped{.rotateDeg = {0.0, 10.0, -20.0}};
    const glm::dmat3 tip = orientation(tipped);
    EnvironmentMap map(latlong);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec3 value(test::fieldAt(glm::transpose(tip) * texelDirection(latlong, x, y)));
            std::copy_n(&value.x, 3, map.image.texel(x, y));
        }
    writeImage(path, map.image);
    const glm::dmat3 back = glm::transpose(tip);
    const double w = 0.5 * std::sqrt(1.0 + back[0][0] + back[1][1] + back[2][2]);
    const std::string quaternion = std::to_string(w) + "," + std::to_string((back[1][2] - back[2][1]) / (4 * w)) + "," +
                                   std::to_string((back[2][0] - back[0][2]) / (4 * w)) + "," +
                                   std::to_string((back[0][1] - back[1][0]) / (4 * w));
    EXPECT_LT(distance(read({.rotateDeg = parseRotation("--rotate", quaternion)})), 2e-3); // bilinear between texels of 5.6 degrees
}

TEST_F(ForeignShapes, ReadsSixFilesWhateverTheirNames)
{
    const EnvironmentMap cube = test::fieldMap({Parameterization::Cube, 8, 0});
    const std::vector<std::vector<std::string>> names{{"px", "nx", "py", "ny", "pz", "nz"},
                                                      {"posx", "negx", "posy", "negy", "posz", "negz"},
                                                      {"+X", "-X", "+Y", "-Y", "+Z", "-Z"},
                                                      {"right", "left", "top", "bottom", "front", "back"},
                                                      {"Right", "Left", "Up", "Down", "Front", "Back"},
                                                      {"PosX", "NegX", "PosY", "NegY", "PosZ", "NegZ"}};
    for (const auto& words : names) {
        const test::TemporaryFolder own;
        for (int face = 0; face < 6; ++face) {
            Image image(8, 8, 3);
            std::copy_n(cube.image.row(8 * face), image.texels.size(), image.texels.begin());
            writeImage(own / ("sky_" + words[static_cast<size_t>(face)] + ".exr"), image);
        }
        EXPECT_LT(distance(readFile((own / "sky_%s.exr").string())), 1e-6) << words[0];
        const Probe one = readFile((own / ("sky_" + words[2] + ".exr")).string());
        EXPECT_THAT(one.notes, testing::Contains(HasSubstr("sky_%s.exr"))) << "a face alone points to its family";
    }
    EXPECT_THAT([&] { readFile((folder / "none_%s.exr").string()); },
                testing::Throws<FileError>(testing::Property(&std::exception::what, HasSubstr("px nx"))));
}

TEST_F(ForeignShapes, HalvesAreWrittenWithAlphaAndBlendedByItWhereBothSee)
{
    const EnvironmentMap map = test::fieldMap({Parameterization::Paraboloid, 32, 4});
    const std::string name = (folder / "p_%s.exr").string();
    EXPECT_EQ(writeMap(name, {map}).size(), 2u);
    const Image front = readImage(folder / "p_front.exr", {}, Channels::ColorAndOpacity);
    EXPECT_EQ(front.texel(16, 16)[3], 1.0f);
    EXPECT_EQ(front.texel(0, 0)[3], 0.0f);
    EXPECT_GT(front.texel(1, 1)[0], 0.0f) << "colors go on beyond the circle";
    const Probe back = readFile(name);
    EXPECT_EQ(back.map.layout, map.layout);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            // Within a texel of the circle the other half's texels mix in, as bilinear lookups find their alpha; beyond it they alone say
            // what is there, from one side of the place only.
            const double radius = std::hypot(x % 32 + 0.5 - 16.0, y + 0.5 - 16.0);
            if (isInside(map.layout, x, y)) {
                EXPECT_NEAR(back.map.image.texel(x, y)[1], map.image.texel(x, y)[1], radius < 11.0 ? 0.0 : radius < 12.0 ? 1e-3 : 0.03);
            }
        }
    // Both halves see everything, half believed each, the back one 0.2 too bright: the mean is 0.1 too bright where both have a place.
    const auto bright = [&](bool isBack) {
        Image half(32, 32, 4, 0.5f);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                for (int c = 0; c < 3; ++c)
                    half.texel(x, y)[c] = map.image.texel(x + (isBack ? 32 : 0), y)[c] + (isBack ? 0.2f : 0.0f);
        writeImage(folder / (isBack ? "p_back.exr" : "p_front.exr"), half, {.attributes = {{"mirrorball:border", "4"}}});
    };
    bright(false);
    bright(true);
    const Probe blended = readFile(name);
    const glm::dvec3 rim = direction(map.layout, {16.0 + 12.0, 16.0});
    EXPECT_NEAR(blended.map.radiance(rim).x, test::fieldAt(rim).x + 0.1, 0.01);
    EXPECT_NEAR(blended.map.radiance({0, 0, 1}).x, 0.5, 0.01) << "the back half's picture ends before +Z";
}

TEST_F(ForeignShapes, AlmostTwoToOneIsStretchedWithAWord)
{
    writeImage(path, test::fieldPicture(61, 30));
    const Probe probe = read();
    EXPECT_LT(distance(probe), 0.01); // bilinear
    EXPECT_FALSE(probe.certain);
    EXPECT_THAT(probe.notes, testing::ElementsAre(HasSubstr("almost 2:1")));
    EXPECT_TRUE(read({.fit = Fit::Stretch}).certain);
    EXPECT_EQ(read({.fit = Fit::Crop}).map.layout.size, 30);
    writeImage(path, test::fieldPicture(60, 20));
    EXPECT_THAT([&] { read(); }, testing::Throws<FileError>(testing::Property(&std::exception::what, HasSubstr("--fit pad"))));
}

TEST_F(ForeignShapes, PartialPanoramasAreBlackWhereTheyEnd)
{
    writeImage(path, test::fieldPicture(64, 16, 360.0, 90.0)); // by its shape, square texels
    const auto check = [&](const Probe& probe, double horizontal, double vertical) {
        std::int64_t black = 0;
        for (int y = 0; y < probe.map.image.height; ++y)
            for (int x = 0; x < probe.map.image.width; ++x) {
                const glm::dvec3 d = texelDirection(probe.map.layout, x, y);
                const bool shown =
                    std::abs(std::atan2(d.x, d.z)) * 180 / pi < 0.5 * horizontal && std::abs(std::asin(d.y)) * 180 / pi < 0.5 * vertical;
                black += shown ? 0 : 1;
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(probe.map.image.texel(x, y)[c], shown ? test::fieldAt(d)[c] : 0.0, 1e-6);
            }
        EXPECT_THAT(probe.notes, testing::Contains(HasSubstr(std::to_string(black) + " of ")));
    };
    check(read({.fit = Fit::Pad}), 360.0, 90.0);
    check(read({.verticalAngleDeg = 90.0}), 360.0, 90.0);
    writeImage(path, test::fieldPicture(32, 32, 180.0, 180.0)); // square, read as half a latlong
    check(read({.parameterization = Parameterization::Latlong, .horizontalAngleDeg = 180.0}), 180.0, 180.0);
}

TEST_F(ForeignShapes, AFisheyeIsAHemisphereBlackOrMirroredBehind)
{
    // Equidistant: radius = angle / 90 degrees, +X at the left as in every picture from inside.
    constexpr int n = 64;
    Image disc(n, n, 3);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const glm::dvec2 q{1.0 - 2.0 * (x + 0.5) / n, 1.0 - 2.0 * (y + 0.5) / n};
            const double r = glm::length(q), angle = 0.5 * pi * std::min(r, 1.0);
            const glm::dvec2 side = r > 0.0 ? q / r * std::sin(angle) : q;
            const glm::vec3 value(test::fieldAt({side.x, side.y, std::cos(angle)}));
            std::copy_n(&value.x, 3, disc.texel(x, y));
        }
    writeImage(path, disc);
    ProbeReading reading{.parameterization = Parameterization::Angular, .horizontalAngleDeg = 180.0};
    const Probe black = read(reading);
    reading.beyond = BeyondView::Mirrored;
    const Probe mirrored = read(reading);
    for (const glm::dvec3& d : {glm::dvec3(0, 0, 1), {0.6, 0.0, 0.8}, {-0.8, 0.36, 0.48}, {0.0, -0.8, 0.6}}) {
        EXPECT_NEAR(black.map.radiance(d).x, test::fieldAt(d).x, 0.01);
        EXPECT_NEAR(black.map.radiance(d).y, test::fieldAt(d).y, 0.01);
        EXPECT_EQ(black.map.radiance({d.x, d.y, -d.z}), glm::vec3(0.0f));
        EXPECT_NEAR(mirrored.map.radiance({d.x, d.y, -d.z}).x, test::fieldAt(d).x, 0.01);
    }
}

TEST_F(ForeignShapes, NotSquareBecomesSquareOnRequest)
{
    const EnvironmentMap square = test::fieldMap({Parameterization::Octahedral, 16, 0});
    Image wide(24, 16, 3, 9.0f);
    for (int y = 0; y < 16; ++y)
        std::copy_n(square.image.row(y), 48, wide.texel(4, y));
    writeImage(path, wide);
    EXPECT_THROW(read({.parameterization = Parameterization::Octahedral}), FileError);
    EXPECT_LT(distance(read({.parameterization = Parameterization::Octahedral, .fit = Fit::Crop})), 1e-6);
}

TEST_F(ForeignShapes, FindsTheBallInAPhotograph)
{
    // A ball that mirrors stripes, off the middle of a room with a gradient and a dark window.
    for (const auto& [cx, cy, r] : {std::tuple(170.3, 121.8, 80.5), {140.0, 100.0, 55.0}, {150.0, 100.0, 98.0}}) {
        Image photo(300, 200, 3);
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 300; ++x) {
                const double dx = (x + 0.5 - cx) / r, dy = (y + 0.5 - cy) / r, rho2 = dx * dx + dy * dy;
                const double room = 0.3 + 0.001 * x - (x < 60 && y < 80 ? 0.2 : 0.0);
                const double ball = 0.9 + 0.3 * std::sin(9.0 * dx) + 0.2 * dy;
                std::fill_n(photo.texel(x, y), 3, static_cast<float>(rho2 < 1.0 ? ball : room));
            }
        const auto found = findBall(photo);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->center.x, cx, 1.0);
        EXPECT_NEAR(found->center.y, cy, 1.0);
        EXPECT_NEAR(found->radius, r, 1.0);
    }
    EXPECT_FALSE(findBall(Image(300, 200, 3, 0.5f))) << "nothing stands out";
}

TEST_F(ForeignShapes, CropsAMirrorBallToASphereMap)
{
    const EnvironmentMap sphere = test::fieldMap({Parameterization::Sphere, 100, 0});
    Image photo(300, 200, 3, 0.02f);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            if (std::hypot(x + 0.5 - 50, y + 0.5 - 50) <= 50.0)
                std::copy_n(sphere.image.texel(x, y), 3, photo.texel(x + 120, y + 60));
    writeImage(path, photo);
    const Probe probe = read({.parameterization = Parameterization::Sphere, .fit = Fit::Crop});
    for (const glm::dvec3& d : {glm::dvec3(0, 0, 1), {0.6, 0.0, 0.8}, {-0.8, 0.36, 0.48}, {0.0, -0.96, 0.28}, {0.6, 0.6, -0.529}})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(probe.map.radiance(d)[c], test::fieldAt(d)[c], 0.03);
}

} // namespace
} // namespace mirrorball
