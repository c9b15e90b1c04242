#pragma once

#include "image_io.h"
#include "probe_reading.h"
#include "repaired_reader.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The file, or the files, of a probe as one picture.
namespace mirrorball {

/// The words that stand for a `%s` in the names that are written.
inline constexpr std::array<std::string_view, 6> faceNames{"px", "nx", "py", "ny", "pz", "nz"};
inline constexpr std::array<std::string_view, 2> halfNames{"front", "back"};

/// The files that a probe's name stands for: itself; or where its `%s` is no part of a file's name, the six faces of a cube in the order +X
/// -X +Y -Y +Z -Z (px nx py ny pz nz, posx negx ..., +X -X ..., right left top bottom front back, ... in any case), or the two halves of a
/// paraboloid (front back). Empty where there are none.
std::vector<std::filesystem::path> probeFiles(const std::string& probe);

/// Six files of whose faces `path` is one, as the name with a `%s` that reads them all.
std::optional<std::string> faceFamily(const std::filesystem::path& path);

/// A probe's picture, as `reading` says and mended row by row (repair.h). Six files are the faces of a cube, stacked; two are the halves of
/// a dual paraboloid side by side, blended by their alpha where both see a direction: (af f + ab b) / (af + ab). Without an alpha a half
/// sees what lies in its circle; a back half without one, what the front leaves: 1 - af.
/// @throws FileError, InvalidArgument. Source for the blending: 000 section 2.3
std::unique_ptr<RepairedReader> openProbePicture(const std::string& probe, const ProbeReading& reading,
                                                 NegativePolicy negatives = NegativePolicy::Keep);

} // namespace mirrorball
