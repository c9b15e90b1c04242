#pragma once

#include "environment_map.h"
#include "image_io.h"

#include <array>

/// The halves of a dual paraboloid map as pictures of their own, as hardware of two textures took them. Source: 000 section 2.3
namespace mirrorball {

/// One half, its disc inscribed but for a border. Colors are not multiplied by the alpha: that says how far the half is believed.
struct ParaboloidHalf {
    Image rgba{};          ///< square
    bool hasAlpha = false; ///< else the alpha is not looked at
};

/// Front and back of a map, with alpha 1 inside the circle and 0 outside, where the colors go on beyond it.
std::array<Image, 2> splitHalves(const EnvironmentMap& paraboloid);

/// The map's image of two halves, front left, back right: (af f + ab b) / (af + ab) for every texel's direction, also in the border. A half
/// without alpha is believed in its circle; a back half without one, where the front has one, as far as the front is not: ab = 1 - af.
/// Where nobody is believed a texel keeps its half's own color.
Image joinHalves(const ParaboloidHalf& front, const ParaboloidHalf& back, int border);

/// Colors that come multiplied by their alpha, as they are without it.
void divideByAlpha(Image& rgba);

/// The border that a file says its map has, or 0.
int borderOf(const ImageFileInfo& info);

} // namespace mirrorball
