#pragma once

#include "direction_cursor.h"
#include "document.h"
#include "live_scene.h"
#include "notices.h"

namespace mirrorball::studio {

/// What every dock is given: the document, what was made of it, and what is pointed at. One per window.
struct Workspace {
    Document document{};
    LiveScene live{document};
    DirectionCursor cursor{};
    Notices notices{};
};

} // namespace mirrorball::studio
