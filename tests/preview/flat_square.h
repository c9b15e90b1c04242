#pragma once

#include "core/preview/render_settings.h"

#include <cmath>
#include <memory>
#include <utility>

/// A square that fills the picture, each of its pixels straight on.
namespace mirrorball::test {

inline constexpr int squareEdge = 64; ///< of the picture, in pixels

/// A square from -1 to 1 that looks to +Z, its texture coordinates from 0 to `repeats`.
inline std::shared_ptr<const preview::Mesh> square(float repeats)
{
    preview::Mesh mesh;
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        mesh.positions.emplace_back(2.0f * corner - 1.0f, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        mesh.texCoords.push_back(repeats * corner);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return std::make_shared<const preview::Mesh>(std::move(mesh));
}

/// It reflects nothing.
inline preview::RenderSettings squareSettings(float repeats = 1.0f)
{
    preview::RenderSettings settings;
    settings.width = settings.height = squareEdge;
    settings.samples = 1;
    settings.geometry.mesh = square(repeats);
    settings.background.kind = Backdrop::None;
    settings.camera = {.distance = 4.0f, .fieldOfView = 2.0f * std::atan(0.25f), .projection = Projection::Orthographic};
    settings.material.specular = glm::vec3(0.0f);
    return settings;
}

} // namespace mirrorball::test
