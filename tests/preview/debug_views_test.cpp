#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "test_environments.h"

#include "core/base/error.h"
#include "core/image/mip_pyramid.h"

#include <algorithm>
#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using DebugViews = mirrorball::test::GlTest;

namespace {

glm::dvec3 at(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

RenderSettings view(Shading shading, GeometryKind kind = GeometryKind::Teapot)
{
    RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.samples = 1;
    settings.geometry.kind = kind;
    settings.shading = shading;
    settings.background.kind = Backdrop::None;
    settings.camera.yaw = 0.6f;
    settings.camera.pitch = 0.35f;
    return settings;
}

MapLevels pyramid(const MapLayout& layout)
{
    return std::make_shared<const std::vector<EnvironmentMap>>(buildMipPyramid(environmentFrom(layout, smoothRadiance)).levels);
}

} // namespace

TEST_F(DebugViews, NormalsAreThoseOfTheBuffersAndNeedNoMap)
{
    const RenderSettings settings = view(Shading::Normals);
    Renderer renderer;
    const Image picture = renderer.renderRadiance(settings, {});
    const GeometryBuffers buffers = renderer.renderBuffers(settings);
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
            if (buffers.normal.texel(x, y)[3] == 1.0f) {
                ASSERT_LT(glm::distance(at(picture, x, y), 0.5 + 0.5 * at(buffers.normal, x, y)), 1e-5);
            }
}

TEST_F(DebugViews, AreNeitherExposedNorToneMapped)
{
    RenderSettings settings = view(Shading::Normals);
    Renderer renderer;
    const Image plain = renderer.renderDisplay(settings, {});
    settings.exposure = 4.0f;
    settings.toneCurve = ToneCurve::Reinhard;
    EXPECT_EQ(renderer.renderDisplay(settings, {}).texels, plain.texels);
}

// Seen along -Z the face of a box is a square whose edges and diagonal are lines, one pixel wide.
TEST_F(DebugViews, WireframeShowsTheTrianglesInLinesOfOnePixel)
{
    RenderSettings settings = view(Shading::Wireframe, GeometryKind::Box);
    settings.width = settings.height = 200;
    settings.camera = Camera{.distance = 4.0f, .projection = Projection::Orthographic};
    const auto brightIn = [&](const Image& picture, int y) {
        double sum = 0.0;
        for (int x = 70; x < 130; ++x)
            sum += std::max(0.0, (double(picture.texel(x, y)[0]) - 0.22) / (0.9 - 0.22)) * picture.texel(x, y)[3];
        return sum;
    };
    Renderer renderer;
    const Image one = renderer.renderRadiance(settings, {});
    // A row between the edges crosses the diagonal, at 45 degrees. Sampling a line of one pixel at pixel centers: a sixth of its width.
    EXPECT_NEAR(brightIn(one, 90), std::sqrt(2.0), 0.25);
    settings.pixelRatio = 3.0f;
    EXPECT_NEAR(brightIn(renderer.renderRadiance(settings, {}), 90) / brightIn(one, 90), 3.0, 0.5);
}

// What is a seam follows from the coordinates alone: neighboring directions whose texels are far apart.
TEST_F(DebugViews, SeamsRunWhereNeighboringDirectionsHaveTexelsFarApart)
{
    Renderer renderer;
    for (const MapLayout& layout : everyLayout(256)) {
        RenderSettings settings = view(Shading::Seams, GeometryKind::Sphere);
        settings.geometry.level = 48;
        settings.width = settings.height = 240;
        settings.camera = Camera{.yaw = 0.4f, .pitch = -0.3f, .distance = 3.4f};
        settings.seamsOf = layout.kind;
        const Image picture = renderer.renderRadiance(settings, {});
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        const auto isLine = [&](int x, int y) {
            const glm::dvec3 c = at(picture, x, y);
            return std::min({c.x, c.y, c.z}) > 0.6;
        };
        int jumps = 0, lines = 0, lonely = 0;
        for (int y = 4; y < settings.height - 4; ++y)
            for (int x = 4; x < settings.width - 4; ++x) {
                const auto isInside = [&](int i, int j) { return buffers.direction.texel(x + i, y + j)[3] == 1.0f; };
                if (!isInside(-4, 0) || !isInside(4, 0) || !isInside(0, -4) || !isInside(0, 4))
                    continue;
                const auto coordinateAt = [&](int i, int j) { return coordinate(layout, at(buffers.direction, x + i, y + j)); };
                const auto jumpsAt = [&](int i, int j, double texels = 60.0) {
                    return glm::distance(coordinateAt(i, j), coordinateAt(i + 1, j)) > texels ||
                           glm::distance(coordinateAt(i, j), coordinateAt(i, j + 1)) > texels;
                };
                const bool isPole = layout.kind == Parameterization::Latlong && std::abs(buffers.direction.texel(x, y)[1]) > 0.95f;
                if (jumpsAt(0, 0) && !isPole) { // beside a pole columns are narrow
                    ++jumps;
                    bool found = false;
                    for (int j = -1; j <= 2; ++j)
                        for (int i = -1; i <= 2; ++i)
                            found = found || isLine(x + i, y + j);
                    ASSERT_TRUE(found) << name(layout.kind) << ' ' << x << ' ' << y;
                }
                if (isLine(x, y)) {
                    ++lines;
                    bool found = false;
                    for (int j = -3; j <= 2 && !found; ++j)
                        for (int i = -3; i <= 2 && !found; ++i)
                            found = jumpsAt(i, j, 12.0); // an octahedron's seams close towards the equator
                    lonely += !found;
                }
            }
        if (layout.kind != Parameterization::Sphere && layout.kind != Parameterization::Angular) { // their seam lies on the silhouette
            EXPECT_GT(jumps, 50) << name(layout.kind);
            EXPECT_GT(lines, 50) << name(layout.kind);
        }
        // Beyond the ends of a seam the line is round; a cube's neighbors may be near each other where faces are stacked.
        EXPECT_LE(lonely, 12 + (layout.kind == Parameterization::Cube ? lines / 2 : 0)) << name(layout.kind);
    }
}

// The level from neighboring directions, as 002 has it, against the color that is shown.
TEST_F(DebugViews, MipLevelsAreThoseThatTheLookupReads)
{
    Renderer renderer;
    for (const MapLayout& layout : {MapLayout{Parameterization::Octahedral, 256, 0}, MapLayout{Parameterization::Sphere, 256, 0}}) {
        const MapLevels levels = pyramid(layout);
        RenderSettings settings = view(Shading::Mips, GeometryKind::Sphere);
        settings.geometry.level = 64;
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        const auto levelAt = [&](int x, int y) {
            const auto d = [&](int i, int j) { return at(buffers.direction, x + i, y + j); };
            const double dx = glm::distance(d(-1, 0), d(1, 0)) / 2.0, dy = glm::distance(d(0, -1), d(0, 1)) / 2.0;
            return std::log2(std::max(dx, dy) / std::sqrt(density(layout, coordinate(layout, d(0, 0)))));
        };
        for (const auto& [lambda, bias] : {std::pair{0.0f, 0.0f}, std::pair{2.0f, 0.0f}, std::pair{0.0f, 1.5f}, std::pair{3.0f, -1.0f}}) {
            settings.material.lambda = lambda;
            settings.material.lodBias = bias;
            const Image picture = renderer.renderRadiance(settings, {levels, {}, {}});
            int compared = 0;
            for (int y = 50; y < 70; ++y)
                for (int x = 70; x < 90; ++x, ++compared) {
                    const float expected = std::clamp(std::max(float(levelAt(x, y)) + bias, lambda), 0.0f, float(levels->size()) - 1.0f);
                    // One-sided differences on the GPU, facets of the sphere: a sixth of a level.
                    ASSERT_LT(glm::distance(at(picture, x, y), glm::dvec3(levelColor(expected))), 0.17)
                        << name(layout.kind) << " lambda " << lambda << " bias " << bias << " level " << expected;
                }
            EXPECT_EQ(compared, 400);
        }
    }
}

// Drawn alone, a pixel reads the level whose color it has in the whole picture.
TEST_F(DebugViews, TheLevelOfAPixelIsWhatItsColorStandsFor)
{
    Renderer renderer;
    const MapLevels levels = pyramid({Parameterization::Latlong, 64, 0});
    RenderSettings settings = view(Shading::Mips, GeometryKind::Sphere);
    const Image picture = renderer.renderRadiance(settings, {levels, {}, {}});
    settings.shading = Shading::Material;
    int shown = 0;
    for (int y = 5; y < settings.height; y += 10)
        for (int x = 5; x < settings.width; x += 10) {
            const std::optional<float> level = renderer.level(settings, {levels, {}, {}}, x, y);
            ASSERT_EQ(level.has_value(), picture.texel(x, y)[3] == 1.0f) << x << " " << y;
            if (level) {
                EXPECT_LT(glm::distance(at(picture, x, y), glm::dvec3(levelColor(*level))), 1e-3) << x << " " << y;
                ++shown;
            }
        }
    EXPECT_GT(shown, 20);
    EXPECT_THROW(renderer.level(settings, {levels, {}, {}}, settings.width, 0), InvalidArgument);

    const auto one = std::make_shared<const std::vector<EnvironmentMap>>(std::vector{levels->front()});
    EXPECT_FALSE(renderer.level(settings, {one, {}, {}}, 80, 60)); // a map without levels has none to read
    settings.material.hasBrdf = true;
    EXPECT_FALSE(renderer.level(settings, {levels, {}, {}}, 80, 60)); // a BRDF reads several
}

TEST_F(DebugViews, LevelColorsOfShaderAndCoreAgree)
{
    std::vector<glm::vec4> inputs;
    for (int i = -10; i <= 90; ++i)
        inputs.emplace_back(0.1f * float(i), 0.0f, 0.0f, 0.0f);
    const auto results =
        evaluateGlsl("#include \"lib/level_color.glsl\"\nvec4 twin(vec4 x) { return vec4(levelColor(x.x), 0.0); }", inputs);
    for (size_t i = 0; i < inputs.size(); ++i)
        ASSERT_LT(glm::distance(glm::vec3(results[i]), levelColor(inputs[i].x)), 1e-6f);
}

// A marker of the direction that a pixel mirrors is a point on that pixel, and a ring of eight pixels about it.
TEST_F(DebugViews, TheMarkerStandsWhereTheObjectMirrorsItsDirection)
{
    RenderSettings settings = view(Shading::Material, GeometryKind::Sphere);
    settings.geometry.level = 64;
    settings.width = settings.height = 200;
    const MapLevels black = asLevels(EnvironmentMap({Parameterization::Cube, 4, 0}));
    Renderer renderer;
    const auto hit = renderer.pick(settings, 90, 110);
    ASSERT_TRUE(hit.has_value());
    settings.marker = hit->lookup;
    const Image picture = renderer.renderDisplay(settings, {black, {}, {}});
    EXPECT_GT(picture.texel(90, 110)[0], 0.9f);
    EXPECT_GT(picture.texel(98, 110)[0], 0.6f);
    EXPECT_GT(picture.texel(90, 102)[0], 0.6f);
    EXPECT_LT(picture.texel(94, 110)[0], 0.1f);
    EXPECT_LT(picture.texel(115, 110)[0], 0.1f);
}

// The box that a ball of radius 1 fits: seen along -Z its edges are a square of half the width 1, and nothing lies outside of it.
TEST_F(DebugViews, BoundsAreTheSmallestBoxAlongTheAxes)
{
    RenderSettings settings = view(Shading::Bounds, GeometryKind::Sphere);
    settings.width = settings.height = 200;
    settings.camera = Camera{.distance = 4.0f, .projection = Projection::Orthographic};
    const double pixels = 0.5 * settings.height / (4.0 * std::tan(0.5 * static_cast<double>(settings.camera.fieldOfView)));
    const Image picture = Renderer().renderRadiance(settings, {});
    const auto isLine = [&](double x, double y) {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const float* t = picture.texel(static_cast<int>(100 + x * pixels) + dx, static_cast<int>(100 + y * pixels) + dy);
                if (t[3] > 0.0f && t[0] > 2.0f * t[2])
                    return true;
            }
        return false;
    };
    for (const double along : {-0.9, -0.5, 0.1, 0.7})
        for (const double side : {-1.0, 1.0}) {
            EXPECT_TRUE(isLine(side, along)) << side << " " << along;
            EXPECT_TRUE(isLine(along, side)) << side << " " << along;
            EXPECT_FALSE(isLine(0.9 * side, along)) << side << " " << along;
        }
    EXPECT_EQ(picture.texel(static_cast<int>(100 + 1.1 * pixels), 100)[3], 0.0f);
}

// A ball's normals stand out of its outline, along the radius, by the length of a line.
TEST_F(DebugViews, NormalLinesStandOnTheSurface)
{
    RenderSettings settings = view(Shading::NormalLines, GeometryKind::Sphere);
    settings.geometry.level = 8;
    settings.width = settings.height = 300;
    settings.camera = Camera{.distance = 4.0f, .projection = Projection::Orthographic};
    const double pixels = 0.5 * settings.height / (4.0 * std::tan(0.5 * static_cast<double>(settings.camera.fieldOfView)));
    const Image picture = Renderer().renderRadiance(settings, {});
    const auto countAt = [&](double radius) {
        int lines = 0;
        for (int i = 0; i < 2000; ++i) {
            const double angle = 2.0 * pi * i / 2000;
            const float* t = picture.texel(static_cast<int>(150 + radius * pixels * std::cos(angle)),
                                           static_cast<int>(150 + radius * pixels * std::sin(angle)));
            lines += t[3] > 0.0f && t[2] > 2.0f * t[0];
        }
        return lines;
    };
    EXPECT_GT(countAt(1.04), 50);
    EXPECT_EQ(countAt(1.1), 0);
    EXPECT_GT(countAt(0.5), 50); // those that look at us
}
