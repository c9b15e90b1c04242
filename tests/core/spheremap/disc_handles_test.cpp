#include "core/sphere/sphere_map.h"
#include "core/spheremap/evaluation/disc_handles.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "core/spheremap/math/light_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

constexpr int size = 301;
constexpr double texel = 2.0 / size;

Image picture(std::vector<Layer> layers, SphereMapIndex index = SphereMapIndex::Normal)
{
    SphereMapDocument document;
    document.layers = std::move(layers);
    document.index = index;
    return evaluate(document, {.size = size});
}

glm::dvec2 placeOf(int x, int y) { return {(x + 0.5) * texel - 1.0, 1.0 - (y + 0.5) * texel}; }

glm::dvec3 colorAt(const Image& map, const glm::dvec2& q)
{
    const float* rgba = map.texel(std::clamp(static_cast<int>((q.x + 1.0) / texel), 0, size - 1),
                                  std::clamp(static_cast<int>((1.0 - q.y) / texel), 0, size - 1));
    return {rgba[0], rgba[1], rgba[2]};
}

/// The middle of the brightest texels inside the disc.
glm::dvec2 brightest(const Image& map)
{
    float most = -1.0f;
    glm::dvec2 sum(0.0);
    int count = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float value = map.texel(x, y)[0];
            if (glm::length(placeOf(x, y)) > 1.0 || value < most)
                continue;
            if (value > most) {
                most = value;
                sum = glm::dvec2(0.0);
                count = 0;
            }
            sum += placeOf(x, y);
            ++count;
        }
    return sum / static_cast<double>(count);
}

/// One of each kind, and of their variants.
std::vector<LayerContent> examples()
{
    std::vector<LayerContent> all;
    for (const LayerKind& kind : layerKinds())
        all.push_back(makeContent(kind.name));
    all.push_back(
        PhongLightsLayer{.lights = {{.azimuthDeg = -30.0, .polarDeg = 140.0}, {.polarDeg = 30.0, .intensity = 0.0, .diffuse = 1.0}}});
    all.push_back(ToonLayer{.highlightDeg = 0.0, .rim = 0.2});
    for (const GradientShape shape : {GradientShape::Radial, GradientShape::Linear, GradientShape::Angular, GradientShape::Shaded})
        all.push_back(GradientLayer{.shape = shape, .centerX = 0.1, .centerY = -0.2, .radius = 0.5});
    all.push_back(WindowLayer{.curvature = 0.0});
    all.push_back(SilhouetteLayer{.swell = 0.5});
    all.push_back(HatchingLayer{.tone = HatchingTone::Shade});
    all.push_back(ColorgramLayer{.source = ColorgramSource::Grating, .grooves = Grooves::Straight, .polarDeg = 40.0});
    all.push_back(ProbeLayer{.yawDeg = 150.0, .tiltDeg = 20.0});
    all.push_back(ProbeLayer{.lobe = ProbeLobe::Diffuse});
    all.push_back(ImageLayer{.turnDeg = 30.0, .flip = true});
    all.push_back(RotateLayer{.angleDeg = 30.0, .rightDeg = 120.0, .upDeg = -40.0});
    return all;
}

TEST(LightPlace, IsTheSphereMapsPlaceOfTheLight)
{
    for (double azimuth = -170.0; azimuth < 180.0; azimuth += 35.0)
        for (double polar = 5.0; polar < 180.0; polar += 12.5) {
            const glm::dvec2 q = highlightPlace({azimuth, polar});
            const glm::dvec2 mapped = sphere_map::discFromDirection(lightDirection(azimuth, polar));
            EXPECT_NEAR(glm::distance(q, mapped), 0.0, 1e-12) << azimuth << ' ' << polar;
            for (const LightAngles& back :
                 {lightOfHighlight(q), lightOfFacing(facingPlace({azimuth, polar})), lightAngles(lightDirection(azimuth, polar))}) {
                EXPECT_NEAR(back.azimuthDeg, azimuth, 1e-6);
                EXPECT_NEAR(back.polarDeg, polar, 1e-6);
            }
        }
}

TEST(DiscHandles, LieWithinATexelOfTheHighlightEvenOfLightsBehind)
{
    for (const SphereMapIndex index : {SphereMapIndex::Normal, SphereMapIndex::Reflection})
        for (const PhongModel model : {PhongModel::RV, PhongModel::NH})
            for (const auto& [azimuth, polar] : {std::pair{125.0, 50.0}, {0.0, 0.0}, {-40.0, 90.0}, {200.0, 150.0}, {300.0, 120.0}}) {
                const PhongLightsLayer layer{.lights = {{.azimuthDeg = azimuth, .polarDeg = polar, .exponent = 400.0}}, .model = model};
                const std::vector<DiscHandle> handles = discHandles(layer);
                ASSERT_EQ(handles.size(), 1u);
                EXPECT_LT(glm::distance(brightest(picture({{.content = layer}}, index)), handles[0].place), texel)
                    << azimuth << ' ' << polar;
            }
}

