#pragma once

#include "image_io.h"

#include "core/base/atomic_file.h"

#include <string_view>

/// All formats but .exr and .hdr: loads the module that links OpenImageIO on first use and puts what it reads into linear RGB.
namespace mirrorball::openimageio {

/// The format is told by the first bytes, else by the extension. @throws FileError; WorkError when the module cannot be loaded
std::unique_ptr<ImageReader> open(const std::filesystem::path& path, std::string_view firstBytes, int level);

/// Formats of floats take linear values, those of 8 bits a display picture (color.h: no exposure, filmic curve).
/// @throws WorkError
void write(AtomicFile& file, const std::filesystem::path& named, const std::vector<Image>& levels, const WriteOptions& options);

/// The bytes of a .png of a display picture. @throws WorkError
std::string encodePng(const Image& display);

} // namespace mirrorball::openimageio
