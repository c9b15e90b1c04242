#include "silhouette.h"

#include "../sphere/direction.h"

namespace mirrorball {

/// The ring's width at the angle phi is w (1 + s cos(phi - phi0)): w + s w (x cos phi0 + y sin phi0) / rho.
SpanGenerator prepare(const SilhouetteLayer& layer, const Level& level)
{
    const auto width = static_cast<float>(level.width(layer.width, layer.unit));
    const double angle = layer.swellDeg * pi / 180.0;
    const auto sx = static_cast<float>(layer.swell * std::cos(angle)), sy = static_cast<float>(layer.swell * std::sin(angle));
    const Edge edge(static_cast<float>(layer.softness) * width, static_cast<float>(level.texel()));
    return [color = glm::vec3(layer.color), width, sx, sy, edge](const DiscSpan& at, ColorSpan& out) {
        fill(out, at.count, color.r, color.g, color.b);
        for (int i = 0; i < at.count; ++i) {
            const float swell = (at.x[i] * sx + at.y[i] * sy) / std::max(at.rho[i], 1e-6f);
            out.a[i] = edge(width * (1.0f + swell) - (1.0f - at.rho[i]));
        }
    };
}

} // namespace mirrorball
