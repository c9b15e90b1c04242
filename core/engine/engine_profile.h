#pragma once

#include "roughness_law.h"

#include "core/image/container/cube_orientation.h"
#include "core/image/container/packed_texel.h"
#include "core/image/container/texture.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What each engine takes as light, one row an engine. Everything is a resampling from our convention (core/sphere/direction.h).
namespace mirrorball {

/// What a file of a profile holds.
enum class EngineContent {
    Latlong,      ///< the environment itself, turned as the engine looks latlongs up; for engines that filter by themselves
    Skybox,       ///< the environment as a cube, one level
    SpecularCube, ///< the chain of levels
    DiffuseCube,  ///< E/pi
    BabylonEnv,   ///< chain and polynomial in one
    Atlas,        ///< PlayCanvas' rectangles
    Sh,           ///< spherical harmonics as text
    Text,         ///< what loads the others: a template of engine_snippets.h
};

/// Words for cards and plans: "specular cube".
std::string_view name(EngineContent content);

struct EngineFile {
    EngineContent content = EngineContent::Latlong;
    std::string_view file{};                ///< `{name}` stands for the export's name
    TexelFormat texels = TexelFormat::Half; ///< of cubes
    int size = 0;                           ///< edge; 0: as asked for
};

struct EngineProfile {
    std::string_view word{};   ///< of the command line: "three"
    std::string_view title{};  ///< "three.js"
    std::string_view proven{}; ///< the version in which the tests show it right; empty: it cannot run there
    std::string_view how{};    ///< one sentence: what the engine does with the files
    std::vector<EngineFile> files{};

    bool takesLatlong = true;
    double latlongYawDeg = 0.0;        ///< turns the environment so that the engine's latlong lookup shows it unturned
    CubeOrientation cube{};            ///< how cubes are stored
    std::optional<RoughnessLaw> law{}; ///< of the chain; empty: the engine filters by itself
    int size = 256;                    ///< edge of the specular cube's first level by default
    int smallest = 16, largest = 2048; ///< powers of two between them; without a law, any height of the latlong
    int lastSize = 1;                  ///< edge of the chain's last level
    std::string_view note{};           ///< what an application must know beside; may be empty
};

/// three, model-viewer, filament, babylon, playcanvas, bevy, blender, godot, unity, unreal, usd, materialx.
std::span<const EngineProfile> engineProfiles();

/// @throws InvalidArgument for an unknown word: names the known ones. `option` stands before the message
const EngineProfile& engineProfile(std::string_view word, std::string_view option = "--for");

/// Levels of the chain from `size` down to the profile's last one.
int chainLevels(const EngineProfile& profile, int size);

/// The size that is made: the profile's own where `size` is 0; for engines that take a latlong 0 again, the probe's own height.
/// @throws InvalidArgument for a size that the engine does not take
int checkedSize(const EngineProfile& profile, int size, std::string_view option = "--size");

} // namespace mirrorball
