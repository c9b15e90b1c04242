#include "filter_chain.h"

#include "engine_profile.h"

#include "core/base/error.h"
#include "core/image/mip_pyramid.h"

namespace mirrorball {

std::vector<PrefilterOptions> filterChain(const PrefilterOptions& base, const std::optional<Lobe>& lobe, std::optional<RoughnessLaw> law,
                                          int levels)
{
    const int most = levelCount(base.target);
    if (levels < 1 || levels > most)
        throw InvalidArgument("levels: a map of " + std::to_string(base.target.size) + " texels has 1 to " + std::to_string(most) +
                              " levels; it is " + std::to_string(levels));
    std::vector<PrefilterOptions> chain;
    for (int i = 0; i < levels; ++i) {
        const double roughness = law ? levelRoughness(*law, i, levels, base.target.size) : chainRoughness(i, levels);
        PrefilterOptions level = base;
        level.lobe = lobe ? *lobe : ggxLobe(roughness * roughness);
        level.target = levelLayout(base.target, i);
        chain.push_back(std::move(level));
    }
    return chain;
}

RoughnessLaw lawOfEngine(const std::string& engine, const std::string& option)
{
    if (engine == "unity")
        return RoughnessLaw::Unity;
    if (engine == "unreal")
        return RoughnessLaw::Unreal;
    const EngineProfile& profile = engineProfile(engine, option);
    if (!profile.law)
        throw InvalidArgument(option + ": " + std::string(profile.title) +
                              " filters by itself and takes no levels; give it the latlong, mirrorball export --for " + engine);
    return *profile.law;
}

std::map<std::string, std::string> filterAttributes(const std::vector<PrefilterOptions>& levels)
{
    std::string lobes;
    for (const PrefilterOptions& level : levels)
        lobes += (lobes.empty() ? "" : " ") + describe(level.lobe);
    const bool byNormal = !levels.empty() && levels.front().lobe.kind == LobeKind::Diffuse;
    return {{"mirrorball:lobes", lobes}, {"mirrorball:indexed_by", byNormal ? "normal" : "reflection"}};
}

} // namespace mirrorball
