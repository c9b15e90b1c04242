#include "colorgram.h"

#include "core/spheremap/math/cie_observer.h"
#include "core/spheremap/math/fast_math.h"
#include "core/spheremap/math/light_direction.h"

#include <array>
#include <memory>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array sourceWords{"gradient"sv, "grating"sv};
constexpr std::array groovesWords{"scattered"sv, "straight"sv, "rings"sv};

/// Color of one wavelength in Rec.709, mixed with white until no channel is negative. White light of equal energy has about the sum
/// (1, 1, 1) over [380, 780] nm after the division by the observer's Y integral, 106.9.
glm::dvec3 spectralColor(double wavelength)
{
    if (wavelength < 360.0 || wavelength > 800.0)
        return glm::dvec3(0.0);
    const glm::dvec3 rgb = rec709FromXyz(cieObserver(wavelength));
    return rgb - std::min({rgb.r, rgb.g, rgb.b, 0.0});
}

/// The diffracted color by the path difference s in nm, a table over [0, largest], read linearly.
class GratingTable {
public:
    GratingTable(double largest, int orders, double spread) : m_scale(static_cast<float>(entries / largest))
    {
        const double sigma = std::max(spread * largest * 0.5, largest / entries); // of s
        std::array<glm::dvec3, entries + 2> raw{};
        for (int i = 0; i < entries + 2; ++i)
            for (int m = 1; m <= orders; ++m)
                raw[static_cast<size_t>(i)] += spectralColor(i * largest / entries / m) / static_cast<double>(m);
        const int reach = std::min(entries, static_cast<int>(3.0 * sigma * entries / largest) + 1);
        for (int i = 0; i < entries + 2; ++i) {
            glm::dvec3 sum(0.0);
            double weights = 0.0;
            for (int j = std::max(i - reach, -entries); j <= std::min(i + reach, entries + 1); ++j) {
                const double t = (j - i) * largest / entries / sigma, w = std::exp(-0.5 * t * t);
                weights += w;
                sum += w * raw[static_cast<size_t>(std::abs(j))]; // both sides of the mirror direction are alike
            }
            m_entries[static_cast<size_t>(i)] = glm::vec3(sum / weights);
        }
    }
    glm::vec3 at(float s) const
    {
        const float scaled = s * m_scale,
                    x = scaled < static_cast<float>(entries) ? scaled : static_cast<float>(entries); // the last for NaN
        const int i = static_cast<int>(x);
        return glm::mix(m_entries[static_cast<size_t>(i)], m_entries[static_cast<size_t>(i) + 1], x - static_cast<float>(i));
    }

private:
    static constexpr int entries = 2048;
    float m_scale;
    std::array<glm::vec3, entries + 2> m_entries{};
};

SpanGenerator gratingColorgram(const ColorgramLayer& layer)
{
    const glm::dvec3 light = lightDirection(layer.azimuthDeg, layer.polarDeg);
    const glm::vec3 l(light), h(light + glm::dvec3(0, 0, 1));
    const auto table = std::make_shared<const GratingTable>(2.0 * layer.pitch, layer.orders, layer.spread);
    const auto pitch = static_cast<float>(layer.pitch), strength = static_cast<float>(layer.strength);
    const auto intensity = static_cast<float>(layer.intensity), twist = static_cast<float>(layer.twistDeg * pi / 180.0);
    const double across = (layer.grooveDeg + 90.0) * pi / 180.0;
    const auto gx = static_cast<float>(std::cos(across)), gy = static_cast<float>(std::sin(across));
    // Order 0 fills the center: path differences that a center of that radius would have under a light at the eye.
    const float zero = std::max(2.0f * pitch * static_cast<float>(layer.center), 1.0f);
    const Grooves grooves = layer.grooves;
    return [=](const DiscSpan& at, ColorSpan& out) {
        for (int i = 0; i < at.count; ++i) {
            const glm::vec3 n(at.x[i], at.y[i], at.z[i]);
            const float hn = glm::dot(h, n);
            const glm::vec3 p = h - hn * n;
            float s = 0.0f;
            if (grooves == Grooves::Scattered) {
                s = glm::length(p);
            } else {
                // g: across the grooves, in the picture; t: its unit tangent
                glm::vec2 g(gx, gy);
                if (grooves == Grooves::Rings && at.rho[i] > 1e-6f) // rings have no direction at their center: any will do
                    g = glm::vec2(n.x, n.y) / at.rho[i];
                const float turn = twist * at.rho[i], c = std::cos(turn), sn = std::sin(turn);
                g = glm::vec2(c * g.x - sn * g.y, sn * g.x + c * g.y);
                const float gn = g.x * n.x + g.y * n.y;
                const float z = std::max(n.z, 0.05f); // at the rim itself a tangent could vanish
                const glm::vec3 t(g.x - gn * n.x, g.y - gn * n.y, -gn * z);
                s = std::fabs(glm::dot(h, t)) / glm::length(t);
            }
            s *= pitch;
            const float lit = smooth((glm::dot(l, n) + 0.15f) / 0.3f); // no light reaches what faces away
            const float mirrored = fast::exp(-0.5f * (s / zero) * (s / zero));
            const glm::vec3 color = table->at(s);
            const auto mixed = [&](float c) { return intensity * lit * (mirrored + strength * c * (1.0f - mirrored)); };
            out.r[i] = mixed(color.r);
            out.g[i] = mixed(color.g);
            out.b[i] = mixed(color.b);
            out.a[i] = 1.0f;
        }
    };
}