TEST(DiscHandles, LieWhereTheSurfaceFacesALightThatOnlyShades)
{
    const GradientLayer shaded{
        .shape = GradientShape::Shaded, .stops = {{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}}, .mixing = ColorMixing::Linear};
    const PhongLightsLayer matt{.lights = {{.intensity = 0.0, .diffuse = 1.0}}};
    EXPECT_LT(glm::distance(brightest(picture({{.content = shaded}})), discHandles(shaded)[0].place),
              2.0 * texel); // a flat top, in steps of a table
    EXPECT_LT(glm::distance(brightest(picture({{.content = matt}})), discHandles(matt)[0].place), texel);
    const glm::dvec2 behind = discHandles(GradientLayer{.polarDeg = 120.0})[0].place;
    EXPECT_NEAR(glm::length(behind), 2.0 - std::sqrt(0.75), 1e-12);
}

TEST(DiscHandles, LieOnAToonsHighlight)
{
    const ToonLayer toon{.shadeColor = glm::dvec3(0.0), .lightColor = glm::dvec3(0.5), .highlightDeg = 1.0};
    EXPECT_LT(glm::distance(brightest(picture({{.content = toon}})), discHandles(toon)[0].place),
              1.5 * texel); // the middle of a small flat spot
}

TEST(DiscHandles, LieWhereRotateTakesTheCenter)
{
    const Layer spot{.content = PhongLightsLayer{.lights = {{.polarDeg = 0.0, .exponent = 200.0}}}};
    for (const RotateLayer& turn :
         {RotateLayer{.angleDeg = 50.0, .rightDeg = 30.0, .upDeg = -20.0}, RotateLayer{.rightDeg = -60.0, .upDeg = 25.0}})
        EXPECT_LT(glm::distance(brightest(picture({spot, {.content = turn}})), discHandles(turn)[0].place), texel);
}

/// The probe's middle, +Z, is what an unturned probe shows at the center.
TEST(DiscHandles, LieWhereAProbesMiddleIsMirrored)
{
    const ProbeLayer plain{.source = "builtin:sky", .lobe = ProbeLobe::Phong, .exponent = 20.0};
    const glm::dvec3 middle = colorAt(picture({{.content = plain}}), {0.0, 0.0});
    for (const auto& [yaw, tilt] : {std::pair{40.0, 0.0}, {0.0, 50.0}, {-70.0, -35.0}, {130.0, 20.0}})
        for (const ProbeLobe lobe : {ProbeLobe::Phong, ProbeLobe::Diffuse}) {
            ProbeLayer turned = plain, still = plain;
            turned.yawDeg = yaw;
            turned.tiltDeg = tilt;
            turned.lobe = still.lobe = lobe;
            const glm::dvec2 place = discHandles(turned)[0].place;
            if (glm::length(place) > 0.97)
                continue; // on the ball's back, or at the rim
            const glm::dvec3 found = colorAt(picture({{.content = turned}}), place);
            const glm::dvec3 expected = lobe == ProbeLobe::Phong ? middle : colorAt(picture({{.content = still}}), {0.0, 0.0});
            for (int c = 0; c < 3; ++c) // a texel's step on a probe without seams near its middle
                EXPECT_NEAR(found[c], expected[c], 0.02 * expected[c]) << yaw << ' ' << tilt;
        }
}

TEST(DiscHandles, LieOnTheWindowsFrame)
{
    for (const double curvature : {0.0, 0.4, 1.0}) {
        const WindowLayer window{.centerX = 0.3, .centerY = -0.25, .curvature = curvature};
        for (const glm::dvec2 uv : {glm::dvec2(0.0), {0.25, -0.35}, {-0.2, 0.3}, {0.0, 0.5}}) {
            const glm::dvec2 found = windowCoordinates(window, windowPlace(window, uv));
            EXPECT_NEAR(glm::distance(found, uv), 0.0, 1e-7) << curvature;
        }
        // Just inside the corner there is frame, just outside there is nothing.
        const Image map = picture({{.content = window}});
        const auto opacity = [&](const glm::dvec2& uv) {
            const glm::dvec2 q = windowPlace(window, uv);
            return map.texel(static_cast<int>((q.x + 1.0) / texel), static_cast<int>((1.0 - q.y) / texel))[3];
        };
        EXPECT_GT(opacity({0.25, -0.35}), 0.9f) << curvature;
        EXPECT_LT(opacity({0.31, -0.41}), 0.1f) << curvature;
    }
}

