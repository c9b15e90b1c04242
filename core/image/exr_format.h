#pragma once

#include "image_io.h"

#include "core/base/atomic_file.h"
#include "core/base/opened_file.h"

#include <string_view>

/// OpenEXR files (.exr).
/// Source: OpenEXR's Technical Introduction and file layout documents (openexr.com).
namespace mirrorball {
struct PictureRows;
}

namespace mirrorball::exr {

/// Whether a file that begins with these bytes is an OpenEXR file.
bool hasSignature(std::string_view firstBytes);

/// Opens one mip level of the picture that choosePicture() (exr_channels.h) finds. The display window is what is read: black where there
/// is no data, without what lies beyond it. Other primaries than Rec.709 are converted, so wide-gamut colors come out negative; not
/// where `reading` names a color space. @throws FileError
std::unique_ptr<ImageReader> open(OpenedFile file, int level, const ProbeReading& reading = {}, Channels channels = Channels::Color);

/// Opens a pass by name: of the channels `LAYER.PASS.R` and so on (or `PASS.R`), or of the part named so. Null when there is none.
/// @throws FileError
std::unique_ptr<ImageReader> openPass(OpenedFile file, const std::string& pass, Channels channels = Channels::Color);

/// Scanlines, ZIP-compressed unless that saves nothing. One channel is written as Y, four as R, G, B, A. The attribute "envmap" (latlong or
/// cube) becomes OpenEXR's own; others are stored as strings. @throws WorkError
void write(AtomicFile& file, const Image& image, const WriteOptions& options);

/// The same of a picture whose rows are made as they are written. @throws WorkError; what making rows throws
void writeRows(AtomicFile& file, const PictureRows& picture, const WriteOptions& options);

/// Several pictures of one size in one part, as passes: channels `NAME.R`, `NAME.G`, `NAME.B`. Scanlines, ZIP-compressed. @throws WorkError
void writePasses(AtomicFile& file, const std::vector<ImagePassData>& passes, const WriteOptions& options);

/// Tiles of 64 x 64 in mip levels rounded down; `levels` is the whole chain, down to 1 x 1. @throws WorkError
void writeMips(AtomicFile& file, const std::vector<Image>& levels, const WriteOptions& options);

} // namespace mirrorball::exr
