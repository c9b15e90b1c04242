#pragma once

#include "evaluate.h"

#include "core/image/image_io.h"

#include <vector>

/// A sphere map as the pictures that other programs are given: what `mirrorball paint` and the exports of a scene write alike.
namespace mirrorball {

enum class PaintedLevels {
    One,      ///< the map alone
    Authored, ///< the whole chain as the document makes it, see evaluateLevels()
    Plain,    ///< the whole chain, each level the average of the one before
};

struct PaintedOptions {
    int size = 512; ///< edge of the picture, borders included
    int border = 0; ///< texels between the disc and the picture's edge, in the rim's colors, see bordered(); 0 where there are more levels
    PaintedLevels levels = PaintedLevels::One;
};

/// @throws InvalidArgument for a border that leaves no room, or that levels have
void validate(const PaintedOptions& options);

/// Whether there is nothing of what lies behind to be seen.
bool isOpaque(const Image& rgba);

/// The pictures, largest first: RGB where all are opaque, else RGBA with colors multiplied by opacity.
/// @throws InvalidArgument for a border that leaves no room, or that levels have; as evaluate()
std::vector<Image> paintedPictures(const SphereMapDocument& document, const PaintedOptions& options, const JobControl& job = {});

/// What their files say of themselves: that they show a sphere map, and what looks it up.
WriteOptions paintedFileOptions(const SphereMapDocument& document, SampleType samples);

} // namespace mirrorball
