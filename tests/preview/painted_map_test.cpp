#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "test_environments.h"

#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using PaintedMap = mirrorball::test::GlTest;

namespace {

glm::dvec3 at(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

RenderSettings view(GeometryKind kind, std::optional<SphereMapUse> use = SphereMapUse::Replace)
{
    RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.samples = 1;
    settings.geometry.kind = kind;
    settings.background.kind = Backdrop::None;
    settings.camera = Camera{.yaw = 0.6f, .pitch = 0.35f, .roll = 0.3f, .distance = 2.6f};
    settings.material.paint.use = use;
    return settings;
}

template <class Color>
SphereMapTexels texelsFrom(int size, SphereMapIndex index, const Color& color)
{
    Image image(size, size, 4);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec4 c = color(glm::dvec2(2.0 * (x + 0.5) / size - 1.0, 1.0 - 2.0 * (y + 0.5) / size));
            std::copy(&c.x, &c.x + 4, image.texel(x, y));
        }
    return {.levels = {image}, .index = index};
}

/// A map that shows the place itself: red x, green y, from -1 to 1 as 0 to 1. Its texels are whole numbers of 512ths, which half floats
/// hold exactly, and reading it bilinearly gives the place to the precision of float arithmetic, up to half a texel from the map's edge.
SphereMapChain places(SphereMapIndex index)
{
    return std::make_shared<const SphereMapTexels>(
        texelsFrom(256, index, [](const glm::dvec2& p) { return glm::vec4(0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y, 0.0, 1.0); }));
}

/// The same, its levels hand-made.
SphereMapChain placesByHand(SphereMapIndex index)
{
    SphereMapTexels texels = *places(index);
    texels.hasAuthoredLevels = true;
    return std::make_shared<const SphereMapTexels>(std::move(texels));
}

/// Where a lookup is a point. Otherwise a pixel shows the mean over its footprint: on a tube a few pixels thick, or where a triangle is
/// seen so flat that its derivatives reach beyond it, that differs from the place at the pixel's middle by several texels. What is shifted
/// by flecks is read without anisotropy, and these shift by nothing.
void readPoints(RenderSettings& settings) { settings.material.paint.flecks = {.density = 1e-6f, .spread = 0.0f}; }

/// Float rounding of positions, normals and the place, 2^-23 in all, grows by the lever of the reflection, a hundredfold towards the rim.
constexpr double rounding = 2e-5;
constexpr double insideTheEdge = 1.0 - 1.0 / 256; ///< middle of the outermost texels

SphereMapChain plain(const glm::vec4& color)
{
    return std::make_shared<const SphereMapTexels>(texelsFrom(4, SphereMapIndex::Normal, [&](const glm::dvec2&) { return color; }));
}

glm::dvec2 placeAt(const Image& picture, int x, int y) { return 2.0 * glm::dvec2(at(picture, x, y)) - 1.0; }

/// Unit, towards the viewer.
glm::dvec3 viewAt(const RenderSettings& settings, const glm::dvec3& position)
{
    const glm::dvec4 viewer = settings.camera.viewer();
    return glm::normalize(glm::dvec3(viewer) - viewer.w * position);
}

} // namespace

TEST_F(PaintedMap, IsLookedUpWhereCoreSays)
{
    Renderer renderer;
    for (const SphereMapIndex index : {SphereMapIndex::Normal, SphereMapIndex::Reflection})
        for (const MapSpace space : {MapSpace::Eye, MapSpace::World})
            for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
                RenderSettings settings = view(GeometryKind::Torus);
                settings.camera.projection = projection;
                settings.material.paint.space = space;
                readPoints(settings);
                const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {places(index)}});
                const GeometryBuffers buffers = renderer.renderBuffers(settings);
                const glm::dmat3 turn =
                    space == MapSpace::Eye ? glm::dmat3(glm::transpose(settings.camera.cameraToWorld())) : glm::dmat3(1.0);
                int compared = 0;
                for (int y = 0; y < settings.height; ++y)
                    for (int x = 0; x < settings.width; ++x) {
                        if (buffers.normal.texel(x, y)[3] == 0.0f)
                            continue;
                        const glm::dvec3 n = turn * at(buffers.normal, x, y), v = turn * viewAt(settings, at(buffers.position, x, y));
                        const glm::dvec2 expected = discPlace(index, space, n, v);
                        const glm::dvec2 inside = glm::clamp(expected, -insideTheEdge, insideTheEdge);
                        ASSERT_LT(glm::distance(inside, placeAt(picture, x, y)), rounding) << x << ' ' << y;
                        ++compared;
                    }
                EXPECT_GT(compared, 3000);
            }
}

