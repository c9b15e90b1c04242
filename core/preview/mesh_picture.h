#pragma once

#include "render_settings.h"

namespace mirrorball::preview {

/// A small picture of a body to choose it by: matt grey, lit from above, from a little above and beside, transparent around it. Draws with
/// an OpenGL context of its own; what was current on the calling thread is current again afterwards.
/// @param edge  of the picture, pixels
/// @return RGBA in [0, 1], sRGB-encoded and then multiplied by opacity
/// @throws WorkError where there is no context to draw with
Image meshPicture(const Geometry& geometry, int edge);

} // namespace mirrorball::preview
