#pragma once

#include "stroke.h"

#include "core/base/field_json.h"

namespace mirrorball {

/// A stroke in files: {"brush": {...}, "symmetry": {...}, "points": "x y pressure, x y pressure, ..."}. Points are one text, because a
/// stroke has hundreds of them; a list [[x, y, pressure], ...] is read as well, where a pressure that is missing is 1. Points under a
/// tilted pen have two more numbers, "x y pressure tilt-x tilt-y".
/// @throws InvalidArgument naming the field and the point
void readJson(const std::string& path, const nlohmann::json& json, Stroke& stroke);
nlohmann::ordered_json writeJson(const Stroke& stroke);

/// A file of strokes: {"version": 1, "strokes": [...]}. @throws InvalidArgument
std::vector<Stroke> strokesFromJson(const nlohmann::json& json);

} // namespace mirrorball
