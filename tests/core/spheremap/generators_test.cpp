#include "core/base/error.h"
#include "core/image/builtin_probes.h"
#include "core/image/image_io.h"
#include "core/sphere/sphere_map.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "core/spheremap/math/light_direction.h"
#include "support/exr_builders.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace mirrorball {
namespace {

const Layer white{.content = FillLayer{{1.0, 1.0, 1.0}}};

Image picture(std::vector<Layer> layers, int size, SphereMapIndex index = SphereMapIndex::Normal)
{
    SphereMapDocument document;
    document.layers = std::move(layers);
    document.index = index;
    return evaluate(document, {.size = size});
}

/// The normal of a texel's center.
glm::dvec3 normalAt(int size, int x, int y)
{
    const glm::dvec2 q((x + 0.5) * 2.0 / size - 1.0, 1.0 - (y + 0.5) * 2.0 / size);
    return {q, std::sqrt(std::max(1.0 - glm::dot(q, q), 0.0))};
}

bool inDisc(int size, int x, int y) { return normalAt(size, x, y).z > 0.0; }

TEST(WindowLayer, HasItsPanesAndBars)
{
    const WindowLayer window{.columns = 3,
                             .rows = 2,
                             .width = 1.2,
                             .height = 0.8,
                             .frame = 0.1,
                             .centerX = 0.0,
                             .centerY = 0.0,
                             .tiltDeg = 0.0,
                             .curvature = 0.0,
                             .frameOpacity = 0.0};
    const Image map = picture({{.content = window}}, 400);
    const auto runs = [&](bool alongRow, int line) {
        int count = 0;
        for (int i = 1; i < 400; ++i) {
            const float before = alongRow ? map.texel(i - 1, line)[3] : map.texel(line, i - 1)[3];
            const float here = alongRow ? map.texel(i, line)[3] : map.texel(line, i)[3];
            count += before < 0.5f && here >= 0.5f;
        }
        return count;
    };
    EXPECT_EQ(runs(true, 200 - 40), 3); // through the upper panes, 0.2 up
    EXPECT_EQ(runs(false, 200), 2);     // through the middle pane
    EXPECT_EQ(runs(true, 200), 0);      // along the middle bar
    // Open area of the panes: (1.2 - 3 * 0.1)(0.8 - 2 * 0.1) of a disc radius squared, in texels of 1/200.
    double area = 0.0;
    for (size_t i = 3; i < map.texels.size(); i += 4)
        area += map.texels[i];
    EXPECT_NEAR(area / (200.0 * 200.0), 0.9 * 0.6, 1e-3);
}

TEST(WindowLayer, BarsBendOutwardsAsInAMirrorBall)
{
    const WindowLayer window{.columns = 1,
                             .rows = 1,
                             .width = 1.2,
                             .height = 1.2,
                             .frame = 0.0,
                             .centerX = 0.0,
                             .centerY = 0.0,
                             .tiltDeg = 0.0,
                             .curvature = 1.0};
    const Image map = picture({{.content = window}}, 400);
    const auto halfWidth = [&](int row) {
        int x = 200;
        while (map.texel(x, row)[3] > 0.5f)
            ++x;
        return (x - 200) / 200.0;
    };
    // u = x/z = 0.6 is the ellipse x^2 (1 + 1/0.36) + y^2 = 1.
    EXPECT_NEAR(halfWidth(200), std::sqrt(1.0 / (1.0 + 1.0 / 0.36)), 0.006);
    EXPECT_NEAR(halfWidth(200 - 80), std::sqrt((1.0 - 0.16) / (1.0 + 1.0 / 0.36)), 0.006);
}

TEST(ColdWarmLayer, IsHalfAndHalfOnTheDividingLine)
{
    const ColdWarmLayer layer{.coldColor = glm::dvec3(0.0), .warmColor = glm::dvec3(1.0), .angleDeg = 0.0, .blur = 0.2, .highlight = 0.0};
    const Image map = picture({{.content = layer}}, 200);
    EXPECT_NEAR(0.5f * (map.texel(99, 100)[0] + map.texel(100, 100)[0]), 0.5f, 1e-4f);
    // One standard deviation to the right: Phi(1) = 0.8413.
    EXPECT_NEAR(0.5f * (map.texel(119, 100)[0] + map.texel(120, 100)[0]), 0.8413f, 1e-3f);
    EXPECT_LT(map.texel(5, 100)[0], 1e-4f);
}

TEST(HatchingLayer, CoversAsMuchAsItsLinesAreWideAtAnySize)
{
    // From tone 0 on and at once at full width: straight lines that cover 0.3 of the disc, finer than texels or coarser.
    const HatchingLayer lines{
        .density = 40.0, .angleDeg = 30.0, .width = 0.3, .curvature = 0.0, .from = 0.0, .to = 1e-4, .cross = false, .jitter = 0.0};
    for (const int size : {32, 64, 256, 1000}) {
        const Image map = picture({{.content = lines}}, size);
        double sum = 0.0, count = 0.0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (inDisc(size, x, y)) {
                    sum += map.texel(x, y)[3];
                    ++count;
                }
        EXPECT_NEAR(sum / count, 0.3, 0.01) << size;
    }
}

TEST(HatchingLayer, DrawsTheSameForOneSeedAndOtherwiseForAnother)
{
    const HatchingLayer one{.seed = 1}, two{.seed = 2};
    EXPECT_EQ(picture({{.content = one}}, 64), picture({{.content = one}}, 64));
    EXPECT_NE(picture({{.content = one}}, 64), picture({{.content = two}}, 64));
    EXPECT_EQ(picture({{.content = one}}, 64).texel(32, 32)[3], 0.0f); // no lines where the tone is below `from`
}

TEST(ToonLayer, HasAsManyTonesAsCountedWithTheirEdgesByTheLight)
{
    const ToonLayer toon{.count = 4, .shadeEnd = 0.4, .azimuthDeg = 0.0, .polarDeg = 90.0, .highlightDeg = 0.0};
    const Image map = picture({{.content = toon}}, 500);
    std::set<float> tones;
    for (int x = 1; x < 499; ++x) // the flat parts only: where neighbors agree
        if (map.texel(x, 250)[0] == map.texel(x - 1, 250)[0] && map.texel(x, 250)[0] == map.texel(x + 1, 250)[0])
            tones.insert(map.texel(x, 250)[0]);
    EXPECT_EQ(tones.size(), 4u);
    // The light is at the right: t = (x + 1)/2, and the first edge lies at t = 0.4, x = -0.2.
    EXPECT_EQ(map.texel(195, 250)[0], map.texel(2, 250)[0]);
    EXPECT_NE(map.texel(205, 250)[0], map.texel(2, 250)[0]);
}

TEST(ColorgramLayer, IsWhiteInTheCenterAndTwistTellsLeftFromRight)
{
    ColorgramLayer layer{.arcs = 0, .twistDeg = 0.0, .center = 0.3, .centerSoftness = 0.1};
    const Image rings = picture({{.content = layer}}, 101);
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(rings.texel(50, 50)[c], 1.0f);
    EXPECT_NEAR(rings.texel(90, 50)[1], rings.texel(50, 10)[1], 1e-5f); // the same all around
    layer.arcs = 1;
    layer.ripple = 0.3;
    const Image arcs = picture({{.content = layer}}, 101);
    EXPECT_NEAR(arcs.texel(70, 80)[0], arcs.texel(70, 20)[0], 1e-4f); // mirrored in the horizontal axis ...
    layer.twistDeg = 90.0;
    const Image twisted = picture({{.content = layer}}, 101);
    EXPECT_GT(std::abs(twisted.texel(70, 80)[0] - twisted.texel(70, 20)[0]) + std::abs(twisted.texel(70, 80)[2] - twisted.texel(70, 20)[2]),
              0.05f);
}

TEST(ColorgramLayer, GratingsShowTheWavelengthOfThePathDifference)
{
    // A light at the eye: lambda = 2 pitch rho in the first order. With 700 nm there is no other order of visible light below 760 nm.
    const ColorgramLayer layer{
        .source = ColorgramSource::Grating, .center = 0.01, .strength = 1.0, .pitch = 700.0, .orders = 1, .spread = 0.005};
    const int size = 1400;
    const Image map = picture({{.content = layer}}, size);
    const auto at = [&](double wavelength) { return map.texel(size / 2 + static_cast<int>(wavelength / 1400.0 * size / 2), size / 2); };
    EXPECT_GT(at(450)[2], 2.0f * at(450)[1]);               // blue
    EXPECT_GT(at(530)[1], 2.0f * at(530)[0]);               // green
    EXPECT_GT(at(640)[0], 4.0f * at(640)[1]);               // red
    EXPECT_LT(at(300)[0] + at(300)[1] + at(300)[2], 0.02f); // ultraviolet
    EXPECT_LT(at(900)[0] + at(900)[1] + at(900)[2], 0.02f); // infrared
}

TEST(PhongLights, FollowTheMirrorDirection)
{
    const PhongLightsLayer layer{.lights = {{.azimuthDeg = 40.0, .polarDeg = 70.0, .exponent = 12.5}}};
    const Image map = picture({{.content = layer}}, 64);
    const glm::dvec3 l = lightDirection(40.0, 70.0);
    for (const auto& [x, y] : {std::pair{40, 20}, {32, 32}, {50, 30}, {10, 40}}) {
        const double rl = glm::dot(mirrorDirection({0, 0, 1}, normalAt(64, x, y)), l);
        EXPECT_NEAR(map.texel(x, y)[0], rl > 0.0 ? std::pow(rl, 12.5) : 0.0, 2e-5);
    }
}

TEST(PhongLights, MatchedExponentsMakeBothModelsAlike)
{
    EXPECT_NEAR(matchedExponent(30.0, 1.0), 120.0, 1e-9); // the limit: beta is half of alpha, cos^n is exp(-n alpha^2/2)
    EXPECT_NEAR(matchedExponent(30.0, std::cos(1e-5)), 120.0, 1e-5);
    const double beta = 0.3; // 003's relation is this equality
    EXPECT_NEAR(std::pow(std::cos(beta), matchedExponent(7.0, std::cos(beta))), std::pow(std::cos(2.0 * beta), 7.0), 1e-12);
    PhongLightsLayer layer{.lights = {{.azimuthDeg = 0.0, .polarDeg = 0.0, .exponent = 40.0}}};
    const Image rv = picture({{.content = layer}}, 128);
    layer.model = PhongModel::NH;
    const Image nh = picture({{.content = layer}}, 128);
    for (size_t i = 0; i < rv.texels.size(); i += 4) // equal at the center and at one half; between and beyond they part a little
        ASSERT_NEAR(rv.texels[i], nh.texels[i], 0.01f);
}

TEST(PhongLights, ALightRightBehindHasNoHighlight)
{
    const PhongLightsLayer behind{.lights = {{.polarDeg = 180.0, .exponent = 20.0}}, .model = PhongModel::NH, .ambient = glm::dvec3(0.0)};
    const ToonLayer toon{.polarDeg = 180.0, .highlightDeg = 20.0, .highlightColor = glm::dvec3(0.0, 90.0, 0.0)};
    const Image phongMap = picture({{.content = behind}}, 64), toonMap = picture({{.content = toon}}, 64);
    for (size_t i = 0; i < phongMap.texels.size(); i += 4) {
        ASSERT_EQ(phongMap.texels[i], 0.0f);
        ASSERT_LT(toonMap.texels[i + 1], 10.0f);
    }
}

TEST(PhongLights, AMinersHatShinesInTheMiddle)
{
    const PhongLightsLayer layer{.lights = {{.polarDeg = 0.0, .exponent = 20.0}}};
    const Image map = picture({{.content = layer}}, 65);
    EXPECT_NEAR(map.texel(32, 32)[0], 1.0f, 1e-5f);
    EXPECT_NEAR(map.texel(40, 32)[0], map.texel(32, 24)[0], 1e-5f);
    EXPECT_GT(map.texel(32, 32)[0], map.texel(40, 32)[0]);
}

TEST(ImageLayer, ShowsAPictureAsItIsAtItsOwnSize)
{
    const test::TemporaryFolder folder;
    const Image ball = test::smallIntegerImage(32, 32);
    writeImage(folder / "ball.exr", ball);
    SphereMapDocument document;
    document.folder = folder.path();
    document.layers = {{.content = ImageLayer{.source = "ball.exr", .inset = 0.0}}};
    const Image map = evaluate(document, {.size = 32});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            if (!inDisc(32, x, y))
                continue;
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(map.texel(x, y)[c], ball.texel(x, y)[c], 2e-5f * std::max(1.0f, ball.texel(x, y)[c])) << x << ' ' << y;
        }
    EXPECT_EQ(map.texel(0, 0)[3], 1.0f);
}

