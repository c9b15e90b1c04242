#pragma once

#include "core/report/map_drawer.h"

#include <memory>

namespace mirrorball::preview {

/// Draws a mirroring sphere of 2700 triangles (000 section 3.2.5 has 2592) that fills most of 640 x 480 pixels, one sample each, with an
/// OpenGL context of its own, which nobody else sees: what was current on the calling thread is current again afterwards.
/// @return null where there is no context to draw with: then nothing is drawn, and nothing else fails
std::shared_ptr<MapDrawer> sphereDrawer();

} // namespace mirrorball::preview
