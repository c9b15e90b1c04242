#pragma once

#include "sphere_map_editor.h"

namespace mirrorball::studio {

/// Layers on the clipboard: JSON texts as a file has them, so that they go from one scene, and one window, into another. Paths inside keep
/// leading to their files.
void copyLayer(const SphereMapEditor& editor);
bool hasCopiedLayers();
/// Puts them above the chosen layer; a scene without a sphere map of its own gets one. @throws InvalidArgument
void pasteLayers(SphereMapEditor& editor);

} // namespace mirrorball::studio
