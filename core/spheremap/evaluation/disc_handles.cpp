#include "disc_handles.h"

#include "core/spheremap/math/light_place.h"

#include <algorithm>
#include <functional>
#include <type_traits>
#include <utility>

namespace mirrorball {

namespace {

constexpr double inwards = 0.85; ///< of the rim: where arms end that turn the whole disc

/// A handle and what dragging it does.
template <typename Layer>
struct Grip {
    DiscHandle handle{};
    std::function<void(Layer&, const glm::dvec2& wanted)> move{};
};
template <typename Layer>
using Grips = std::vector<Grip<Layer>>;

double rounded(double place) { return std::round(place * 1e4) / 1e4; }

/// The angle that means the same and is nearest to the present one, so that a drag does not leap from 180 to -180.
double nearestTurn(double degrees, double present)
{
    return std::round((degrees + 360.0 * std::round((present - degrees) / 360.0)) * 100.0) / 100.0;
}
/// The same for fields that end at 360 degrees either way.
double turned(double degrees, double present)
{
    const double angle = nearestTurn(degrees, present);
    return angle > 360.0 ? angle - 360.0 : angle < -360.0 ? angle + 360.0 : angle;
}

HandleValue degrees(std::string_view field, double value) { return {field, value, "degrees"}; }

/// What of a light is seen: its highlight, or the side that faces it.
enum class Shows { Highlight, Facing };

glm::dvec2 lightPlace(Shows shows, double azimuthDeg, double polarDeg)
{
    return shows == Shows::Highlight ? highlightPlace({azimuthDeg, polarDeg}) : facingPlace({azimuthDeg, polarDeg});
}

void setLight(Shows shows, double& azimuthDeg, double& polarDeg, const glm::dvec2& wanted)
{
    const LightAngles light = shows == Shows::Highlight ? lightOfHighlight(wanted) : lightOfFacing(wanted);
    azimuthDeg = turned(light.azimuthDeg, azimuthDeg);
    polarDeg = std::round(light.polarDeg * 100.0) / 100.0;
}

/// A layer's one light, in its fields azimuthDeg and polarDeg.
template <typename Layer>
Grip<Layer> lightGrip(const Layer& layer, Shows shows, std::optional<glm::dvec3> color)
{
    return {{.kind = HandleKind::Light,
             .place = lightPlace(shows, layer.azimuthDeg, layer.polarDeg),
             .color = color,
             .values = {degrees("azimuth", layer.azimuthDeg), degrees("polar", layer.polarDeg)}},
            [shows](Layer& changed, const glm::dvec2& wanted) { setLight(shows, changed.azimuthDeg, changed.polarDeg, wanted); }};
}

template <typename Layer>
Grip<Layer> centerGrip(const Layer& layer)
{
    return {{.kind = HandleKind::Place,
             .place = {layer.centerX, layer.centerY},
             .values = {{"center-x", layer.centerX}, {"center-y", layer.centerY}}},
            [](Layer& changed, const glm::dvec2& wanted) {
                changed.centerX = rounded(wanted.x);
                changed.centerY = rounded(wanted.y);
            }};
}

/// An arm that turns one angle.
template <typename Layer>
Grip<Layer> armGrip(const Layer& layer, std::string_view field, double Layer::*angle, const glm::dvec2& from, double length,
                    double zero = 0.0, double sign = 1.0)
{
    return {
        {.kind = HandleKind::Arm,
         .place = from + polarPlace(length, zero + sign * layer.*angle),
         .from = from,
         .values = {degrees(field, layer.*angle)}},
        [=](Layer& changed, const glm::dvec2& wanted) { changed.*angle = turned(sign * (angleOf(wanted - from) - zero), changed.*angle); }};
}

template <typename Layer>
Grips<Layer> grips(const Layer&)
{
    return {};
}

Shows showing(const PhongLight& light) { return light.intensity == 0.0 && light.diffuse > 0.0 ? Shows::Facing : Shows::Highlight; }

Grips<PhongLightsLayer> grips(const PhongLightsLayer& layer)
{
    Grips<PhongLightsLayer> all;
    for (size_t i = 0; i < layer.lights.size(); ++i) {
        const PhongLight& light = layer.lights[i];
        all.push_back({{.kind = HandleKind::Light,
                        .place = lightPlace(showing(light), light.azimuthDeg, light.polarDeg),
                        .light = static_cast<int>(i),
                        .color = light.color,
                        .values = {degrees("azimuth", light.azimuthDeg), degrees("polar", light.polarDeg)}},
                       [i](PhongLightsLayer& changed, const glm::dvec2& wanted) {
                           PhongLight& moved = changed.lights[i];
                           setLight(showing(moved), moved.azimuthDeg, moved.polarDeg, wanted);
                       }});
    }
    return all;
}

Grips<ToonLayer> grips(const ToonLayer& layer)
{
    const bool shines = layer.highlightDeg > 0.0;
    Grips<ToonLayer> all{lightGrip(layer, shines ? Shows::Highlight : Shows::Facing, shines ? layer.highlightColor : layer.lightColor)};
    if (layer.rim > 0.0)
        all.push_back({{.kind = HandleKind::Place,
                        .place = polarPlace(1.0, layer.azimuthDeg + layer.rimTurnDeg),
                        .values = {degrees("rim-turn", layer.rimTurnDeg)}},
                       [](ToonLayer& changed, const glm::dvec2& wanted) {
                           changed.rimTurnDeg = turned(angleOf(wanted) - changed.azimuthDeg, changed.rimTurnDeg);
                       }});
    return all;
}

std::optional<glm::dvec3> colorNearest(const std::vector<GradientStop>& stops, double position)
{
    std::optional<glm::dvec3> color;
    double nearest = 2.0;
    for (const GradientStop& stop : stops)
        if (const double distance = std::abs(stop.position - position); distance < nearest) {
            nearest = distance;
            color = stop.color;
        }
    return color;
}

/// One end of a linear gradient; the other end stays where it is.
Grip<GradientLayer> endGrip(const GradientLayer& layer, double sign)
{
    const glm::dvec2 center(layer.centerX, layer.centerY);
    return {{.kind = HandleKind::Arm,
             .place = center + polarPlace(sign * layer.radius, layer.angleDeg),
             .from = center,
             .color = colorNearest(layer.stops, sign > 0.0 ? 1.0 : 0.0),
             .values = {degrees("angle", layer.angleDeg), {"radius", layer.radius}}},
            [sign](GradientLayer& changed, const glm::dvec2& wanted) {
                const glm::dvec2 other = glm::dvec2(changed.centerX, changed.centerY) - polarPlace(sign * changed.radius, changed.angleDeg);
                const glm::dvec2 way = sign * (wanted - other), middle = 0.5 * (wanted + other);
                changed.angleDeg = turned(angleOf(way), changed.angleDeg);
                changed.radius = rounded(0.5 * glm::length(way));
                changed.centerX = rounded(middle.x);
                changed.centerY = rounded(middle.y);
            }};
}

Grips<GradientLayer> grips(const GradientLayer& layer)
{
    const glm::dvec2 center(layer.centerX, layer.centerY);
    switch (layer.shape) {
    case GradientShape::Radial:
        return {centerGrip(layer),
                {{.kind = HandleKind::Ring,
                  .place = center + glm::dvec2(layer.radius, 0.0),
                  .from = center,
                  .color = colorNearest(layer.stops, 1.0),
                  .values = {{"radius", layer.radius}}},
                 [](GradientLayer& changed, const glm::dvec2& wanted) {
                     changed.radius = rounded(glm::distance(wanted, {changed.centerX, changed.centerY}));
                 }}};
    case GradientShape::Linear:
        return {endGrip(layer, -1.0), endGrip(layer, 1.0), centerGrip(layer)};
    case GradientShape::Angular:
        return {centerGrip(layer), armGrip(layer, "angle", &GradientLayer::angleDeg, center, 0.5)};
    case GradientShape::Shaded:
        break;
    }
    return {lightGrip(layer, Shows::Facing, colorNearest(layer.stops, 1.0))};
}

Grips<WindowLayer> grips(const WindowLayer& layer)
{
    constexpr double stalk = 0.12; // above the window's upper edge
    const glm::dvec2 center = windowPlace(layer, {0.0, 0.0});
    Grips<WindowLayer> all{centerGrip(layer)};
    all.front().handle.place = center;
    all.push_back({{.kind = HandleKind::Corner,
                    .place = windowPlace(layer, {0.5 * layer.width, -0.5 * layer.height}),
                    .values = {{"width", layer.width}, {"height", layer.height}}},
                   [](WindowLayer& changed, const glm::dvec2& wanted) {
                       const glm::dvec2 half = windowCoordinates(changed, wanted);
                       changed.width = rounded(2.0 * std::abs(half.x));
                       changed.height = rounded(2.0 * std::abs(half.y));
                   }});
    all.push_back({{.kind = HandleKind::Arm,
                    .place = windowPlace(layer, {0.0, 0.5 * layer.height + stalk}),
                    .from = center,
                    .values = {degrees("tilt", layer.tiltDeg)}},
                   [](WindowLayer& changed, const glm::dvec2& wanted) {
                       const double turn = angleOf(windowCoordinates(changed, wanted)) - 90.0;
                       changed.tiltDeg = turned(changed.tiltDeg + turn, changed.tiltDeg);
                   }});
    return all;
}

Grips<ColdWarmLayer> grips(const ColdWarmLayer& layer)
{
    return {{{.kind = HandleKind::Light,
              .place = polarPlace(layer.highlightDistance, layer.angleDeg),
              .color = layer.highlightColor,
              .values = {degrees("angle", layer.angleDeg), {"highlight-distance", layer.highlightDistance}}},
             [](ColdWarmLayer& changed, const glm::dvec2& wanted) {
                 changed.angleDeg = turned(angleOf(wanted), changed.angleDeg);
                 changed.highlightDistance = rounded(glm::length(wanted));
             }},
            {{.kind = HandleKind::Place, .place = polarPlace(-layer.balance, layer.angleDeg), .values = {{"balance", layer.balance}}},
             [](ColdWarmLayer& changed, const glm::dvec2& wanted) {
                 changed.balance = rounded(-glm::dot(wanted, polarPlace(1.0, changed.angleDeg)));
             }}};
}

Grips<SilhouetteLayer> grips(const SilhouetteLayer& layer)
{
    if (layer.swell == 0.0)
        return {};
    Grip<SilhouetteLayer> thickest = armGrip(layer, "swell-angle", &SilhouetteLayer::swellDeg, glm::dvec2(0.0), 1.0);
    thickest.handle.kind = HandleKind::Place;
    return {thickest};
}

Grips<HatchingLayer> grips(const HatchingLayer& layer)
{
    Grips<HatchingLayer> all;
    if (layer.tone == HatchingTone::Shade)
        all.push_back(lightGrip(layer, Shows::Facing, std::nullopt));
    all.push_back(armGrip(layer, "angle", &HatchingLayer::angleDeg, glm::dvec2(0.0), 0.5));
    return all;
}

Grips<ColorgramLayer> grips(const ColorgramLayer& layer)
{
    if (layer.source == ColorgramSource::Gradient)
        return {{{.kind = HandleKind::Ring, .place = {layer.center, 0.0}, .values = {{"center", layer.center}}},
                 [](ColorgramLayer& changed, const glm::dvec2& wanted) { changed.center = rounded(glm::length(wanted)); }}};
    Grips<ColorgramLayer> all{lightGrip(layer, Shows::Highlight, std::nullopt)}; // order 0 is the mirror direction
    if (layer.grooves == Grooves::Straight)
        all.push_back(armGrip(layer, "groove-angle", &ColorgramLayer::grooveDeg, glm::dvec2(0.0), 0.5));
    return all;
}

/// Turns about +Y and then +X that take +Z to a direction, in degrees: (sin y, -sin x cos y, cos x cos y). Of the two ways the one nearer
/// to the present turn about +Y.
glm::dvec2 turnsTo(const glm::dvec3& d, double presentY)
{
    const double y = std::asin(std::clamp(d.x, -1.0, 1.0)), x = std::atan2(-d.y, d.z);
    const bool isOther = std::cos(presentY * pi / 180.0) < 0.0;
    const glm::dvec2 turns = (isOther ? glm::dvec2(pi - y, std::atan2(d.y, -d.z)) : glm::dvec2(y, x)) * 180.0 / pi;
    return turns;
}

glm::dvec3 turnedAxis(double yDeg, double xDeg)
{
    const double y = yDeg * pi / 180.0, x = xDeg * pi / 180.0;
    return {std::sin(y), -std::sin(x) * std::cos(y), std::cos(x) * std::cos(y)};
}

/// The place where the middle of the probe is mirrored, or where it lights the surface.
Grips<ProbeLayer> grips(const ProbeLayer& layer)
{
    const Shows shows = layer.lobe == ProbeLobe::Diffuse ? Shows::Facing : Shows::Highlight;
    const LightAngles middle = lightAngles(turnedAxis(layer.yawDeg, layer.tiltDeg));
    return {{{.kind = HandleKind::Place,
              .place = lightPlace(shows, middle.azimuthDeg, middle.polarDeg),
              .values = {degrees("yaw", layer.yawDeg), degrees("tilt", layer.tiltDeg)}},
             [shows](ProbeLayer& changed, const glm::dvec2& wanted) {
                 const LightAngles to = shows == Shows::Highlight ? lightOfHighlight(wanted) : lightOfFacing(wanted);
                 const glm::dvec2 turns = turnsTo(lightDirection(to.azimuthDeg, to.polarDeg), changed.yawDeg);
                 changed.yawDeg = nearestTurn(turns.x, changed.yawDeg);
                 changed.tiltDeg = nearestTurn(turns.y, 0.0);
             }}};
}

Grips<ImageLayer> grips(const ImageLayer& layer)
{
    return {armGrip(layer, "turn", &ImageLayer::turnDeg, glm::dvec2(0.0), inwards, 90.0, layer.flip ? -1.0 : 1.0)};
}

Grips<TwistLayer> grips(const TwistLayer& layer)
{
    return {{{.kind = HandleKind::Ring,
              .place = polarPlace(layer.radius, layer.angleDeg),
              .values = {degrees("angle", layer.angleDeg), {"radius", layer.radius}}},
             [](TwistLayer& changed, const glm::dvec2& wanted) {
                 changed.angleDeg = nearestTurn(angleOf(wanted), changed.angleDeg);
                 changed.radius = rounded(glm::length(wanted));
             }}};
}

/// Where what lay at the center is now, and where what lay at the top is turned to.
Grips<RotateLayer> grips(const RotateLayer& layer)
{
    const LightAngles center = lightAngles(turnedAxis(layer.rightDeg, -layer.upDeg));
    return {{{.kind = HandleKind::Place,
              .place = facingPlace(center),
              .values = {degrees("right", layer.rightDeg), degrees("up", layer.upDeg)}},
             [](RotateLayer& changed, const glm::dvec2& wanted) {
                 const LightAngles to = lightOfFacing(wanted);
                 const glm::dvec2 turns = turnsTo(lightDirection(to.azimuthDeg, to.polarDeg), changed.rightDeg);
                 changed.rightDeg = nearestTurn(turns.x, 0.0);
                 changed.upDeg = nearestTurn(-turns.y, 0.0);
             }},
            armGrip(layer, "angle", &RotateLayer::angleDeg, glm::dvec2(0.0), inwards, 90.0)};
}

template <typename Settings>
void keepInRange(Settings& settings)
{
    Settings::visitFields(settings, [](const Field& field, auto& value) {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<T, double>)
            value = std::clamp(value, field.low, field.high);
        else if constexpr (std::is_same_v<T, std::vector<PhongLight>>)
            for (PhongLight& light : value)
                keepInRange(light);
    });
}

} // namespace

