#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

/// Many pictures of one scene: `--grid`, of which every cell has other values, and `--turntable`, of which every frame is seen from
/// elsewhere.
namespace mirrorball::cli {

inline constexpr int mostCells = 256;

/// One `--grid FIELD=VALUE,VALUE`: a field of the scene and what it is in each column or row.
struct GridAxis {
    std::string field{};
    std::vector<std::string> values{}; ///< as typed

    /// The field's last name and the value; of a path only the file's name: "roughness 0.2".
    std::string label(size_t index) const;
};

/// Values stand between commas, or between semicolons where there are any outside of quotes and brackets; inside of those nothing divides.
/// @throws InvalidArgument for a text without FIELD= or with an empty value
GridAxis parseGridAxis(const std::string& text);

/// The columns and the rows of the `--grid`s, rows without a value where there is one `--grid`.
/// @throws InvalidArgument for more than two, one field twice, more than mostCells cells
std::vector<GridAxis> parseGrid(const std::vector<std::string>& texts);

/// What a turntable turns.
enum class Turns { Camera, Environment };

/// The scene at a frame of a full turn, frames 1 to count; frame 1 is the scene itself. @param frame  [1, count]
Scene turned(Scene scene, Turns turns, int frame, int count);

} // namespace mirrorball::cli
