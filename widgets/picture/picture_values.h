#pragma once

#include "render_thread.h"

#include <QImage>
#include <QPoint>

#include <array>
#include <optional>

/// What the pixels of a picture are worth, as numbers.
namespace mirrorball::studio {

/// How often each display value occurs, red, green and blue apart.
using DisplayHistogram = std::array<std::array<quint32, 256>, 3>;
DisplayHistogram histogramOf(const QImage& picture);

/// A place of the whole picture in the one of its two scenes that is shown there.
struct ScenePixel {
    bool isKept = false; ///< the snapshot's
    QPoint pixel{};      ///< of the scene's own picture
};
/// @param pixel  device pixel of the whole picture; nothing where a difference is shown, or a gap
std::optional<ScenePixel> scenePixel(const PictureOrder& order, const QPoint& pixel);

/// The radiance of a pixel of the whole picture, not exposed; nothing where there is none.
std::optional<glm::vec3> lightAt(const LightPair& light, const PictureOrder& order, const QPoint& pixel);

/// Exposed values this near to 0 and 1 count as inside: texels are halves.
inline constexpr float clipSlack = 1e-3f;

/// Where exposed light, before the tone curve, is above 1 or below 0 in any channel.
struct Clipping {
    QImage marks{};                  ///< stripes over the whole picture, red above and blue below, transparent elsewhere
    double above = 0.0, below = 0.0; ///< shares of the picture
};
Clipping clippingOf(const LightPair& light, const PictureOrder& order);

/// The direction in the environment that a pixel beside the object shows; unit.
glm::dvec3 backgroundDirection(const preview::RenderSettings& settings, const QPoint& pixel);

} // namespace mirrorball::studio
