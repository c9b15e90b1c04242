#pragma once

#include "core/base/job.h"
#include "core/scene/scene_maps.h"

#include <filesystem>

namespace mirrorball::preview {

/// What a picture's values are: radiance, or what a display shows of it - exposed, tone-mapped, sRGB-encoded, in [0, 1].
enum class PictureLight { Radiance, Display };

struct Picture {
    Image image{}; ///< RGBA, colours multiplied by opacity; opacity is 1 unless the background is none
    WorkRecord record{};
};

/// Draws a scene at its picture's size. Makes an OpenGL context of its own, so that any thread can call it.
/// @throws FileError, InvalidArgument, WorkError, Cancelled
Picture drawPicture(PlannedScene planned, PictureLight light, const JobControl& job = {});

/// Draws a scene at its picture's size into a file: radiance into formats of linear light, the display picture
/// (exposed, tone-mapped, sRGB) into the others. The opacity is
/// written only where the background is none. What `mirrorball render` and the studio's "Save picture" do.
/// @throws FileError, InvalidArgument, WorkError, Cancelled
WorkRecord savePicture(PlannedScene planned, const std::filesystem::path& path, const JobControl& job = {});

} // namespace mirrorball::preview