// Wherever a ball stands on the screen it shows the whole disc: its middle the middle, its outline the rim. Indexed by the plain normal
// the picture would slide by the angle under which the ball is seen, and its outline would lie inside the rim on one side.
TEST_F(PaintedMap, NeitherSlidesNorWarpsUnderPerspective)
{
    Renderer renderer;
    for (const float aside : {0.0f, 1.2f, -1.6f}) {
        RenderSettings settings = view(GeometryKind::Sphere);
        settings.geometry.level = 64;
        settings.width = 320;
        settings.camera = Camera{.distance = 5.0f, .fieldOfView = 1.2f, .target = {aside, 0.4f * aside, 0.0f}};
        readPoints(settings);
        const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {places(SphereMapIndex::Normal)}});
        const GeometryBuffers buffers = renderer.renderBuffers(settings);
        double farthest = 0.0, nearest = 1.0;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x) {
                if (buffers.normal.texel(x, y)[3] == 0.0f)
                    continue;
                const double c = glm::dot(at(buffers.normal, x, y), viewAt(settings, at(buffers.position, x, y)));
                const double radius = glm::length(placeAt(picture, x, y)), sine = std::sqrt(std::max(0.0, 1.0 - c * c));
                // Beside the map's four edges the outermost texel goes on.
                ASSERT_NEAR(radius, sine, sine < insideTheEdge ? rounding : 1.0 / 256 + rounding) << "the sine of the angle to the view";
                farthest = std::max(farthest, radius);
                nearest = std::min(nearest, radius);
            }
        // A ray under the angle d to the ball's middle passes it at 5 sin d, which is the place's radius. A pixel's middle is at most half
        // a diagonal away, and among the hundred along the outline one is closer to it than a third of a pixel.
        const double pixel = std::tan(0.6) / 60;
        EXPECT_GT(farthest, 1.0 - 5.0 * pixel / 3.0) << aside;
        EXPECT_LT(nearest, 5.0 * pixel * std::sqrt(0.5) + rounding) << aside;
    }
}

TEST_F(PaintedMap, InOrthographicViewsItIsThePlainForm)
{
    Renderer renderer;
    RenderSettings settings = view(GeometryKind::Teapot);
    settings.camera.projection = Projection::Orthographic;
    readPoints(settings);
    const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {places(SphereMapIndex::Normal)}});
    const GeometryBuffers buffers = renderer.renderBuffers(settings);
    const glm::dmat3 toCamera = glm::transpose(settings.camera.cameraToWorld());
    int compared = 0;
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
            if (const glm::dvec3 n = toCamera * at(buffers.normal, x, y); buffers.normal.texel(x, y)[3] != 0.0f && n.z > 0.0) {
                const glm::dvec2 inside = glm::clamp(glm::dvec2(n), -insideTheEdge, insideTheEdge);
                ASSERT_LT(glm::distance(placeAt(picture, x, y), inside), rounding) << x << ' ' << y;
                ++compared;
            }
    EXPECT_GT(compared, 1000);
}

// A hand-made map is averaged along the circle around the center over the pixel's footprint: the mean of an arc of the angle 2a lies inside
// the circle by the factor sin(a) / a, for lookups at n places sin(a) / (n sin(a / n)). A smooth ball, so that the footprint is the
// difference of the places of neighboring pixels.
TEST_F(PaintedMap, HandMadeLevelsAreAveragedAlongTheCircle)
{
    Renderer renderer;
    RenderSettings settings = view(GeometryKind::Sphere);
    settings.geometry.level = 64;
    settings.width = settings.height = 64;
    settings.camera = Camera{.distance = 3.0f, .projection = Projection::Orthographic};
    const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {placesByHand(SphereMapIndex::Normal)}});
    readPoints(settings);
    const Image points = renderer.renderRadiance(settings, {.sphereMaps = {places(SphereMapIndex::Normal)}});
    int compared = 0;
    double most = 0.0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::dvec2 p = placeAt(points, x, y);
            const double radius = glm::length(p);
            if (points.texel(x, y)[3] < 1.0f || radius > 0.9 || radius < 0.05)
                continue;
            const glm::dvec2 across(-p.y / radius, p.x / radius);
            const glm::dvec2 dx = placeAt(points, x | 1, y) - placeAt(points, x & ~1, y),
                             dy = placeAt(points, x, y | 1) - placeAt(points, x, y & ~1);
            const double width = std::hypot(glm::dot(across, dx), glm::dot(across, dy));
            const double shrinks = 1.0 - width * width / (24.0 * radius * radius); // of many lookups, to the fourth power of the angle
            // Few lookups shrink less, one not at all.
            const double seen = glm::length(placeAt(picture, x, y)) / radius;
            EXPECT_GT(seen, shrinks - 1e-3) << x << ' ' << y;
            EXPECT_LT(seen, 1.0 + 1e-4) << x << ' ' << y;
            most = std::max(most, 1.0 - seen);
            ++compared;
        }
    EXPECT_GT(compared, 500);
    EXPECT_GT(most, 1e-3) << "near the center an arc is long";
}

