#include "phong_lights.h"

#include "core/spheremap/math/fast_math.h"
#include "core/spheremap/math/light_direction.h"

#include <array>

namespace mirrorball {

namespace {
using namespace std::string_view_literals;
constexpr std::array modelWords{"r.v"sv, "n.h"sv};
constexpr std::array matchWords{"typed"sv, "matched"sv};

/// A light made ready: the highlight is max(n.axis, 0)^exponent, or of r.
struct ReadyLight {
    glm::vec3 axis{0.0f}, direction{0.0f}, color{0.0f}, diffuse{0.0f};
    float exponent = 1.0f;
};

/// max(n.axis, 0)^exponent of a light, or of r = (2 z x, 2 z y, 2 z^2 - 1).
MIRRORBALL_VECTOR_CLONES void highlight(const ReadyLight& light, bool mirror, const DiscSpan& at, float* __restrict strength)
{
    const glm::vec3 a = light.axis;
    for (int i = 0; i < at.count; ++i) {
        const float na = at.x[i] * a.x + at.y[i] * a.y + at.z[i] * a.z;
        const float c = mirror ? 2.0f * at.z[i] * na - a.z : na;
        strength[i] = c > 0.0f ? fast::pow(std::max(c, 0.0f), light.exponent) : 0.0f;
    }
}

MIRRORBALL_VECTOR_CLONES void add(int count, const float* __restrict strength, const glm::vec3& color, ColorSpan& __restrict out)
{
    for (int i = 0; i < count; ++i) {
        out.r[i] += color.r * strength[i];
        out.g[i] += color.g * strength[i];
        out.b[i] += color.b * strength[i];
    }
}
} // namespace

std::span<const std::string_view> words(PhongModel) { return modelWords; }
std::span<const std::string_view> words(ExponentMatch) { return matchWords; }

double matchedExponent(double exponent, double cosBeta)
{
    const double sine2 = 1.0 - cosBeta * cosBeta;
    if (sine2 < 1e-12)
        return 4.0 * exponent;
    return exponent * std::log1p(-2.0 * sine2) / (0.5 * std::log1p(-sine2)); // ln(2c^2 - 1) / ln c
}

double matchedExponent(double exponent)
{
    const double half = std::max(std::pow(0.5, 1.0 / std::max(exponent, 1e-3)), 1e-6); // cos alpha
    return matchedExponent(exponent, std::sqrt(0.5 * (1.0 + half)));
}

SpanGenerator prepare(const PhongLightsLayer& layer, const Level&)
{
    const bool mirror = layer.model == PhongModel::RV;
    std::vector<ReadyLight> lights;
    for (const PhongLight& light : layer.lights) {
        const glm::dvec3 l = lightDirection(light.azimuthDeg, light.polarDeg), half = l + glm::dvec3(0, 0, 1);
        const bool isBehind = glm::length(half) < 1e-6; // has no half vector, and no point of the ball mirrors it
        const glm::dvec3 axis = mirror || isBehind ? l : glm::normalize(half);
        const double exponent = !mirror && layer.match == ExponentMatch::Matched ? matchedExponent(light.exponent) : light.exponent;
        lights.push_back({glm::vec3(axis), glm::vec3(l), glm::vec3(light.color * (isBehind ? 0.0 : light.intensity)),
                          glm::vec3(light.color * light.diffuse), static_cast<float>(exponent)});
    }
    return [lights, mirror, ambient = glm::vec3(layer.ambient)](const DiscSpan& at, ColorSpan& out) {
        fill(out, at.count, ambient.r, ambient.g, ambient.b);
        std::fill_n(out.a, at.count, 1.0f);
        alignas(64) float strength[spanLength];
        for (const ReadyLight& light : lights) {
            const glm::vec3 l = light.direction;
            if (light.color != glm::vec3(0.0f)) {
                highlight(light, mirror, at, strength);
                add(at.count, strength, light.color, out);
            }
            if (light.diffuse != glm::vec3(0.0f)) {
                for (int i = 0; i < at.count; ++i)
                    strength[i] = std::max(at.x[i] * l.x + at.y[i] * l.y + at.z[i] * l.z, 0.0f);
                add(at.count, strength, light.diffuse, out);
            }
        }
    };
}

} // namespace mirrorball
