#include "core/preview/disc_places.h"
#include "core/preview/renderer.h"

#include "gl_fixture.h"

#include <cmath>
#include <limits>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using DiscPlacesOfAPicture = mirrorball::test::GlTest;

namespace {

constexpr glm::dvec3 towardsViewer{0.0, 0.0, 1.0};

/// Every texel holds its own place, which halves round to 2^-11 at most.
SphereMapChain placesAsColors(SphereMapIndex index)
{
    constexpr int size = 1024;
    SphereMapTexels texels{.levels = {Image(size, size, 4)}, .index = index};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            float* t = texels.levels[0].texel(x, y);
            t[0] = (static_cast<float>(x) + 0.5f) / size;
            t[1] = 1.0f - (static_cast<float>(y) + 0.5f) / size;
            t[2] = 0.0f;
            t[3] = 1.0f;
        }
    return std::make_shared<const SphereMapTexels>(std::move(texels));
}

RenderSettings view(GeometryKind kind)
{
    RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.samples = 1;
    settings.geometry.kind = kind;
    settings.background.kind = Backdrop::None;
    settings.yaw = 0.7f;
    settings.camera = Camera{.yaw = 0.2f, .pitch = 0.1f, .roll = 0.2f, .distance = 3.0f};
    settings.material.specular = glm::vec3(0.0f);
    // What is shifted by flecks is read as points, not over a pixel's footprint; these shift by nothing.
    settings.material.paint = {.use = SphereMapUse::Replace, .color = glm::vec3(0.0f), .flecks = {.density = 1e-6f, .spread = 0.0f}};
    return settings;
}

/// The places x in the columns and y in the rows, linear but for an edge between columns 3 and 4; the last column is beside the object.
DiscPlaces ramp()
{
    DiscPlaces places{Image(8, 4, 2)};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            places.places.texel(x, y)[0] = x == 7 ? DiscPlaces::noPlace : 0.01f * static_cast<float>(x) + (x > 3 ? 0.5f : 0.0f);
            places.places.texel(x, y)[1] = x == 7 ? DiscPlaces::noPlace : 0.02f * static_cast<float>(y);
        }
    return places;
}

} // namespace

// What a pen touches is what it then colors: the picture of a map that holds places shows the very places the pen is told.
TEST_F(DiscPlacesOfAPicture, AreWhereItsColorsComeFrom)
{
    Renderer renderer;
    for (const GeometryKind kind : {GeometryKind::Sphere, GeometryKind::Box, GeometryKind::Window})
        for (const SphereMapIndex index : {SphereMapIndex::Normal, SphereMapIndex::Reflection})
            for (const MapSpace space : {MapSpace::Eye, MapSpace::World}) {
                RenderSettings settings = view(kind);
                settings.material.paint.space = space;
                const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {placesAsColors(index)}});
                const DiscPlaces places = renderer.discPlaces(settings, index);
                ASSERT_EQ(places.places.width, settings.width);
                int compared = 0;
                for (int y = 0; y < settings.height; ++y)
                    for (int x = 0; x < settings.width; ++x) {
                        const auto place = places.at(x + 0.5, y + 0.5);
                        if (kind != GeometryKind::Window) {
                            ASSERT_EQ(place.has_value(), picture.texel(x, y)[3] > 0.5f) << x << ' ' << y;
                        }
                        if (!place || glm::length(*place) > 0.99) // the outermost texels' middles
                            continue;
                        const glm::dvec2 shown = 2.0 * glm::dvec2(picture.texel(x, y)[0], picture.texel(x, y)[1]) - 1.0;
                        ASSERT_LT(glm::distance(*place, shown), 1e-3) << static_cast<int>(kind) << ' ' << x << ' ' << y;
                        ++compared;
                    }
                EXPECT_GT(compared, 400) << static_cast<int>(kind);
            }
}

TEST(DiscPlaces, AreLinearBetweenPixels)
{
    const DiscPlaces places = ramp();
    for (const glm::dvec2 p : {glm::dvec2(1.5, 1.5), glm::dvec2(1.8, 2.3), glm::dvec2(2.0, 3.2), glm::dvec2(3.2, 0.9)}) {
        ASSERT_TRUE(places.at(p.x, p.y).has_value());
        EXPECT_NEAR(places.at(p.x, p.y)->x, 0.01 * (p.x - 0.5), 1e-7);
        EXPECT_NEAR(places.at(p.x, p.y)->y, 0.02 * (p.y - 0.5), 1e-7);
    }
}