/// t of a drawn colorgram.
struct Rings {
    float scale, center, twist, sweep, ripple, arcs;
    bool around;
};

MIRRORBALL_VECTOR_CLONES void ringParameter(const Rings& rings, const DiscSpan& at, float* __restrict t)
{
    for (int i = 0; i < at.count; ++i)
        t[i] = rings.scale * (at.rho[i] - rings.center);
    if (rings.around)
        for (int i = 0; i < at.count; ++i) {
            const float phi = fast::atan2(at.y[i], at.x[i]) + rings.twist * at.rho[i];
            t[i] += rings.sweep * phi + rings.ripple * fast::cos(rings.arcs * phi);
        }
    for (int i = 0; i < at.count; ++i)
        t[i] -= fast::floor(t[i]);
}

/// The colors over white, whole outside the center.
MIRRORBALL_VECTOR_CLONES void overWhite(const DiscSpan& at, const Edge& edge, float strength, float center, ColorSpan& __restrict out)
{
    for (int i = 0; i < at.count; ++i) {
        const float share = strength * out.a[i] * edge(at.rho[i] - center);
        out.r[i] = 1.0f + share * (out.r[i] - 1.0f);
        out.g[i] = 1.0f + share * (out.g[i] - 1.0f);
        out.b[i] = 1.0f + share * (out.b[i] - 1.0f);
        out.a[i] = 1.0f;
    }
}

SpanGenerator drawnColorgram(const ColorgramLayer& layer)
{
    const auto table = std::make_shared<const GradientTable>(layer.stops, ColorMixing::Oklab);
    const auto c = static_cast<float>(layer.center);
    const Rings rings{.scale = static_cast<float>(layer.rings) / (1.0f - c),
                      .center = c,
                      .twist = static_cast<float>(layer.twistDeg * pi / 180.0),
                      .sweep = static_cast<float>(layer.sweep / (2.0 * pi)),
                      .ripple = static_cast<float>(layer.ripple),
                      .arcs = static_cast<float>(layer.arcs),
                      .around = (layer.arcs > 0 && layer.ripple > 0.0) || layer.sweep != 0};
    const auto softness = static_cast<float>(layer.centerSoftness), strength = static_cast<float>(layer.strength);
    return [=](const DiscSpan& at, ColorSpan& out) {
        const Edge edge(softness, at.texel);
        alignas(64) float t[spanLength];
        ringParameter(rings, at, t);
        table->look(at.count, t, out);
        overWhite(at, edge, strength, c, out);
    };
}

} // namespace

std::span<const std::string_view> words(ColorgramSource) { return sourceWords; }
std::span<const std::string_view> words(Grooves) { return groovesWords; }

std::vector<GradientStop> rainbow()
{
    return {{0.0, {1.0, 0.25, 0.45}}, {0.17, {1.0, 0.55, 0.15}}, {0.33, {0.85, 0.9, 0.15}}, {0.5, {0.15, 0.85, 0.35}},
            {0.67, {0.1, 0.6, 1.0}},  {0.83, {0.45, 0.25, 1.0}}, {1.0, {1.0, 0.25, 0.45}}};
}

SpanGenerator prepare(const ColorgramLayer& layer, const Level&)
{
    return layer.source == ColorgramSource::Grating ? gratingColorgram(layer) : drawnColorgram(layer);
}

} // namespace mirrorball
