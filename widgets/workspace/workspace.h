#pragma once

#include "document.h"
#include "live_scene.h"
#include "mesh_thumbnails.h"
#include "preset_library.h"
#include "probe_library.h"
#include "snapshots.h"
#include "widgets/controls/direction_cursor.h"
#include "widgets/controls/notices.h"
#include "widgets/panels/method_error.h"
#include "widgets/spheremap/sphere_map_editor.h"

namespace mirrorball::studio {

/// What every dock is given: the document, what was made of it, what is pointed at, and what can be chosen from. One per window.
struct Workspace {
    Document document{};
    LiveScene live{document};
    SphereMapEditor sphereMap{document, live};
    DirectionCursor cursor{};
    MethodError methodError{};
    ProbeLibrary library{};
    PresetLibrary presets{};
    MeshThumbnails meshes{};
    Snapshots snapshots{};
    Notices notices{};
};

} // namespace mirrorball::studio
