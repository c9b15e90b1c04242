#pragma once

#include "painted_pictures.h"

#include "core/base/stage.h"

#include <filesystem>
#include <vector>

namespace mirrorball {

/// Size and channels of a picture that was written.
struct PaintedSize {
    int edge = 0;
    int channels = 3; ///< 3: opaque everywhere
};

struct PaintedFiles {
    std::vector<std::filesystem::path> files{};
    std::vector<PaintedSize> levels{}; ///< largest first
    std::vector<Stage> stages{};       ///< how long evaluating and writing took, or both where they are one
};

/// Paints a document and writes it: paintedPictures() and writePictures(). A large map in a format that takes rows as they come is made
/// band by band, and never stands whole in memory: the same texels.
/// @throws as those two
PaintedFiles writePainted(const std::filesystem::path& out, const SphereMapDocument& document, const PaintedOptions& options,
                          SampleType samples, const JobControl& job = {});

} // namespace mirrorball