TEST_F(PaintedMap, MeetsTheSurfaceAsEachUseSays)
{
    Renderer renderer(TexelFormat::Float);
    const glm::dvec4 m(0.3, 0.1, 0.05, 0.5); // multiplied by its opacity
    const glm::dvec3 color(0.9, 0.6, 0.3), reflected(2.0);
    const double opacity = 0.75;
    const glm::dvec3 paint = opacity * glm::dvec3(m);
    const double a = opacity * m.w;
    const std::pair<std::optional<SphereMapUse>, glm::dvec3> cases[] = {{std::nullopt, reflected},
                                                                        {SphereMapUse::Replace, paint + (1.0 - a) * color},
                                                                        {SphereMapUse::Multiply, (paint + 1.0 - a) * color},
                                                                        {SphereMapUse::Over, paint + (1.0 - a) * reflected},
                                                                        {SphereMapUse::Tint, (paint + 1.0 - a) * reflected},
                                                                        {SphereMapUse::Add, paint + reflected}};
    for (const auto& [use, expected] : cases) {
        RenderSettings settings = view(GeometryKind::Sphere, use);
        settings.material.paint.color = color;
        settings.material.paint.opacity = float(opacity);
        const bool readsEnvironment = use != SphereMapUse::Replace && use != SphereMapUse::Multiply;
        EXPECT_EQ(neededMaps(settings).specular, readsEnvironment);
        RenderMaps maps{.sphereMaps = {plain(m)}};
        if (readsEnvironment)
            maps.specular = asLevels(environmentFrom({Parameterization::Cube, 8, 0}, [](const glm::dvec3&) { return glm::vec3(2.0f); }));
        EXPECT_LT(glm::distance(at(renderer.renderRadiance(settings, maps), 80, 60), expected), 1e-3) << (use ? wordOf(*use) : "none");
    }
}

TEST_F(PaintedMap, APatchedMapIsTheMapMadeAnew)
{
    Renderer renderer;
    const RenderSettings settings = view(GeometryKind::Sphere);
    const auto before = places(SphereMapIndex::Normal);
    SphereMapTexels changed = *before;
    Image patch(40, 30, 4);
    for (size_t i = 0; i < patch.texels.size(); ++i)
        patch.texels[i] = i % 4 == 3 ? 1.0f : 0.25f * float(i % 4);
    for (int y = 0; y < 30; ++y)
        std::copy_n(patch.texel(0, y), 160, changed.levels[0].texel(110, 100 + y));
    renderer.renderRadiance(settings, {.sphereMaps = {before}});
    renderer.patchSphereMap(patch, 110, 100, 0);
    const Image patched = renderer.renderRadiance(settings, {.sphereMaps = {before}});
    EXPECT_EQ(patched.texels, renderer.renderRadiance(settings, {.sphereMaps = {std::make_shared<const SphereMapTexels>(changed)}}).texels);
    EXPECT_THROW(renderer.patchSphereMap(patch, 240, 0, 0), InvalidArgument);
}

