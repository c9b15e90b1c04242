#pragma once

#include "image.h"

#include "core/base/job.h"

#include <memory>
#include <vector>

/// Coarser levels of a picture of any shape, as texture hardware takes them. Maps of directions have their own: mip_pyramid.h.
namespace mirrorball {

/// A picture and its coarser levels, largest first, down to 1 x 1; each has half the size of the one before, rounded down, at least 1.
/// Source: OpenGL 4.5, section 8.14.3
using PictureLevels = std::shared_ptr<const std::vector<Image>>;

/// The next level: each texel is the average over the area that it covers; texels that are cut by that area's edge count in part.
Image boxHalved(const Image& image, const JobControl& job = {});

/// All levels. @param picture not empty
std::vector<Image> pictureLevels(Image picture, const JobControl& job = {});

} // namespace mirrorball
