#pragma once

#include "render_settings.h"

#include "../scene/plan.h"
#include "../scene/scene_maps.h"

namespace mirrorball::preview {

/// The settings that draw a scene as planned. @throws InvalidArgument for a geometry that is not known
RenderSettings renderSettings(const Scene& scene, const Plan& plan);

/// The maps of a scene as the renderer takes them.
RenderMaps renderMaps(const SceneMaps& maps);

} // namespace mirrorball::preview
