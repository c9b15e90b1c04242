#pragma once

#include "core/base/job.h"
#include "core/image/image.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Babylon.js' environment (.env): a prefiltered cube down to 1 x 1, each face of each level a PNG of RGBD texels, and the diffuse light as
/// a polynomial. Source: @babylonjs/core 9.35, Misc/environmentTextureTools.pure.js.
namespace mirrorball::babylon_env {

bool hasSignature(std::string_view firstBytes);

/// The terms of the polynomial, in the order of the file.
inline constexpr std::array<std::string_view, 9> terms{"x", "y", "z", "xx", "yy", "zz", "yz", "zx", "xy"};
using Polynomial = std::array<glm::dvec3, 9>;

/// What the file holds. Its faces are stored bottom row first; here every picture stands as it is stored.
struct Environment {
    std::vector<Image> levels{}; ///< largest first, down to 1 x 1; faces +X -X +Y -Y +Z -Z one below the other; RGB
    std::optional<Polynomial> irradiance{};
    double lodGenerationScale = 0.8; ///< level of a roughness: this times log2(width alpha)
};

/// The bytes of the file. @throws InvalidArgument unless the levels are those of a cube whose edge is a power of two, down to 1 x 1
std::string write(const Environment& environment, const JobControl& job = {});

/// Reads version 1 and 2 with PNG levels. @param name  stands in messages
/// @throws FileError for damaged or foreign data
Environment read(std::string_view bytes, const std::string& name);

} // namespace mirrorball::babylon_env
