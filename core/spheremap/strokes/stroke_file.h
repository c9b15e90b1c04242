#pragma once

#include "stroke.h"

#include <filesystem>
#include <span>
#include <vector>

/// Recorded strokes by themselves (`*.strokes`): JSON, {"version": 1, "strokes": [...]}, each stroke as in stroke_json.h. What a script or
/// another program hands over to be painted; a document holds its strokes in its layers.
namespace mirrorball {

inline constexpr int strokeFileVersion = 1;

/// @throws FileError naming stroke, point and field
std::vector<Stroke> loadStrokes(const std::filesystem::path& path);
/// The file appears whole or not at all. @throws InvalidArgument naming the field; WorkError
void saveStrokes(std::span<const Stroke> strokes, const std::filesystem::path& path);

} // namespace mirrorball
