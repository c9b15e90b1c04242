#pragma once

#include "core/base/job.h"
#include "core/image/container/packed_texel.h"
#include "core/image/environment_map.h"
#include "core/image/repair.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// A map of levels as its files hold it: no face is turned, mirrored or reordered, whatever the container is known to do.
namespace mirrorball {

struct StoredLevel {
    Image image{}; ///< of a cube the six pictures one below the other, in the order of the file; finite
    RepairReport repaired{};
};

struct StoredMap {
    std::string container{}; ///< "ktx", "ktx2", "dds", "env", "playcanvas atlas"; of images "openexr", "hdr", ..., with " faces" or "
                             ///< levels" for many files
    std::string texels{};    ///< "half", "float", "uint8", "r11g11b10", "rgbd", ...
    std::string shape{};     ///< how the pictures were found: one clause
    Parameterization kind = Parameterization::Cube;
    bool certain = true; ///< false where the shape fits several kinds
    std::vector<StoredLevel> levels{};
    std::map<std::string, std::string> metadata{};
    size_t files = 1;

    MapLayout layout(size_t level) const
    {
        return {kind, kind == Parameterization::Cube ? levels[level].image.width : levels[level].image.height, 0};
    }
};

/// What cannot be seen in the files.
struct StoredMapReading {
    std::optional<Parameterization> from{}; ///< the kind, where the shape does not tell
    std::optional<PackedColor> packed{};    ///< how the texels of 8-bit .png pictures hold radiance
};

/// Reads a map: a container; an image file with its mip levels; images by a name in which `%s` stands for a face (px nx py ny pz nz) and
/// `%d` for a level, counted from 0 or 1. Attributes of files that say which way faces are drawn are not followed. A packed picture of
/// 512 x 512 texels in a form that PlayCanvas reads is its envAtlas (play_canvas_atlas.h): the rectangles become levels, the borders
/// around them are left out.
/// @throws FileError, InvalidArgument
StoredMap readStoredMap(const std::string& path, const StoredMapReading& reading = {}, const JobControl& job = {});

} // namespace mirrorball
