#pragma once

#include "image_io.h"

#include "core/base/atomic_file.h"

#include <string_view>

/// OpenEXR files (.exr).
/// Source: OpenEXR's Technical Introduction and file layout documents (openexr.com).
namespace mirrorball::exr {

/// Whether a file that begins with these bytes is an OpenEXR file.
bool hasSignature(std::string_view firstBytes);

/// Opens one mip level. Of several parts the first flat one that holds colour is read; of its channels R, G and B, else Y (with RY and BY
/// where luminance/chroma coded), else the layer named ...Combined (Blender's), else the first layer with R, G, B or Y, else a lone
/// channel. The data window is what is read. Other primaries than Rec.709 are converted, so wide-gamut colours come out negative.
/// @throws FileError
std::unique_ptr<ImageReader> open(const std::filesystem::path& path, int level);

/// Opens a pass by name: of the channels `LAYER.PASS.R` and so on (or `PASS.R`), or of the part named so. Null when there is none.
/// @throws FileError
std::unique_ptr<ImageReader> openPass(const std::filesystem::path& path, const std::string& pass);

/// Scanlines, ZIP-compressed unless that saves nothing. One channel is written as Y, four as R, G, B, A. The attribute "envmap" (latlong or
/// cube) becomes OpenEXR's own; others are stored as strings. @throws WorkError
void write(AtomicFile& file, const Image& image, const WriteOptions& options);

/// Several pictures of one size in one part, as passes: channels `NAME.R`, `NAME.G`, `NAME.B`. Scanlines, ZIP-compressed. @throws WorkError
void writePasses(AtomicFile& file, const std::vector<ImagePassData>& passes, const WriteOptions& options);

/// Tiles of 64 x 64 in mip levels rounded down; `levels` is the whole chain, down to 1 x 1. @throws WorkError
void writeMips(AtomicFile& file, const std::vector<Image>& levels, const WriteOptions& options);

} // namespace mirrorball::exr