// 000 section 4: a ring of so many pixels in every level is a line of about as many pixels on the screen; a ring of the disc is wide where
// the surface is flat. Two rings of a tube seen from above: across the outline the curvature is that of the tube.
TEST_F(PaintedMap, AnAuthoredRingKeepsItsWidthWhateverTheCurvature)
{
    SphereMapDocument document;
    document.layers = {{.content = FillLayer{.color = glm::dvec3(1.0)}},
                       {.content = SilhouetteLayer{.width = 3.0, .unit = WidthUnit::Pixels}}};
    const auto authored =
        std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = evaluateLevels(document, 512), .hasAuthoredLevels = true});
    document.layers[1].content = SilhouetteLayer{.width = 0.05, .unit = WidthUnit::Disc};
    const auto ofTheDisc =
        std::make_shared<const SphereMapTexels>(SphereMapTexels{.levels = plainChain(evaluate(document, {.size = 512}))});

    Renderer renderer;
    const auto width = [&](const SphereMapChain& map, float tube) { // of the dark along a row, from the left outline inwards
        RenderSettings settings = view(GeometryKind::Torus);
        settings.width = settings.height = 401;
        settings.samples = 4;
        settings.background = {.kind = Backdrop::Color, .color = glm::vec3(1.0f)};
        settings.geometry.mesh = std::make_shared<const Mesh>(torusMesh(1.0f - tube, tube, 256, 128));
        settings.camera = Camera{.pitch = float(0.5 * pi), .distance = 4.0f, .fieldOfView = 0.5f, .projection = Projection::Orthographic};
        const Image picture = renderer.renderRadiance(settings, {.sphereMaps = {map}});
        const double pixels = 401.0 / (2.0 * 4.0 * std::tan(0.25)); // to a unit
        double sum = 0.0;
        for (int x = 0; x < 200 - int(pixels * (1.0f - tube)); ++x)
            sum += 1.0 - std::min(1.0f, picture.texel(x, 200)[0]);
        return sum;
    };
    const double flat = width(authored, 0.4f), middle = width(authored, 0.2f), curved = width(authored, 0.08f);
    const double discFlat = width(ofTheDisc, 0.4f), discCurved = width(ofTheDisc, 0.08f);
    RecordProperty("authored", std::to_string(flat) + " " + std::to_string(middle) + " " + std::to_string(curved));
    RecordProperty("disc", std::to_string(discFlat) + " " + std::to_string(discCurved));
    std::printf("authored %g %g %g, disc %g %g\n", flat, middle, curved, discFlat, discCurved);
    for (const double w : {flat, middle, curved})
        EXPECT_NEAR(w, 3.0, 1.0);
    EXPECT_NEAR(flat / curved, 1.0, 0.25);
    EXPECT_NEAR(discFlat / discCurved, 5.0, 1.5) << "as the radii of the tubes";
}

// Coordinates that are linear between vertices miss the curve of the true ones: by the square of the triangles' size (003 section 3.4.2).
TEST_F(PaintedMap, PlacesInterpolatedBetweenVerticesErrByTheSquareOfTheTrianglesSize)
{
    Renderer renderer;
    const SphereMapChain map = places(SphereMapIndex::Reflection);
    double previous = 0.0;
    std::printf("triangles   rms        max, of the disc's radius\n");
    for (const int level : {4, 8, 16, 32, 64}) {
        RenderSettings settings = view(GeometryKind::Sphere);
        settings.geometry.level = level;
        readPoints(settings);
        const Image exact = renderer.renderRadiance(settings, {.sphereMaps = {map}});
        settings.material.paint.lookup = LookupAt::Vertex;
        const Image interpolated = renderer.renderRadiance(settings, {.sphereMaps = {map}});
        double sum = 0.0, most = 0.0;
        int count = 0;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x)
                if (exact.texel(x, y)[3] == 1.0f && glm::length(placeAt(exact, x, y)) < 0.8) {
                    const glm::dvec2 away = placeAt(exact, x, y) - placeAt(interpolated, x, y);
                    sum += glm::dot(away, away);
                    most = std::max(most, glm::length(away));
                    ++count;
                }
        const double rms = std::sqrt(sum / count);
        std::printf("%9zu   %.2e   %.2e\n", sphereMesh(1.0f, level).indices.size() / 3, rms, most);
        if (level > 4) {
            EXPECT_NEAR(previous / rms, 4.0, 0.8) << level;
        }
        previous = rms;
    }
}