TEST(DiscPlaces, AreNotMixedAcrossAnOutline)
{
    const DiscPlaces places = ramp();
    EXPECT_NEAR(places.at(3.9, 1.5)->x, 0.03, 1e-7);
    EXPECT_NEAR(places.at(4.1, 1.5)->x, 0.54, 1e-7);
    EXPECT_NEAR(places.at(6.9, 1.5)->x, 0.56, 1e-7); // nothing beside it
}

TEST(DiscPlaces, AreNowhereBesideTheObjectAndOutsideThePicture)
{
    const DiscPlaces places = ramp();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const glm::dvec2 p :
         {glm::dvec2(7.1, 1.0), glm::dvec2(-0.1, 1.0), glm::dvec2(1.0, 4.0), glm::dvec2(1.0, -1e9), glm::dvec2(nan, 1.0)})
        EXPECT_FALSE(places.at(p.x, p.y).has_value()) << p.x << ' ' << p.y;
    EXPECT_FALSE(DiscPlaces{}.at(0.0, 0.0).has_value());
}

TEST(DiscPlace, UnderAnOrthographicCameraIsTheNormalSeenOnABall)
{
    for (const glm::dvec3 d : {glm::dvec3(0.3, -0.4, 0.8), glm::dvec3(0, 0, 1), glm::dvec3(-0.9, 0.1, 0.2)}) {
        const glm::dvec3 n = glm::normalize(d);
        for (const SphereMapIndex index : {SphereMapIndex::Normal, SphereMapIndex::Reflection}) // the disc is the picture of a mirror ball
            EXPECT_LT(glm::distance(discPlace(index, MapSpace::Eye, n, towardsViewer), glm::dvec2(n)), 1e-15);
    }
}

TEST(DiscPlace, ByNormalIsTheSineOfTheAngleToTheViewRayFromTheCenter)
{
    const glm::dvec3 v = glm::normalize(glm::dvec3(-0.4, 0.1, 0.7));
    for (const glm::dvec3 d : {glm::dvec3(-0.4, 0.1, 0.7), glm::dvec3(0.3, -0.4, 0.8), glm::dvec3(-0.5, 0.5, 0.7)}) {
        const glm::dvec3 n = glm::normalize(d);
        EXPECT_NEAR(glm::length(discPlace(SphereMapIndex::Normal, MapSpace::Eye, n, v)), glm::length(glm::cross(n, v)), 1e-14);
    }
}

TEST(DiscPlace, ANormalAcrossTheViewRayIsOnTheRimAndOneThatFacesAwayToo)
{
    const glm::dvec3 v = glm::normalize(glm::dvec3(0.2, -0.3, 0.9));
    const glm::dvec3 across = glm::normalize(glm::cross(v, glm::dvec3(0, 1, 0))), away = glm::normalize(across - 0.3 * v);
    const glm::dvec2 rim = discPlace(SphereMapIndex::Normal, MapSpace::Eye, across, v);
    EXPECT_NEAR(glm::length(rim), 1.0, 1e-15);
    EXPECT_LT(glm::distance(discPlace(SphereMapIndex::Normal, MapSpace::Eye, away, v), rim), 1e-15);
}

TEST(DiscPlace, ByReflectionTheMapShowsThereWhatIsMirroredThere)
{
    const glm::dvec3 v = glm::normalize(glm::dvec3(0.2, 0.1, 0.9)), n = glm::normalize(glm::dvec3(0.5, -0.3, 0.6));
    const glm::dvec3 r = sphere_map::directionFromDisc(discPlace(SphereMapIndex::Reflection, MapSpace::Eye, n, v));
    EXPECT_NEAR(glm::dot(r, n), glm::dot(v, n), 1e-14);        // the angle of incidence
    EXPECT_LT(glm::distance(glm::normalize(r + v), n), 1e-14); // in the plane of incidence
}
