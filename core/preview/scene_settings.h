#pragma once

#include "render_settings.h"

#include "core/scene/plan.h"
#include "core/scene/scene_maps.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace mirrorball::preview {

/// The mesh file that the scene is shown on, as it can be opened; nothing for a built-in body.
std::optional<std::filesystem::path> meshFile(const Scene& scene);

/// Why pictures that are planned cannot lie on a mesh: it has no texture coordinates. One line that names field, picture and mesh; empty
/// where they can. @param geometry the mesh's name
std::string texCoordProblem(const Plan& plan, const Mesh& mesh, const std::string& geometry);

/// The settings that draw a scene as planned.
/// @param display what displayTransform() made of displayChoice()
/// @param mesh what readMesh() made of meshFile(); not looked at for a built-in body
/// @throws InvalidArgument for a mesh that is needed and missing, or without texture coordinates that are needed
RenderSettings renderSettings(const Scene& scene, const Plan& plan, std::shared_ptr<const Mesh> mesh = nullptr,
                              std::shared_ptr<const DisplayTransform> display = nullptr);

/// The display that the scene names, its paths as they can be opened; nothing for tone curve and sRGB.
std::optional<DisplayChoice> displayChoice(const Scene& scene);

/// The maps of a scene as the renderer takes them.
RenderMaps renderMaps(const SceneMaps& maps);

} // namespace mirrorball::preview
