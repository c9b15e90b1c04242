#pragma once

#include "packed_texel.h"

#include "core/image/image.h"

#include <array>
#include <string>
#include <string_view>

/// PlayCanvas' envAtlas: one picture of 512 x 512 texels that holds latlong maps in rectangles: the environment and five halvings, six
/// filtered levels, and the diffuse light. Source: playcanvas 2.23, scene/graphics/env-lighting.js; shader chunks envAtlas, reflectionEnv.
namespace mirrorball::play_canvas_atlas {

inline constexpr int size = 512;

enum class Content { Source, Specular, Diffuse };

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0; ///< y down
    Content content = Content::Source;
    int level = 0;          ///< source: halvings; specular: 1 .. 6
    double roughness = 0.0; ///< at which the shader reads a specular rectangle
};

/// The shader reads specular rectangle i at roughness i/5; the sixth stands beyond it.
inline constexpr std::array<Rectangle, 13> rectangles{{
    {0, 0, 512, 256, Content::Source, 0, 0.0},
    {256, 256, 256, 128, Content::Source, 1, 0.0},
    {384, 384, 128, 64, Content::Source, 2, 0.0},
    {448, 448, 64, 32, Content::Source, 3, 0.0},
    {480, 480, 32, 16, Content::Source, 4, 0.0},
    {496, 496, 16, 8, Content::Source, 5, 0.0},
    {0, 256, 256, 128, Content::Specular, 1, 0.2},
    {0, 384, 128, 64, Content::Specular, 2, 0.4},
    {0, 448, 64, 32, Content::Specular, 3, 0.6},
    {0, 480, 32, 16, Content::Specular, 4, 0.8},
    {0, 496, 16, 8, Content::Specular, 5, 1.0},
    {0, 504, 8, 4, Content::Specular, 6, 1.0},
    {128, 384, 64, 32, Content::Diffuse, 0, 1.0},
}};

/// Direction of the point (i, j) of a rectangle, in texels from the center of its first one. The outermost texels are a border that
/// continues the map: around its seam, and on over the poles as the row before them.
///   u = (i + 1/2 - 1)/(w - 2), v = (j + 1/2 - 1)/(h - 2), v clamped to the first and last row
glm::dvec3 direction(const Rectangle& rectangle, double i, double j);

/// The bytes of the PNG. @param atlas  size x size, RGB; @param form  Rgbp or Rgbm: the texture's type in PlayCanvas
std::string write(const Image& atlas, PackedColor form);

/// The atlas as radiance. @throws FileError for damaged data or another size
Image read(std::string_view bytes, const std::string& name, PackedColor form);

} // namespace mirrorball::play_canvas_atlas
