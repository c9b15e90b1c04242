#pragma once

#include "environment_map.h"
#include "file_names.h"
#include "image_io.h"

#include <filesystem>
#include <string>
#include <vector>

/// Environment maps as files: what the command line, scenes and the studio write alike.
namespace mirrorball {

/// The files that writeMap() makes of levels of these layouts, with WriteOptions::faceBorder, in its order; nothing is opened.
/// @throws InvalidArgument for an extension that cannot be written, or a `%s` in the name of a map that is neither cube nor
/// paraboloid; refuseDoubtfulLevel()
std::vector<std::filesystem::path> mapFiles(const std::filesystem::path& out, const std::vector<MapLayout>& levels, int faceBorder = 0);

/// Whether a map could be written to `out`, asked before it is made: the format, the marks in the name, the folder.
/// @param base  of the largest level. @throws InvalidArgument as mapFiles(); WorkError as checkTarget()
void checkMapFile(const std::filesystem::path& out, const MapLayout& base);

/// Writes a map, or a chain of levels (each its own map, largest first), to `out`: one file; the levels inside it where the format
/// holds them (.exr, .tif), else one file a level, NAME.0.EXT, NAME.1.EXT, ... A `%d` or `%0Nd` in the name stands for the level's number
/// and makes one file a level of any format; a `%s` in the name of a cube makes six files, px nx py ny pz nz, and in that of a paraboloid
/// two, front and back, whose alpha is 1 inside the circle and 0 outside (paraboloid_halves.h); `%%` is a percent sign (file_names.h). The
/// parameterization and border are stored in the file's attributes where it can hold them, beside those in `options`. Each file appears
/// whole or not at all. @return the files written, in order
std::vector<std::filesystem::path> writeMap(const std::filesystem::path& out, const std::vector<EnvironmentMap>& levels,
                                            const WriteOptions& options = {});

/// Writes a picture, or its mip levels, largest first, where there is no map to speak of: the same rules for names. Linear light goes into
/// formats that hold floats; into the others goes the picture clipped to [0, 1] and sRGB-encoded, since a painted color should stay what
/// it is.
/// @throws as writeImage(); InvalidArgument for a `%s` in the name
std::vector<std::filesystem::path> writePictures(const std::filesystem::path& out, const std::vector<Image>& levels,
                                                 const WriteOptions& options = {});

} // namespace mirrorball
