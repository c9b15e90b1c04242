#pragma once

#include "image_io.h"

#include <filesystem>
#include <memory>
#include <string>

/// Readers around readers.
namespace mirrorball {

/// Rows of a file whose info().orientation is not upright, set upright. A file that is only mirrored left to right still streams; the
/// others are held whole. Source: Exif 2.32, tag 274.
std::unique_ptr<ImageReader> upright(std::unique_ptr<ImageReader> reader, Channels channels);

/// Stored colors of a named space (ProbeReading::colorSpace) as linear Rec.709. Names that colorSpaceFromName() does not know are looked
/// up in the OpenColorIO configuration that $OCIO names.
/// @throws InvalidArgument for a name that neither knows
std::unique_ptr<ImageReader> inColorSpace(std::unique_ptr<ImageReader> reader, const std::string& space, Channels channels);

/// The number of the part that is asked for, 0 where none is. @throws FileError for a name, which only OpenEXR's parts have
int partNumber(const std::filesystem::path& path, const ProbeReading& reading);
/// @throws FileError where a layer is asked for: for formats that have none
void checkNoLayer(const std::filesystem::path& path, const ProbeReading& reading);

/// Rows of a reader of three channels, with an opacity of 1 where `channels` asks for one.
std::unique_ptr<ImageReader> withOpacity(std::unique_ptr<ImageReader> reader, Channels channels);

} // namespace mirrorball
