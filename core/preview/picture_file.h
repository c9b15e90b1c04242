#pragma once

#include "core/base/job.h"
#include "core/scene/scene_maps.h"

#include <filesystem>
#include <memory>

namespace mirrorball::preview {

/// What a picture's values are: radiance, or what a display shows of it - exposed, tone-mapped, sRGB-encoded, in [0, 1].
enum class PictureLight { Radiance, Display };

struct Picture {
    Image image{}; ///< RGBA, colors multiplied by opacity; opacity is 1 unless the background is none
    WorkRecord record{};
};

/// Draws scenes one after the other, each at its picture's size, in an OpenGL context of its own, on the thread that made it. Maps and mesh
/// are kept for the next picture: where it shows the same from elsewhere, it is only drawn. Files are taken to stay as they are.
class PictureMaker {
public:
    PictureMaker();
    ~PictureMaker();
    /// @throws FileError, InvalidArgument, WorkError, Cancelled
    Picture draw(PlannedScene planned, PictureLight light, const JobControl& job = {});

private:
    struct Kept;
    std::unique_ptr<Kept> m_kept;
};

/// Draws one scene at its picture's size, on any thread.
/// @throws FileError, InvalidArgument, WorkError, Cancelled
Picture drawPicture(PlannedScene planned, PictureLight light, const JobControl& job = {});

/// What a picture's file of this name holds: radiance in formats of linear light, the display picture in the others.
/// @throws InvalidArgument for a format that is not written
PictureLight lightOf(const std::filesystem::path& path);

/// Writes a drawn picture, RGBA as drawn. The opacity goes into the file where the background is none and the format can hold it.
/// @throws InvalidArgument, WorkError
void writePicture(const std::filesystem::path& path, Image picture, Backdrop background);

/// Draws a scene at its picture's size into a file: radiance into formats of linear light, the display picture
/// (exposed, tone-mapped, sRGB) into the others. The opacity is
/// written only where the background is none. What `mirrorball render` and the studio's "Save picture" do.
/// @throws FileError, InvalidArgument, WorkError, Cancelled
WorkRecord savePicture(PlannedScene planned, const std::filesystem::path& path, const JobControl& job = {});
/// The same with a maker that draws more than this one.
WorkRecord savePicture(PictureMaker& maker, PlannedScene planned, const std::filesystem::path& path, const JobControl& job = {});

} // namespace mirrorball::preview
