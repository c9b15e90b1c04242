#pragma once

#include "core/base/job.h"
#include "core/scene/scene_maps.h"

#include <filesystem>

namespace mirrorball::preview {

/// Draws a scene at its picture's size into a file: radiance into formats of linear light, the display picture
/// (exposed, tone-mapped, sRGB) into the others. Makes an OpenGL context of its own, so that any thread can call it. The opacity is
/// written only where the background is none. What `mirrorball render` and the studio's "Save picture" do.
/// @throws FileError, InvalidArgument, WorkError, Cancelled
WorkRecord savePicture(PlannedScene planned, const std::filesystem::path& path, const JobControl& job = {});

} // namespace mirrorball::preview
