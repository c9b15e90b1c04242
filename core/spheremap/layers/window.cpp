#include "window.h"

#include "core/spheremap/math/fast_math.h"

#include "core/sphere/direction.h"

namespace mirrorball {

namespace {

/// A coordinate of the window and how fast it changes over the disc.
struct Coordinate {
    float value;
    float slope;
};

/// u (or v) at a point: (1 - k) (q - c).d + k (n.e)/(n.c). The slope follows from dn/dx = (1, 0, -x/z), dn/dy = (0, 1, -y/z).
inline Coordinate along(const glm::vec3& n, float inverseZ, const glm::vec3& center, float toCenter, const glm::vec3& e, const glm::vec2& d,
                        float curvature)
{
    const float inverse = 1.0f / std::max(toCenter, 0.05f);
    const float curved = (n.x * e.x + n.y * e.y + n.z * e.z) * inverse;
    const float flat = (n.x - center.x) * d.x + (n.y - center.y) * d.y;
    const float zx = -n.x * inverseZ, zy = -n.y * inverseZ;
    const float curvedX = (e.x + e.z * zx - curved * (center.x + center.z * zx)) * inverse;
    const float curvedY = (e.y + e.z * zy - curved * (center.y + center.z * zy)) * inverse;
    const float sx = d.x + curvature * (curvedX - d.x), sy = d.y + curvature * (curvedY - d.y);
    return {flat + curvature * (curved - flat), std::sqrt(sx * sx + sy * sy)};
}

/// The window's frame: its center on the ball, its axes there and on the disc. The first axis looks to the right on the picture, turned by
/// the tilt.
struct Frame {
    explicit Frame(const WindowLayer& layer)
    {
        const glm::dvec2 c =
            glm::dvec2(layer.centerX, layer.centerY) * std::min(1.0, 0.98 / std::max(1e-9, std::hypot(layer.centerX, layer.centerY)));
        center = glm::dvec3(c, std::sqrt(1.0 - glm::dot(c, c)));
        const glm::dvec3 right = glm::normalize(glm::dvec3(1, 0, 0) - center.x * center), up = glm::cross(center, right);
        const double tilt = layer.tiltDeg * pi / 180.0;
        const double ct = std::cos(tilt), st = std::sin(tilt);
        e1 = ct * right + st * up;
        e2 = ct * up - st * right;
        d1 = {ct, st};
        d2 = {-st, ct};
    }
    glm::dvec3 center{0.0}, e1{0.0}, e2{0.0};
    glm::dvec2 d1{0.0}, d2{0.0};
};

/// Distances to the edges of panes and of the window along one coordinate.
struct Spacing {
    float half;  ///< from the center to the middle of the outer bar
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
        const float toCenter = n.x * w.n0.x + n.y * w.n0.y + n.z * w.n0.z;
        const Coordinate a = along(n, inverseZ, w.n0, toCenter, w.e1, w.d1, w.curvature);
        const Coordinate b = along(n, inverseZ, w.n0, toCenter, w.e2, w.d2, w.curvature);
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
        out.a[i] = toCenter > 0.05f ? light + bars : 0.0f;
    }
}

} // namespace

SpanGenerator prepare(const WindowLayer& layer, const Level& level)
{
    const Frame frame(layer);
    const glm::vec3 e1(frame.e1), e2(frame.e2), n0(frame.center);
    const glm::vec2 d1(frame.d1), d2(frame.d2);
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

glm::dvec2 windowCoordinates(const WindowLayer& layer, const glm::dvec2& q)
{
    const Frame frame(layer);
    const double length = glm::length(q);
    const glm::dvec2 inside = length > 1.0 ? q / length : q;
    const glm::dvec3 n(inside, std::sqrt(std::max(1.0 - glm::dot(inside, inside), 0.0)));
    const double inverse = 1.0 / std::max(glm::dot(n, frame.center), 0.05);
    const glm::dvec2 curved(glm::dot(n, frame.e1) * inverse, glm::dot(n, frame.e2) * inverse);
    const glm::dvec2 from = inside - glm::dvec2(frame.center), flat(glm::dot(from, frame.d1), glm::dot(from, frame.d2));
    return glm::mix(flat, curved, layer.curvature);
}

glm::dvec2 windowPlace(const WindowLayer& layer, const glm::dvec2& uv)
{
    constexpr double inside = 0.9999, h = 1e-5;
    const Frame frame(layer);
    const auto kept = [](const glm::dvec2& q) {
        const double length = glm::length(q);
        return length > inside ? q * (inside / length) : q;
    };
    // The exact place for straight lines on the tangent plane, from which that of a flatter window is not far.
    glm::dvec2 q = kept(glm::dvec2(glm::normalize(frame.center + uv.x * frame.e1 + uv.y * frame.e2)));
    for (int i = 0; i < 20; ++i) {
        const glm::dvec2 off = windowCoordinates(layer, q) - uv;
        const glm::dvec2 dx =
            (windowCoordinates(layer, q + glm::dvec2(h, 0.0)) - windowCoordinates(layer, q - glm::dvec2(h, 0.0))) / (2.0 * h);
        const glm::dvec2 dy =
            (windowCoordinates(layer, q + glm::dvec2(0.0, h)) - windowCoordinates(layer, q - glm::dvec2(0.0, h))) / (2.0 * h);
        const double det = dx.x * dy.y - dx.y * dy.x;
        if (glm::length(off) < 1e-9 || std::abs(det) < 1e-9)
            break;
        q = kept(q - glm::dvec2(dy.y * off.x - dy.x * off.y, dx.x * off.y - dx.y * off.x) / det);
    }
    return q;
}

} // namespace mirrorball
