#pragma once

#include "mesh.h"

namespace mirrorball::preview {

/// The window of a room, 003 section 4: its pane stands in the plane z = 0, `paneHalf` about `paneCenter`; the room lies towards +Z.
namespace window {

inline constexpr glm::vec2 paneCenter{0.0f, 0.15f};
inline constexpr glm::vec2 paneHalf{0.6f, 0.7f};

/// What a vertex belongs to, in its texture coordinate u.
enum class Part { Plaster, Floor, Frame, Pane };

} // namespace window

/// Three walls, floor, ceiling, frame and pane.
Mesh windowMesh();

} // namespace mirrorball::preview
