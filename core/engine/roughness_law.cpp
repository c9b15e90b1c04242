#include "roughness_law.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr double babylonScale = 0.8; ///< lodGenerationScale, which its files state
constexpr double unrealScale = 1.2;

double last(int levels) { return std::max(1, levels - 1); }

} // namespace

std::string_view name(RoughnessLaw law)
{
    static constexpr std::array<std::string_view, 6> names{"linear", "filament", "babylon", "playcanvas", "unity", "unreal"};
    return names[static_cast<size_t>(law)];
}

double levelRoughness(RoughnessLaw law, int level, int levels, int width)
{
    if (level <= 0)
        return 0.0;
    const double share = std::min(1.0, level / last(levels));
    double roughness = share;
    switch (law) {
    case RoughnessLaw::Linear:
        break;
    case RoughnessLaw::Filament:
        roughness = 1.0 - std::sqrt(1.0 - share);
        break;
    case RoughnessLaw::Babylon:
        roughness = std::sqrt(std::exp2(level / babylonScale) / width);
        break;
    case RoughnessLaw::PlayCanvas:
        roughness = level / 5.0;
        break;
    case RoughnessLaw::Unity: // 0.7 r^2 - 1.7 r + share = 0
        roughness = (1.7 - std::sqrt(1.7 * 1.7 - 2.8 * share)) / 1.4;
        break;
    case RoughnessLaw::Unreal:
        roughness = std::exp2((level - levels + 3) / unrealScale);
        break;
    }
    return std::clamp(roughness, 0.0, 1.0);
}

double roughnessLevel(RoughnessLaw law, double roughness, int levels, int width)
{
    const double r = std::clamp(roughness, 0.0, 1.0);
    double level = 0.0;
    switch (law) {
    case RoughnessLaw::Linear:
        level = r * last(levels);
        break;
    case RoughnessLaw::Filament:
        level = last(levels) * r * (2.0 - r);
        break;
    case RoughnessLaw::Babylon:
        level = r > 0.0 ? babylonScale * std::log2(width * r * r) : 0.0;
        break;
    case RoughnessLaw::PlayCanvas:
        level = 5.0 * r;
        break;
    case RoughnessLaw::Unity:
        level = last(levels) * r * (1.7 - 0.7 * r);
        break;
    case RoughnessLaw::Unreal:
        level = r > 0.0 ? levels - 3 + unrealScale * std::log2(r) : 0.0;
        break;
    }
    return std::clamp(level, 0.0, last(levels));
}

} // namespace mirrorball
