#include "silhouette.h"

#include "core/sphere/direction.h"

namespace mirrorball {

namespace {
/// A ring made ready.
struct Ring {
    float width, swellX, swellY;
    Edge edge;
};

MIRRORBALL_VECTOR_CLONES void cover(const Ring& ring, const DiscSpan& at, float* __restrict opacity)
{
    for (int i = 0; i < at.count; ++i) {
        const float swell = (at.x[i] * ring.swellX + at.y[i] * ring.swellY) / std::max(at.rho[i], 1e-6f);
        opacity[i] = ring.edge(ring.width * (1.0f + swell) - (1.0f - at.rho[i]));
    }
}
} // namespace

/// The ring's width at the angle phi is w (1 + s cos(phi - phi0)): w + s w (x cos phi0 + y sin phi0) / rho.
SpanGenerator prepare(const SilhouetteLayer& layer, const Level& level)
{
    const auto width = static_cast<float>(level.width(layer.width, layer.unit));
    const double angle = layer.swellDeg * pi / 180.0;
    const Ring ring{.width = width,
                    .swellX = static_cast<float>(layer.swell * std::cos(angle)),
                    .swellY = static_cast<float>(layer.swell * std::sin(angle)),
                    .edge = Edge(static_cast<float>(layer.softness) * width, static_cast<float>(level.texel()))};
    return [color = glm::vec3(layer.color), ring](const DiscSpan& at, ColorSpan& out) {
        fill(out, at.count, color.r, color.g, color.b);
        cover(ring, at, out.a);
    };
}

} // namespace mirrorball
