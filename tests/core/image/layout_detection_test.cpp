#include "core/image/layout_detection.h"

#include "core/base/error.h"
#include "support/directions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using testing::HasSubstr;
using testing::Property;
using testing::Throws;

ImageFileInfo sized(int width, int height)
{
    ImageFileInfo info;
    info.width = width;
    info.height = height;
    info.channels = 3;
    return info;
}

/// A picture whose texels are all different, numbered from 0 in the first channel.
Image numbered(int width, int height)
{
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.texel(x, y)[0] = static_cast<float>(y * width + x);
    return image;
}

TEST(LayoutDetection, KnowsMapsByTheirShape)
{
    struct Case {
        int width, height;
        Parameterization kind;
        int size;
        Arrangement arrangement;
        bool certain;
    };
    const Case cases[] = {{1024, 512, Parameterization::Latlong, 512, Arrangement::Whole, true},
                          {2, 1, Parameterization::Latlong, 1, Arrangement::Whole, true},
                          {1, 1, Parameterization::Latlong, 1, Arrangement::Constant, true},
                          {64, 384, Parameterization::Cube, 64, Arrangement::Whole, true},
                          {1, 6, Parameterization::Cube, 1, Arrangement::Whole, true},
                          {384, 64, Parameterization::Cube, 64, Arrangement::HorizontalStrip, true},
                          {192, 128, Parameterization::Cube, 64, Arrangement::Grid3x2, true},
                          {128, 192, Parameterization::Cube, 64, Arrangement::Grid2x3, true},
                          {256, 192, Parameterization::Cube, 64, Arrangement::HorizontalCross, true},
                          {192, 256, Parameterization::Cube, 64, Arrangement::VerticalCross, true},
                          {640, 640, Parameterization::Angular, 640, Arrangement::Whole, false}};
    for (const Case& c : cases) {
        const Detection d = detectLayout(sized(c.width, c.height));
        EXPECT_EQ(d.layout, (MapLayout{c.kind, c.size, 0})) << c.width << " x " << c.height;
        EXPECT_EQ(d.arrangement, c.arrangement) << c.width << " x " << c.height;
        EXPECT_EQ(d.certain, c.certain) << c.width << " x " << c.height;
        EXPECT_FALSE(d.reason.empty());
    }
}

TEST(LayoutDetection, NamesTheSizesThatWouldFit)
{
    EXPECT_THAT([] { detectLayout(sized(1000, 400)); },
                Throws<InvalidArgument>(Property(&std::exception::what, AllOf(HasSubstr("1000 x 400"), HasSubstr("2N x N")))));
    EXPECT_THAT([] { detectLayout(sized(1024, 512), Parameterization::Sphere); },
                Throws<InvalidArgument>(Property(&std::exception::what, AllOf(HasSubstr("sphere"), HasSubstr("N x N")))));
    EXPECT_THAT([] { detectLayout(sized(64, 64), Parameterization::Cube); },
                Throws<InvalidArgument>(Property(&std::exception::what, HasSubstr("N x 6N"))));
    EXPECT_THROW(detectLayout(sized(0, 0)), InvalidArgument);
}

TEST(LayoutDetection, AForcedKindWins)
{
    EXPECT_EQ(detectLayout(sized(64, 64), Parameterization::Octahedral).layout, (MapLayout{Parameterization::Octahedral, 64, 0}));
    EXPECT_EQ(detectLayout(sized(64, 64), Parameterization::Sphere).layout, (MapLayout{Parameterization::Sphere, 64, 0}));
    EXPECT_EQ(detectLayout(sized(128, 64), Parameterization::Paraboloid).layout, (MapLayout{Parameterization::Paraboloid, 64, 0}));
    EXPECT_EQ(detectLayout(sized(256, 192), Parameterization::Cube).arrangement, Arrangement::HorizontalCross);
    ImageFileInfo info = sized(64, 64);
    info.attributes["mirrorball:parameterization"] = "octahedral";
    const Detection d = detectLayout(info, Parameterization::Sphere);
    EXPECT_EQ(d.layout.kind, Parameterization::Sphere);
    EXPECT_TRUE(d.certain);
    for (const auto kind : allParameterizations)
        EXPECT_EQ(detectLayout(sized(1, 1), kind).layout, (MapLayout{kind, 1, 0}));
}

TEST(LayoutDetection, BelievesWhatMirrorballWroteWhereTheShapeAllowsIt)
{
    ImageFileInfo info = sized(128, 64);
    info.attributes = {{"mirrorball:parameterization", "paraboloid"}, {"mirrorball:border", "3"}};
    EXPECT_EQ(detectLayout(info).layout, (MapLayout{Parameterization::Paraboloid, 64, 3}));
    EXPECT_EQ(detectLayout(info, Parameterization::Paraboloid).layout, (MapLayout{Parameterization::Paraboloid, 64, 3}));
    info.attributes["mirrorball:border"] = "64"; // no disc left: the file was edited
    EXPECT_EQ(detectLayout(info).layout, (MapLayout{Parameterization::Latlong, 64, 0}));
    info.attributes = {{"mirrorball:parameterization", "sphere"}};
    EXPECT_EQ(detectLayout(info).layout.kind, Parameterization::Latlong);
    info = sized(64, 64);
    info.attributes = {{"mirrorball:parameterization", "sphere"}};
    EXPECT_EQ(detectLayout(info).layout.kind, Parameterization::Sphere);
    EXPECT_TRUE(detectLayout(info).certain);
}

