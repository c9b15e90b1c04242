#pragma once

#include "image_io.h"

#include <span>

namespace mirrorball {

/// writeMips() of images where they lie.
void writeMips(const std::filesystem::path& path, std::span<const Image* const> levels, const WriteOptions& options);

} // namespace mirrorball