TEST(ImageLayer, TintsTheDiffusePassOfABlenderMatcapAndAddsTheSpecularOne)
{
    const test::TemporaryFolder folder;
    for (const std::string prefix : {"", "ViewLayer."}) {
        std::vector<test::ExrChannel> channels;
        for (const auto& [pass, value] : {std::pair{"diffuse", 0.5f}, {"specular", 0.25f}})
            for (const char* letter : {"R", "G", "B"})
                channels.push_back({prefix + pass + "." + letter, std::vector<float>(16 * 16, value)});
        test::writeScanlineExr(folder / "two.exr", test::exrHeader(16, 16, channels, Imf::FLOAT), channels);
        const auto value = [&](ImagePass pass) {
            return picture({{.content = ImageLayer{.source = (folder / "two.exr").string(), .pass = pass, .tint = {1.0, 0.5, 0.0}}}}, 8);
        };
        EXPECT_FLOAT_EQ(value(ImagePass::All).texel(4, 4)[0], 0.75f);
        EXPECT_FLOAT_EQ(value(ImagePass::All).texel(4, 4)[1], 0.5f);
        EXPECT_FLOAT_EQ(value(ImagePass::All).texel(4, 4)[2], 0.25f);
        EXPECT_FLOAT_EQ(value(ImagePass::Diffuse).texel(4, 4)[1], 0.25f);
        EXPECT_FLOAT_EQ(value(ImagePass::Specular).texel(4, 4)[1], 0.25f);
    }
}

