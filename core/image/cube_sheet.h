#pragma once

#include "environment_map.h"

#include <string>

namespace mirrorball {

/// Six cube faces on a sheet, and where each lies.
enum class CubeSheet { Stack, Strip, Grid3x2, Grid2x3, HorizontalCross, VerticalCross };

/// Columns and rows of a sheet, in faces.
glm::ivec2 cellsOf(CubeSheet sheet);

/// The cube whose faces lie on a sheet, `border` texels around each cut away: texels are moved, never mixed.
/// @param faces  in what order, row by row: six of px nx py ny pz nz, each with :90, :180 or :270 where it lies turned clockwise by so
/// much.
///               Empty: on stacks, strips and grids px nx py ny pz nz as OpenGL draws them; on crosses pictures from inside, the front +Z.
/// @throws InvalidArgument for another text, or a sheet of another size
EnvironmentMap cutUp(const Image& image, CubeSheet sheet, int border, const std::string& faces);

/// @throws InvalidArgument, beginning with "faces", unless empty or six faces, each once
void checkFaceOrder(const std::string& faces);

/// The faces of a stacked cube, each with `border` texels around it copied from its neighbors; beyond a corner, where no face is, from one
/// of those that meet there. Source: 002 figure 2; 000 section 2.4
Image withBorders(const EnvironmentMap& cube, int border);

} // namespace mirrorball