TEST(DiscHandles, MovedToWhereTheyAreChangeNothing)
{
    for (const LayerContent& content : examples()) {
        const std::vector<DiscHandle> handles = discHandles(content);
        for (size_t i = 0; i < handles.size(); ++i) {
            LayerContent moved = content;
            moveHandle(moved, i, handles[i].place);
            const std::vector<DiscHandle> after = discHandles(moved);
            ASSERT_EQ(after.size(), handles.size());
            for (size_t k = 0; k < after.size(); ++k)
                EXPECT_NEAR(glm::distance(after[k].place, handles[k].place), 0.0, 4e-4)
                    << kindOf(content).name << ' ' << i << ' ' << k; // values are rounded
            for (size_t k = 0; k < handles[i].values.size(); ++k)
                EXPECT_NEAR(after[i].values[k].value, handles[i].values[k].value, 0.011)
                    << kindOf(content).name << ' ' << handles[i].values[k].field;
        }
    }
}

TEST(DiscHandles, GoWhereTheyAreDragged)
{
    for (const LayerContent& content : examples())
        for (size_t i = 0; i < discHandles(content).size(); ++i)
            for (const glm::dvec2 wanted : {glm::dvec2(0.4, 0.3), {-0.35, 0.2}, {0.1, -0.6}}) {
                LayerContent moved = content;
                for (int steps = 0; steps < 3; ++steps) // as a drag does, again and again
                    moveHandle(moved, i, wanted);
                checkFields("layer", moved);
                const DiscHandle handle = discHandles(moved)[i];
                if (handle.values.size() == 2 && handle.kind != HandleKind::Corner && kindOf(content).name != "twist") {
                    EXPECT_LT(glm::distance(handle.place, wanted), 1e-3) << kindOf(content).name << ' ' << i;
                } else if (handle.kind == HandleKind::Ring) {
                    EXPECT_NEAR(glm::distance(handle.place, handle.from), glm::distance(wanted, handle.from), 1e-3) << kindOf(content).name;
                } else if (handle.kind == HandleKind::Arm) { // looks there; a window's arm is bent
                    const double off = angleOf(handle.place - handle.from) - angleOf(wanted - handle.from);
                    EXPECT_NEAR(std::remainder(off, 360.0), 0.0, kindOf(content).name == "window" ? 20.0 : 0.02) << kindOf(content).name;
                }
            }
}

TEST(DiscHandles, TurnOnAndOnWithoutALeap)
{
    LayerContent twist = TwistLayer{.angleDeg = 350.0, .radius = 0.8};
    for (int degrees = 350; degrees <= 700; degrees += 10)
        moveHandle(twist, 0, polarPlace(0.8, degrees));
    EXPECT_NEAR(std::get<TwistLayer>(twist).angleDeg, 700.0, 0.01);
    LayerContent light = PhongLightsLayer{.lights = {{.azimuthDeg = 350.0, .polarDeg = 60.0}}};
    for (int degrees = 350; degrees <= 420; degrees += 10) {
        moveHandle(light, 0, polarPlace(0.5, degrees));
        checkFields("layer", light); // azimuths end at 360
    }
    EXPECT_NEAR(std::get<PhongLightsLayer>(light).lights[0].azimuthDeg, 60.0, 0.01);
}

TEST(DiscHandles, KeepTheOtherEndOfALinearGradient)
{
    LayerContent content = GradientLayer{.shape = GradientShape::Linear};
    const glm::dvec2 start = discHandles(content)[0].place;
    for (int i = 0; i <= 50; ++i)
        moveHandle(content, 1, {0.6 - 0.01 * i, 0.01 * i});
    EXPECT_LT(glm::distance(discHandles(content)[0].place, start), 2e-3); // fifty roundings
    EXPECT_LT(glm::distance(discHandles(content)[1].place, {0.1, 0.5}), 1e-3);
}

TEST(DiscHandles, AddAndRemoveLights)
{
    LayerContent content = PhongLightsLayer{.lights = {{.exponent = 7.0}}};
    EXPECT_EQ(addLight(content, {0.5, 0.0}, 0), 1);
    const PhongLight& added = std::get<PhongLightsLayer>(content).lights[1];
    EXPECT_EQ(added.exponent, 7.0);
    EXPECT_NEAR(added.azimuthDeg, 0.0, 1e-9);
    EXPECT_NEAR(added.polarDeg, 60.0, 1e-9); // sin 30 degrees
    removeLight(content, 0);
    EXPECT_NEAR(discHandles(content)[0].place.x, 0.5, 1e-4);
    std::get<PhongLightsLayer>(content).lights.resize(64);
    EXPECT_FALSE(addLight(content, {0.0, 0.0}, std::nullopt));
    LayerContent fill = FillLayer{};
    EXPECT_FALSE(holdsLights(fill));
    EXPECT_FALSE(addLight(fill, {0.0, 0.0}, std::nullopt));
}

} // namespace
} // namespace mirrorball
