#pragma once

#include "widgets/workspace/workspace.h"

#include <QString>

/// A file becomes a part of the scene: what dialogs, drops and panels do alike. Each is one undo step, remembers the file among the recent
/// ones, and tells what is wrong with it by a notice instead.
namespace mirrorball::studio {

/// The light probe; it joins the library. @param reading  how its file is read; by itself: as the file says
void useProbe(Workspace& workspace, const QString& path, const ProbeReading& reading = {});
/// The body that the material is shown on.
void useMesh(Workspace& workspace, const QString& path);
/// The material of a material or scene file. @return whether it is the scene's now
bool useMaterial(Workspace& workspace, const QString& path);
/// Copies a sphere map, or recorded strokes, into the scene, to paint and layer. @return whether it is the scene's now
bool useSphereMap(Workspace& workspace, const QString& path);
/// Lets the scene name a sphere map, or a picture of one, that stays in its file; one that is not square is cropped about its middle.
void linkSphereMap(Workspace& workspace, const QString& path);
/// A picture as a layer of the scene's own sphere map, above the chosen one. A scene without one gets one.
void addImageLayer(Workspace& workspace, const QString& path);
/// Displays through an OpenColorIO configuration, at first by its own choice of display and view.
void useDisplay(Workspace& workspace, const QString& path);

} // namespace mirrorball::studio