std::vector<DiscHandle> discHandles(const LayerContent& content)
{
    return std::visit(
        [](const auto& layer) {
            std::vector<DiscHandle> handles;
            for (auto& grip : grips(layer))
                handles.push_back(std::move(grip.handle));
            return handles;
        },
        content);
}

void moveHandle(LayerContent& content, size_t handle, const glm::dvec2& wanted)
{
    std::visit(
        [&]<typename Kind>(Kind& layer) {
            if constexpr (!std::is_same_v<Kind, UnknownLayer>) {
                grips(std::as_const(layer)).at(handle).move(layer, wanted);
                keepInRange(layer);
            }
        },
        content);
}

bool holdsLights(const LayerContent& content) { return std::holds_alternative<PhongLightsLayer>(content); }

std::optional<int> addLight(LayerContent& content, const glm::dvec2& place, std::optional<int> like)
{
    constexpr size_t most = 64; // the field's range
    auto* layer = std::get_if<PhongLightsLayer>(&content);
    if (!layer || layer->lights.size() >= most)
        return std::nullopt;
    PhongLight light = like ? layer->lights.at(static_cast<size_t>(*like)) : PhongLight{};
    setLight(showing(light), light.azimuthDeg, light.polarDeg, place);
    layer->lights.push_back(light);
    return static_cast<int>(layer->lights.size()) - 1;
}

void removeLight(LayerContent& content, int light)
{
    if (auto* layer = std::get_if<PhongLightsLayer>(&content))
        layer->lights.erase(layer->lights.begin() + light);
}

} // namespace mirrorball