TEST(LayoutDetection, OpenExrsEnvmapAttributeMeansEdgeSampling)
{
    ImageFileInfo info = sized(1024, 512);
    info.envmap = "latlong";
    EXPECT_EQ(detectLayout(info).arrangement, Arrangement::EdgeSampledLatlong);
    EXPECT_EQ(detectLayout(info, Parameterization::Latlong).arrangement, Arrangement::EdgeSampledLatlong);
    EXPECT_EQ(detectLayout(info, Parameterization::Paraboloid).arrangement, Arrangement::Whole);
    info = sized(64, 384);
    info.envmap = "cube";
    EXPECT_EQ(detectLayout(info).arrangement, Arrangement::OpenExrCube);
}

TEST(LayoutDetection, ASingleTexelIsTheSameEverywhere)
{
    Image image(1, 1, 3);
    image.texels = {1.0f, 2.0f, 3.0f};
    for (const auto kind : allParameterizations) {
        const EnvironmentMap map = toEnvironmentMap(image, detectLayout(sized(1, 1), kind));
        for (const auto& d : test::specialDirections())
            EXPECT_LT(glm::distance(map.radiance(d), glm::vec3(1, 2, 3)), 1e-6f);
    }
}

TEST(LayoutDetection, StripsAndGridsHoldTheStackedFacesInReadingOrder)
{
    constexpr int n = 4;
    for (const auto& [columns, rows] : {std::pair{6, 1}, {3, 2}, {2, 3}}) {
        const Image sheet = numbered(columns * n, rows * n);
        const EnvironmentMap map = toEnvironmentMap(sheet, detectLayout(sized(sheet.width, sheet.height)));
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    EXPECT_EQ(*map.image.texel(x, face * n + y), *sheet.texel(face % columns * n + x, face / columns * n + y));
    }
}

TEST(LayoutDetection, ACrossIsAPictureFromInsideWithPlusZInFront)
{
    // Each cell's center and a texel to the right of it and one below it, in the directions of walking around: front +Z, right -X.
    constexpr int n = 9;
    struct Look {
        int column, row;
        glm::dvec3 forward, right, down;
    };
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const Look horizontal[] = {{1, 1, z, -x, -y}, {2, 1, -x, -z, -y}, {3, 1, -z, x, -y},
                               {0, 1, x, z, -y},  {1, 0, y, -x, z},   {1, 2, -y, -x, -z}};
    const Look vertical[] = {{1, 1, z, -x, -y}, {2, 1, -x, -z, -y}, {1, 3, -z, -x, y},
                             {0, 1, x, z, -y},  {1, 0, y, -x, z},   {1, 2, -y, -x, -z}};
    const auto check = [&](const Look(&looks)[6], int columns, int rows) {
        const Image sheet = numbered(columns * n, rows * n);
        const EnvironmentMap map = toEnvironmentMap(sheet, detectLayout(sized(sheet.width, sheet.height)));
        for (const Look& look : looks)
            for (int j = -3; j <= 3; ++j)
                for (int i = -3; i <= 3; ++i) {
                    const glm::dvec3 d =
                        look.forward + 2.0 / n * (static_cast<double>(i) * look.right + static_cast<double>(j) * look.down);
                    EXPECT_NEAR(map.radiance(d).x, *sheet.texel(look.column * n + n / 2 + i, look.row * n + n / 2 + j), 1e-2);
                }
    };
    check(horizontal, 4, 3);
    check(vertical, 3, 4);
}

TEST(LayoutDetection, CellsOfACrossMeetWithoutASeam)
{
    // Neighboring cells of the cross are neighboring faces: over each edge inside the picture the step in the cube finds the texel
    // across the edge in the picture.
    constexpr int n = 4;
    for (const auto& [columns, rows] : {std::pair{4, 3}, {3, 4}}) {
        const Image sheet = numbered(columns * n, rows * n);
        const EnvironmentMap map = toEnvironmentMap(sheet, detectLayout(sized(sheet.width, sheet.height)));
        int meetings = 0;
        for (int y = 0; y < 6 * n; ++y)
            for (int x = 0; x < n; ++x)
                for (const Texel& to : {Texel{x - 1, y}, Texel{x + 1, y}, Texel{x, y - 1}, Texel{x, y + 1}}) {
                    const Texel t = acrossSeam(map.layout, {x, y}, to.x, to.y);
                    const int a = static_cast<int>(*map.image.texel(x, y)), b = static_cast<int>(*map.image.texel(t.x, t.y));
                    const int distance = std::abs(a % sheet.width - b % sheet.width) + std::abs(a / sheet.width - b / sheet.width);
                    if (t.y / n != y / n && distance == 1)
                        ++meetings;
                    EXPECT_TRUE(t.y / n != y / n || distance == 1);
                }
        EXPECT_EQ(meetings, 5 * n * 2); // a cross of six cells has five edges inside
    }
}

TEST(LayoutDetection, RefusesAnImageThatIsNotWhatWasDetected)
{
    const Detection d = detectLayout(sized(8, 4));
    EXPECT_THROW(toEnvironmentMap(Image(8, 5, 3), d), InvalidArgument);
    EXPECT_THROW(toEnvironmentMap(Image(8, 4, 4), d), InvalidArgument);
}

} // namespace
} // namespace mirrorball