TEST_F(PaintedMap, FlecksOfTheShaderAreThoseOfCore)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
    std::vector<glm::vec4> inputs;
    for (int i = 0; i < 20000; ++i)
        inputs.emplace_back(coordinate(random), coordinate(random), coordinate(random), 0.0f);
    const Flecks flecks{.density = 0.4f, .size = 0.03f, .spread = 0.5f, .seed = 77};
    const auto evaluate = [&](const char* expression) {
        return evaluateGlsl(
            std::string("#include \"lib/flecks.glsl\"\nvec4 twin(vec4 x) { FleckPlace f = fleckPlace(x.xyz, flecks.x); return ") +
                expression + "; }",
            inputs, {}, [&](const ShaderProgram& program) { program.set("flecks", glm::vec4(0.4f, 0.03f, 0.5f, 77.0f)); });
    };
    const auto own = evaluate("vec4(f.own, f.border)"), neighbor = evaluate("vec4(f.neighbor, 0.0)");
    int differ = 0, count = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const FleckPlace expected = fleckPlace(glm::vec3(inputs[i]), flecks);
        count += expected.own.isFleck;
        EXPECT_LE(glm::length(expected.own.offset), 0.5001f);
        const bool same = glm::distance(glm::vec2(own[i]), expected.own.offset) < 1e-4f && (own[i].z == 1.0f) == expected.own.isFleck &&
                          glm::distance(glm::vec2(neighbor[i]), expected.neighbor.offset) < 1e-4f &&
                          std::abs(own[i].w - expected.border) < 1e-3f;
        differ += !same;
    }
    EXPECT_LE(differ, 10); // on borders the last digit decides between neighbors
    EXPECT_NEAR(double(count) / double(inputs.size()), 0.4, 0.02);
}

// Close by a fleck is one color; from afar, where a pixel holds many, it is their mean: on the whole no color changes with the distance,
// and pixels do not glitter.
TEST_F(PaintedMap, FlecksAreTheirMeanFromAfar)
{
    const auto halves = SphereMapTexels{.levels = plainChain(texelsFrom(128, SphereMapIndex::Normal, [](const glm::dvec2& p) {
                                                                 return glm::vec4(glm::vec3(p.x > 0.0 ? 1.0f : 0.0f), 1.0f);
                                                             }).levels[0])};
    const auto preset = [](const char* name) {
        return SphereMapTexels{.levels = plainChain(evaluate(findSphereMapPreset(name)->document, {.size = 256}))};
    };
    struct Case {
        const char* name;
        SphereMapTexels map;
        float density, spread;
    };
    Renderer renderer;
    for (const Case& c : {Case{"halves", halves, 1.0f, 0.6f}, Case{"car-paint", preset("car-paint"), 0.6f, 0.4f},
                          Case{"gold-leaf", preset("gold-leaf"), 1.0f, 0.4f}}) {
        const RenderMaps maps{.sphereMaps = {std::make_shared<const SphereMapTexels>(c.map)}};
        RenderSettings settings = view(GeometryKind::Sphere);
        settings.geometry.level = 48;
        settings.width = settings.height = 96;
        settings.camera = Camera{.distance = 3.0f, .projection = Projection::Orthographic};
        settings.material.paint.flecks = {.density = c.density, .size = 0.008f, .spread = c.spread};
        const Image far = renderer.renderRadiance(settings, maps);
        constexpr int factor = 16; // a pixel then is a quarter of a fleck
        RenderSettings close = settings;
        close.width = close.height = 96 * factor;
        glm::dvec3 farSum(0.0), nearSum(0.0);
        double glitter = 0.0;
        int count = 0;
        for (int seed = 0; seed < 4; ++seed) {
            close.material.paint.flecks.seed = seed;
            const Image near = renderer.renderRadiance(close, maps);
            for (int y = 0; y < 96; ++y)
                for (int x = 0; x < 96; ++x) {
                    if (std::hypot(x - 47.5, y - 47.5) > 36.0) // the ball's radius is 44; near its rim offsets lead past it
                        continue;
                    ++count;
                    farSum += at(far, x, y);
                    for (int j = 0; j < factor; ++j)
                        for (int i = 0; i < factor; ++i)
                            nearSum += at(near, factor * x + i, factor * y + j) / double(factor * factor);
                    glitter += std::abs(double(far.texel(x, y)[0]) - double(far.texel(x, y + 1)[0]));
                }
        }
        for (int k = 0; k < 3; ++k) // of some 160000 flecks
            EXPECT_NEAR(farSum[k] / count, nearSum[k] / count, 0.01) << c.name << ' ' << k;
        EXPECT_LT(glitter / count, 0.03) << c.name << ": what is left is the map's own slope";
    }
}
