#pragma once

#include "embedded_sphere_map.h"

#include "core/base/field_json.h"

namespace mirrorball {

/// A document as in its file. @throws InvalidArgument naming the field
SphereMapDocument sphereMapFromJson(const nlohmann::json& json);
nlohmann::ordered_json sphereMapToJson(const SphereMapDocument& document);

/// A sphere map inside another file: the same object, or null.
void readJson(const std::string& path, const nlohmann::json& json, EmbeddedSphereMap& map);
nlohmann::ordered_json writeJson(const EmbeddedSphereMap& map);

} // namespace mirrorball