TEST(ImageLayer, RefusesWhatIsNoBallAndNamesTheFile)
{
    const test::TemporaryFolder folder;
    writeImage(folder / "wide.exr", Image(8, 4));
    for (const char* name : {"wide.exr", "missing.exr"})
        try {
            picture({{.content = ImageLayer{.source = (folder / name).string()}}}, 8);
            ADD_FAILURE();
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
    EXPECT_THROW(picture({{.content = ImageLayer{}}}, 8), InvalidArgument);
}

TEST(ImageLayer, ReadsRealMatcaps)
{
    const std::filesystem::path folder = std::filesystem::path(MIRRORBALL_SHARED_DATA) / "matcaps";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no ../shared/data/matcaps";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".exr" && entry.path().extension() != ".png")
            continue;
        const Image map = picture({{.content = ImageLayer{.source = entry.path().string()}}}, 128);
        double sum = 0.0;
        for (const float value : map.texels) {
            ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << entry.path();
            sum += value;
        }
        EXPECT_GT(sum / static_cast<double>(map.texels.size()), 0.01) << entry.path();
    }
}

TEST(ProbeLayer, AConstantProbeShowsTheFresnelTerm)
{
    const test::TemporaryFolder folder;
    writeImage(folder / "white.exr", Image(64, 32, 3, 1.0f));
    for (const ProbeLobe lobe : {ProbeLobe::Mirror, ProbeLobe::Phong, ProbeLobe::Ggx, ProbeLobe::Diffuse}) {
        ProbeLayer layer{.source = (folder / "white.exr").string(), .lobe = lobe, .fresnel = FresnelKind::Dielectric, .index = 1.5};
        const Image mirrored = picture({{.content = layer}}, 64);
        layer.share = FresnelShare::Transmitted;
        const Image transmitted = picture({{.content = layer}}, 64);
        for (const int x : {32, 45, 60}) {
            const double f = fresnelDielectric(normalAt(64, x, 32).z, 1.5);
            EXPECT_NEAR(mirrored.texel(x, 32)[1], f, 2e-3) << x;
            EXPECT_NEAR(transmitted.texel(x, 32)[1], 1.0 - f, 2e-3) << x;
        }
    }
}

