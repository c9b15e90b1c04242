#include "law_fit.h"

#include "core/engine/roughness_law.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

std::string ownerOf(RoughnessLaw law)
{
    switch (law) {
    case RoughnessLaw::Linear:
        return "glTF's viewer and Bevy";
    case RoughnessLaw::Filament:
        return "Filament and three.js";
    case RoughnessLaw::Babylon:
        return "Babylon.js";
    case RoughnessLaw::PlayCanvas:
        return "PlayCanvas' shader";
    case RoughnessLaw::Unity:
        return "Unity";
    case RoughnessLaw::Unreal:
        return "Unreal";
    }
    return {};
}

std::string formulaOf(RoughnessLaw law, int levels, int width)
{
    const std::string last = std::to_string(std::max(1, levels - 1));
    switch (law) {
    case RoughnessLaw::Linear:
        return "r = l/" + last;
    case RoughnessLaw::Filament:
        return "r = 1 - sqrt(1 - l/" + last + ")";
    case RoughnessLaw::Babylon:
        return "alpha = 2^(l/0.8)/" + std::to_string(width);
    case RoughnessLaw::PlayCanvas:
        return "r = l/5";
    case RoughnessLaw::Unity:
        return "r (1.7 - 0.7 r) = l/" + last;
    case RoughnessLaw::Unreal:
        return "r = 2^((l - " + std::to_string(levels - 3) + ")/1.2)";
    }
    return {};
}

} // namespace

std::vector<LawFit> fitLaws(const std::vector<MeasuredLevel>& levels, int width)
{
    const int count = static_cast<int>(levels.size());
    std::vector<LawFit> fits;
    const auto add = [&](std::string name, std::string owner, std::string formula, auto roughness) {
        LawFit fit{std::move(name), std::move(owner), std::move(formula), {}, 0.0};
        double sum = 0.0;
        for (int l = 0; l < count; ++l) {
            const MeasuredLevel& level = levels[static_cast<size_t>(l)];
            const double asked = std::clamp(roughness(l), 0.0, 1.0);
            fit.roughness.push_back(asked);
            // What the texels cannot tell from 0 is no difference.
            const double difference = std::max(asked, level.unresolved) - std::max(level.roughness, level.unresolved);
            sum += difference * difference;
        }
        fit.error = std::sqrt(sum / std::max(1, count - 1));
        fits.push_back(std::move(fit));
    };
    for (const RoughnessLaw law : {RoughnessLaw::Linear, RoughnessLaw::Filament, RoughnessLaw::Babylon, RoughnessLaw::PlayCanvas,
                                   RoughnessLaw::Unity, RoughnessLaw::Unreal})
        add(std::string(name(law)), ownerOf(law), formulaOf(law, count, width),
            [&](int l) { return levelRoughness(law, l, count, width); });
    add("playcanvas-generator", "PlayCanvas' own generator", "r = 2l/11", [](int l) { return 2.0 * l / 11.0; });
    add("linear-alpha", "", "alpha = l/" + std::to_string(std::max(1, count - 1)),
        [&](int l) { return std::sqrt(static_cast<double>(l) / std::max(1, count - 1)); });
    std::stable_sort(fits.begin(), fits.end(), [](const LawFit& a, const LawFit& b) { return a.error < b.error; });
    return fits;
}

} // namespace mirrorball
