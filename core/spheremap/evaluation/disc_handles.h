#pragma once

#include "core/spheremap/document/layer.h"

#include <glm/glm.hpp>

#include <optional>
#include <string_view>
#include <vector>

/// What of a layer can be dragged on the disc: lights where they show, centers, ends, angles. The reverse of evaluating a layer: from a
/// place on its picture to the parameters that put it there.
namespace mirrorball {

/// Light: where a light shows. Place: a center. Corner: of a frame. Arm: the end of a line from what it belongs to. Ring: on a circle about
/// it.
enum class HandleKind { Light, Place, Corner, Arm, Ring };

/// A parameter that a handle sets.
struct HandleValue {
    std::string_view field{}; ///< its name in files and forms
    double value = 0.0;
    std::string_view unit{};
};

struct DiscHandle {
    HandleKind kind = HandleKind::Place;
    glm::dvec2 place{0.0};             ///< past the rim: on the ball's back, see facingPlace(), or simply outside
    glm::dvec2 from{0.0};              ///< arms, rings: what they belong to
    std::optional<int> light{};        ///< which of a list of lights it is
    std::optional<glm::dvec3> color{}; ///< what it stands for, linear RGB
    std::vector<HandleValue> values{};
};

/// The handles of a layer; none for kinds without places and directions, among them paint.
std::vector<DiscHandle> discHandles(const LayerContent& content);

/// Drags a handle: sets its parameters, within their fields' ranges, so that its place is the one wanted, or the nearest that there is.
/// Angles change by the shortest way, so that a drag can go around and around. Everything else of the layer stays. @param handle  an index
/// into discHandles()
void moveHandle(LayerContent& content, size_t handle, const glm::dvec2& wanted);

/// Whether a layer is a list of lights, to which some can be added.
bool holdsLights(const LayerContent& content);
/// Puts a new light at the end of the list, showing at a place, otherwise like another one of the list.
/// @param like  a light's number; without it a plain one
/// @return the new light's number; nothing where the layer takes no more
std::optional<int> addLight(LayerContent& content, const glm::dvec2& place, std::optional<int> like);
void removeLight(LayerContent& content, int light);

} // namespace mirrorball