TEST(ProbeLayer, MirrorsTheProbeAsASphereMapDoes)
{
    const EnvironmentMap sky = renderBuiltinProbe("studio");
    const Image map = picture({{.content = ProbeLayer{.source = "builtin:studio", .lobe = ProbeLobe::Diffuse}}}, 64);
    // The diffuse lobe is smooth: compare with the mean radiance over the hemisphere of the normal, weighted by its cosine.
    for (const auto& [x, y] : {std::pair{32, 32}, {16, 20}, {44, 50}}) {
        const glm::dvec3 n = normalAt(64, x, y);
        glm::dvec3 sum(0.0);
        double weights = 0.0;
        for (int ty = 0; ty < sky.image.height; ty += 2)
            for (int tx = 0; tx < sky.image.width; tx += 2) {
                const double w = std::max(glm::dot(texelDirection(sky.layout, tx, ty), n), 0.0) * texelSolidAngle(sky.layout, tx, ty);
                const float* rgb = sky.image.texel(tx, ty);
                sum += w * glm::dvec3(rgb[0], rgb[1], rgb[2]);
                weights += w;
            }
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(map.texel(x, y)[c], sum[c] / weights, 0.02 * sum[c] / weights);
    }
    const Image mirror = picture({{.content = ProbeLayer{.source = "builtin:cube-room", .lobe = ProbeLobe::Mirror}}}, 256);
    const BuiltinProbe& room = builtinProbe("cube-room");
    for (const auto& [x, y] : {std::pair{128, 128}, {40, 128}, {128, 40}, {220, 120}}) {
        const glm::dvec3 expected = room.radiance(mirrorDirection({0, 0, 1}, normalAt(256, x, y)));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(mirror.texel(x, y)[c], expected[c], 0.02) << x << ' ' << y;
    }
}

