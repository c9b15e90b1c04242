#include "engine_lookups.h"

#include "core/shading/brdf_table.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

constexpr double leastRoughness = 0.045;

/// Angle from r of mix(r, n, share), the shorter way.
double towardsNormal(double view, double share) { return std::atan2(share * std::sin(view), 1.0 - share + share * std::cos(view)); }

/// The lookup at r', of weight 1, and the two factors of F0.
struct Read {
    BrdfLookup lookup{};
    ScaleBias ab{};
};
Read readAlongR(const EngineMaterial& material, double view)
{
    const double r = material.roughness, alpha = r * r;
    return {{.offset = towardsNormal(view, alpha * alpha), .alpha = alpha}, scaleAndBias(GgxBrdf{alpha}, view)};
}

} // namespace

EngineMaterial engineMaterial(const Brdf& brdf)
{
    const bool isMeasured = std::holds_alternative<MeasuredBrdf>(brdf.model);
    return {.roughness = std::clamp(std::sqrt(equivalentAlpha(brdf)), leastRoughness, 1.0),
            .f0 = glm::min(isMeasured ? directionalAlbedo(brdf, 0.0) : fresnelRgb(brdf.fresnel, 1.0), 1.0)};
}

LookupFit splitSum(const Brdf& brdf, double view)
{
    LookupFit fit{.view = view};
    BrdfLookup lookup{.offset = 0.0, .alpha = equivalentAlpha(brdf)};
    if (std::holds_alternative<MeasuredBrdf>(brdf.model)) {
        lookup.weight = directionalAlbedo(brdf, view); // its values have their Fresnel term inside
    } else {
        const ScaleBias ab = scaleAndBias(brdf.model, view);
        lookup.weight = fresnelRgb(brdf.fresnel, 1.0) * ab.a + ab.b;
    }
    fit.lookups.push_back(lookup);
    return fit;
}

LookupFit threeLookups(const EngineMaterial& material, double view)
{
    const auto [lookup, ab] = readAlongR(material, view);
    const double missing = 1.0 - ab.a - ab.b;
    const glm::dvec3 once = material.f0 * ab.a + ab.b, mean = material.f0 + (1.0 - material.f0) / 21.0;
    LookupFit fit{.view = view, .lookups = {lookup, {.offset = view, .alpha = 1.0}}};
    fit.lookups[0].weight = once;
    fit.lookups[1].weight = glm::max(once * mean * missing / (1.0 - missing * mean), 0.0);
    return fit;
}

LookupFit filamentLookups(const EngineMaterial& material, double view)
{
    const auto [lookup, ab] = readAlongR(material, view);
    LookupFit fit{.view = view, .lookups = {lookup}};
    fit.lookups[0].weight = (material.f0 * ab.a + ab.b) * (1.0 + material.f0 * (1.0 / (ab.a + ab.b) - 1.0));
    return fit;
}

} // namespace mirrorball
