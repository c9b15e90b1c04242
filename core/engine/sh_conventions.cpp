#include "sh_conventions.h"

#include "core/sphere/direction.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

constexpr std::array conventions{ShConvention::Three, ShConvention::Filament, ShConvention::Babylon, ShConvention::Gltf};

/// %.9g tells every float apart.
std::string line(const char* format, const glm::dvec3& c)
{
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), format, c.r, c.g, c.b);
    return text.data();
}

} // namespace

std::string_view name(ShConvention convention)
{
    static constexpr std::array<std::string_view, 4> names{"three", "filament", "babylon", "gltf"};
    return names[static_cast<size_t>(convention)];
}

std::array<glm::dvec3, 9> inConvention(const RadianceSh& sh, ShConvention convention)
{
    if (convention == ShConvention::Babylon)
        return babylonPolynomial(sh);
    std::array<glm::dvec3, 9> result = sh.coefficients;
    for (int i = 0; i < 9; ++i) {
        if (convention == ShConvention::Filament)
            result[static_cast<size_t>(i)] *= shCosineFactor(i) * shNorm(i);
        if (convention == ShConvention::Gltf)
            result[static_cast<size_t>(i)] *= pi * shCosineFactor(i);
    }
    return result;
}

babylon_env::Polynomial babylonPolynomial(const RadianceSh& sh)
{
    const auto c = inConvention(sh, ShConvention::Filament);
    return {
        -2.0 / 3.0 * c[3], 2.0 / 3.0 * c[1], 2.0 / 3.0 * c[2], c[0] + 0.25 * (c[8] - c[6]), c[0] - 0.25 * (c[6] + c[8]), c[0] + 0.5 * c[6],
        0.25 * c[5],       -0.25 * c[7],     -0.25 * c[4]};
}

std::string filamentMetadata(const RadianceSh& sh)
{
    std::string text;
    for (const glm::dvec3& c : inConvention(sh, ShConvention::Filament))
        text += line("%.9g %.9g %.9g\n", c);
    return text;
}

std::string filamentText(const RadianceSh& sh)
{
    static constexpr std::array<const char*, 9> names{"L00", "L1-1", "L10", "L11", "L2-2", "L2-1", "L20", "L21", "L22"};
    std::string text;
    const auto coefficients = inConvention(sh, ShConvention::Filament);
    for (size_t i = 0; i < 9; ++i)
        text += line("(%18.15f, %18.15f, %18.15f); // ", coefficients[i]) + names[i] + ", irradiance, pre-scaled base\n";
    return text;
}

double shError(const RadianceSh& sh, const EnvironmentMap& exact)
{
    double error = 0.0, total = 0.0;
    for (int y = 0; y < exact.image.height; ++y)
        for (int x = 0; x < exact.image.width; ++x) {
            const double weight = texelSolidAngle(exact.layout, x, y);
            const float* texel = exact.image.texel(x, y);
            const glm::dvec3 truth(texel[0], texel[1], texel[2]);
            const glm::dvec3 difference = irradianceOverPi(sh, texelDirection(exact.layout, x, y)) - truth;
            error += weight * glm::dot(difference, difference);
            total += weight * glm::dot(truth, truth);
        }
    return total > 0.0 ? std::sqrt(error / total) : 0.0;
}

std::string shJson(const RadianceSh& sh, const ShQuality& quality)
{
    nlohmann::ordered_json json;
    json["rel_rms_of_irradiance"] = quality.error;
    json["rel_rms_without_the_promise"] = quality.unclampedError;
    json["least_without_the_promise"] = quality.least;
    json["non_negative"] = true;
    for (const ShConvention convention : conventions) {
        const auto coefficients = inConvention(sh, convention);
        nlohmann::ordered_json& list = json[std::string(name(convention))];
        for (const glm::dvec3& c : coefficients)
            list.push_back({c.r, c.g, c.b});
    }
    return json.dump(2) + "\n";
}

} // namespace mirrorball
