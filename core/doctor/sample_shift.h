#pragma once

#include "core/image/image.h"

namespace mirrorball {

/// How far the texels of a map lie from where their centers should be, in texels.
struct SampleShift {
    double right = 0.0, down = 0.0; ///< the picture lies that far from where it should: corner sampling is half a texel
    double spread = 0.0; ///< texels that the picture is stretched by at its edges: -0.5 where the outermost texels lie *on* the edges
    bool known = false;  ///< false: too few texels, or nothing to see the shift by
};

/// Measures it in pictures one below the other, of the map and of what it should be, by least squares of
///   map - truth = -(right + spread p_x) d truth/dx - (down + spread p_y) d truth/dy + b Laplacian + c truth,   p in [-1, 1] over a picture
/// where b takes up what is only a little more or less blurred and c a factor. Texels count by their relative difference.
/// @param pictures  6 for a cube
SampleShift sampleShift(const Image& map, const Image& truth, int pictures);

} // namespace mirrorball
