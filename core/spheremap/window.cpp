#include "window.h"

#include "fast_math.h"

#include "../sphere/direction.h"

namespace mirrorball {

namespace {

/// A coordinate of the window and how fast it changes over the disc.
struct Coordinate {
    float value;
    float slope;
};

/// u (or v) at a point: (1 - k) (q - c).d + k (n.e)/(n.c). The slope follows from dn/dx = (1, 0, -x/z), dn/dy = (0, 1, -y/z).
inline Coordinate along(const glm::vec3& n, float inverseZ, const glm::vec3& centre, float toCentre, const glm::vec3& e, const glm::vec2& d,
                        float curvature)
{
    const float inverse = 1.0f / std::max(toCentre, 0.05f);
    const float curved = (n.x * e.x + n.y * e.y + n.z * e.z) * inverse;
    const float flat = (n.x - centre.x) * d.x + (n.y - centre.y) * d.y;
    const float zx = -n.x * inverseZ, zy = -n.y * inverseZ;
    const float curvedX = (e.x + e.z * zx - curved * (centre.x + centre.z * zx)) * inverse;
    const float curvedY = (e.y + e.z * zy - curved * (centre.y + centre.z * zy)) * inverse;
    const float sx = d.x + curvature * (curvedX - d.x), sy = d.y + curvature * (curvedY - d.y);
    return {flat + curvature * (curved - flat), std::sqrt(sx * sx + sy * sy)};
}

/// Distances to the edges of panes and of the window along one coordinate.
struct Spacing {
    float half;  ///< from the centre to the middle of the outer bar
    float pitch; ///< from bar to bar
    float halfBar;

    float toPane(float u) const
    {
        const float s = (u + half) / pitch;
        const float nearest = std::fabs(s - fast::floor(s + 0.5f)) * pitch - halfBar;
        return std::min(nearest, half - halfBar - std::fabs(u)); // outside the window there are no panes
    }
    float toOutside(float u) const { return half + halfBar - std::fabs(u); }
};

/// A window made ready.
struct Window {
    glm::vec3 n0, e1, e2;
    glm::vec2 d1, d2;
    Spacing u, v;
    float curvature, softness, fade, frameOpacity;
    glm::vec3 pane, frame;
};

MIRRORBALL_VECTOR_CLONES void draw(const Window& w, const DiscSpan& at, ColorSpan& __restrict out)
{
    for (int i = 0; i < at.count; ++i) {
        const glm::vec3 n(at.x[i], at.y[i], at.z[i]);
        const float inverseZ = 1.0f / std::max(n.z, 0.05f);
        const float toCentre = n.x * w.n0.x + n.y * w.n0.y + n.z * w.n0.z;
        const Coordinate a = along(n, inverseZ, w.n0, toCentre, w.e1, w.d1, w.curvature);
        const Coordinate b = along(n, inverseZ, w.n0, toCentre, w.e2, w.d2, w.curvature);
        const Edge edgeU(w.softness, at.texel * a.slope), edgeV(w.softness, at.texel * b.slope);
        const float inPane = edgeU(w.u.toPane(a.value)) * edgeV(w.v.toPane(b.value));
        const float inWindow = edgeU(w.u.toOutside(a.value)) * edgeV(w.v.toOutside(b.value));
        const float height = std::min(std::max(0.5f + 0.5f * b.value / w.v.half, 0.0f), 1.0f);
        const float light = inPane * (1.0f - w.fade * (1.0f - height));
        const float bars = std::max(inWindow - inPane, 0.0f) * w.frameOpacity;
        const float share = light / std::max(light + bars, 1e-6f);
        out.r[i] = w.frame.r + share * (w.pane.r - w.frame.r);
        out.g[i] = w.frame.g + share * (w.pane.g - w.frame.g);
        out.b[i] = w.frame.b + share * (w.pane.b - w.frame.b);
        out.a[i] = toCentre > 0.05f ? light + bars : 0.0f;
    }
}

} // namespace

SpanGenerator prepare(const WindowLayer& layer, const Level& level)
{
    const glm::dvec2 c =
        glm::dvec2(layer.centerX, layer.centerY) * std::min(1.0, 0.98 / std::max(1e-9, std::hypot(layer.centerX, layer.centerY)));
    const glm::dvec3 centre(c, std::sqrt(1.0 - glm::dot(c, c)));
    // The frame at the centre whose first axis looks to the right on the picture, turned by the tilt.
    const glm::dvec3 right = glm::normalize(glm::dvec3(1, 0, 0) - centre.x * centre), up = glm::cross(centre, right);
    const double tilt = layer.tiltDeg * pi / 180.0;
    const double ct = std::cos(tilt), st = std::sin(tilt);
    const glm::vec3 e1(ct * right + st * up), e2(ct * up - st * right), n0(centre);
    const glm::vec2 d1(ct, st), d2(-st, ct);
    const auto bar = static_cast<float>(level.width(layer.frame, layer.unit));
    const Spacing u{static_cast<float>(0.5 * layer.width), static_cast<float>(layer.width / layer.columns), 0.5f * bar};
    const Spacing v{static_cast<float>(0.5 * layer.height), static_cast<float>(layer.height / layer.rows), 0.5f * bar};
    const Window window{n0,
                        e1,
                        e2,
                        d1,
                        d2,
                        u,
                        v,
                        static_cast<float>(layer.curvature),
                        static_cast<float>(layer.softness),
                        static_cast<float>(layer.fade),
                        static_cast<float>(layer.frameOpacity),
                        glm::vec3(layer.paneColor),
                        glm::vec3(layer.frameColor)};
    return [window](const DiscSpan& at, ColorSpan& out) { draw(window, at, out); };
}

} // namespace mirrorball
