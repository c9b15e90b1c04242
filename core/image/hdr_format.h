#pragma once

#include "image_io.h"

#include "core/base/atomic_file.h"
#include "core/base/opened_file.h"

#include <string_view>

/// Radiance pictures (.hdr, .pic): RGBE or XYZE texels, run-length coded.
/// Source: Ward, "Real Pixels", Graphics Gems II, 1991; Radiance's src/common/color.c for what its files look like.
namespace mirrorball::hdr {

/// Whether a file that begins with these bytes is a Radiance picture.
bool hasSignature(std::string_view firstBytes);

/// Streams one scanline at a time. A texel is mantissa * 2^(exponent - 136), divided by the header's EXPOSURE and COLORCORR.
/// A picture stored in another order than top to bottom is decoded whole at the first read, in 4 bytes a texel.
/// EXPOSURE and COLORCORR lines that are no positive numbers, as careless writers leave them, count as if they were absent: a note says so.
/// Other PRIMARIES than Rec.709 are converted, but where `reading` names a color space.
/// @throws FileError
std::unique_ptr<ImageReader> open(OpenedFile file, const ProbeReading& reading = {}, Channels channels = Channels::Color);

/// Mantissas are rounded to nearest; negative values and NaN become 0, values out of range the largest one.
/// One channel is copied to three, a fourth is dropped. @throws WorkError
void write(AtomicFile& file, const Image& image);

} // namespace mirrorball::hdr
