#pragma once

#include "core/preview/render_settings.h"

/// Pictures that are small enough to look at every pixel.
namespace mirrorball::test {

inline glm::dvec3 at(const Image& image, int x, int y)
{
    const float* t = image.texel(x, y);
    return {t[0], t[1], t[2]};
}

/// Of a buffer of the geometry.
inline bool isObject(const Image& buffer, int x, int y) { return buffer.texel(x, y)[3] == 1.0f; }

/// The pixel and the eight around it.
inline bool isInterior(const Image& buffer, int x, int y)
{
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            if (x + i < 0 || y + j < 0 || x + i >= buffer.width || y + j >= buffer.height || !isObject(buffer, x + i, y + j))
                return false;
    return true;
}

inline preview::RenderSettings small(GeometryKind kind)
{
    preview::RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.samples = 1;
    settings.geometry.kind = kind;
    settings.camera.yaw = 0.6f;
    settings.camera.pitch = 0.35f;
    settings.camera.distance = 3.0f;
    return settings;
}

} // namespace mirrorball::test
