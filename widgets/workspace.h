#pragma once

#include "direction_cursor.h"
#include "document.h"
#include "live_scene.h"
#include "method_error.h"
#include "notices.h"
#include "probe_library.h"
#include "sphere_map_editor.h"

namespace mirrorball::studio {

/// What every dock is given: the document, what was made of it, what is pointed at, and what can be chosen from. One per window.
struct Workspace {
    Document document{};
    LiveScene live{document};
    SphereMapEditor sphereMap{document, live};
    DirectionCursor cursor{};
    MethodError methodError{};
    ProbeLibrary library{};
    Notices notices{};
};

} // namespace mirrorball::studio
