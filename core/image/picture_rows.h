#pragma once

#include "image_io.h"

#include <filesystem>
#include <functional>

namespace mirrorball {

/// A picture that is made as it is written, from the top down, and never stands whole in memory.
struct PictureRows {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::function<Image(int firstRow, int rows)> rows{}; ///< called in order, for all of them
    int atATime = 64;                                    ///< rows; the last call may want fewer
    Image sample{}; ///< of the same picture, smaller: what a writer decides by the whole it decides by this
};

/// Whether writeRows() can write a file of this name.
bool writesRows(const std::filesystem::path& path);

/// writeImage() of linear light for a format that takes rows as they come (.exr).
/// @throws InvalidArgument for another format; as writeImage(); what `rows` throws, and then there is no file
void writeRows(const std::filesystem::path& path, const PictureRows& picture, const WriteOptions& options = {});

} // namespace mirrorball
