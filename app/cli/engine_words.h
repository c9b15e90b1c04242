#pragma once

#include "core/engine/engine_profile.h"
#include "core/image/environment_map.h"
#include "core/image/image_io.h"

#include <filesystem>
#include <string>
#include <vector>

/// The words of `--for` and `--encode`, which several commands take.
namespace mirrorball::cli {

/// How `--for ENGINE` turns a map of a kind. @throws InvalidArgument for an engine that takes no such map
struct EngineTurn {
    double yawDeg = 0.0;           ///< beside --yaw
    CubeOrientation orientation{}; ///< of cubes
};
EngineTurn engineTurn(const std::string& engine, Parameterization kind);

/// The cubes as the engine stores them; others stay.
void store(std::vector<EnvironmentMap>& levels, const CubeOrientation& orientation);

/// `--encode` for an output file; filmic where the word is empty. @throws InvalidArgument
ByteEncoding parseEncode(const std::string& word, const std::filesystem::path& out);

} // namespace mirrorball::cli
