#pragma once

#include <string_view>

/// Which roughness each level of a prefiltered chain stands for. Engines do not agree, and a chain made for another's law is blurred
/// wrongly at every roughness between.
namespace mirrorball {

enum class RoughnessLaw {
    Linear,     ///< r = l/(n-1): glTF, Bevy
    Filament,   ///< l = (n-1) r (2 - r): Filament, three.js from r187
    Babylon,    ///< l = 0.8 log2(w alpha), w the edge of level 0, which is a mirror: Babylon.js
    PlayCanvas, ///< r = l/5, at most 1: PlayCanvas' shader
    Unity,      ///< l = 6 r (1.7 - 0.7 r): Unity, seven levels
    Unreal      ///< l = n - 3 + 1.2 log2 r, so that the last three are fully rough; level 0 is a mirror: Unreal
};

/// "linear", "filament", "babylon", "playcanvas", "unity", "unreal".
std::string_view name(RoughnessLaw law);

/// Perceptual roughness of a level; alpha is its square, in [0, 1].
/// @param level   0 .. levels - 1
/// @param width   edge of level 0 in texels, which Babylon.js' law depends on
double levelRoughness(RoughnessLaw law, int level, int levels, int width);

/// The level, a real number in [0, levels - 1], at which the engine's shader looks a roughness up: the inverse of levelRoughness().
double roughnessLevel(RoughnessLaw law, double roughness, int levels, int width);

} // namespace mirrorball