/// A quarter turn about +X takes +Y to +Z and -Z to +Y, so that the mirror direction (x, y, z) reads the probe at (x, z, -y).
TEST(ProbeLayer, ATiltBringsWhatIsAboveTowardsTheEye)
{
    const Image tipped = picture({{.content = ProbeLayer{.source = "builtin:cube-room", .tiltDeg = 90.0, .lobe = ProbeLobe::Mirror}}}, 256);
    const BuiltinProbe& room = builtinProbe("cube-room");
    for (const auto& [x, y] : {std::pair{128, 128}, {40, 128}, {128, 40}, {128, 220}, {220, 120}}) {
        const glm::dvec3 d = mirrorDirection({0, 0, 1}, normalAt(256, x, y));
        const glm::dvec3 expected = room.radiance({d.x, d.z, -d.y});
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(tipped.texel(x, y)[c], expected[c], 0.02) << x << ' ' << y;
    }
}

TEST(ProbeLayer, UnknownMetalsAndProbesAreRefusedByName)
{
    EXPECT_THROW(picture({{.content = ProbeLayer{.fresnel = FresnelKind::Conductor, .metal = "unobtainium"}}}, 8), InvalidArgument);
    EXPECT_THROW(picture({{.content = ProbeLayer{.source = "builtin:nowhere"}}}, 8), InvalidArgument);
}

/// 2048 averaged down to 512 against 512, rms over the rms of the map, where the map of 512 has no hard edge: neighbors differ by less
/// than a twentieth of its peak.
double resolutionDependence(const SphereMapDocument& document)
{
    const auto assets = std::make_shared<SphereMapAssets>();
    const std::vector<Image> fine = plainChain(evaluate(document, {.size = 2048, .assets = assets}));
    const Image coarse = evaluate(document, {.size = 512, .assets = assets});
    const float peak = *std::max_element(coarse.texels.begin(), coarse.texels.end());
    double difference = 0.0, square = 0.0;
    for (int y = 1; y < 511; ++y)
        for (int x = 1; x < 511; ++x)
            for (int c = 0; c < 4; ++c) {
                float low = coarse.texel(x, y)[c], high = low;
                for (int k = -1; k <= 1; ++k)
                    for (int j = -1; j <= 1; ++j) {
                        low = std::min(low, coarse.texel(x + k, y + j)[c]);
                        high = std::max(high, coarse.texel(x + k, y + j)[c]);
                    }
                const double a = fine[2].texel(x, y)[c], b = coarse.texel(x, y)[c];
                square += b * b;
                if (high - low < 0.05f * peak)
                    difference += (a - b) * (a - b);
            }
    return std::sqrt(difference / square);
}

TEST(SphereMaps, LookTheSameAtEverySizeAwayFromHardEdges)
{
    for (const LayerKind& kind : layerKinds()) {
        if (kind.name == "image" || kind.name == "paint")
            continue; // a file's own size; strokes have tests of their own
        SphereMapDocument document;
        document.layers = {white, {.content = GradientLayer{}}, {.content = makeContent(kind.name)}};
        EXPECT_LT(resolutionDependence(document), 0.01) << kind.name;
    }
}

} // namespace
} // namespace mirrorball
