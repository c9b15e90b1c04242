#pragma once

#include "roughness_law.h"

#include "core/filter/prefilter.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Levels of a prefiltered map: each a filter of its own.
namespace mirrorball {

/// What each level is filtered with: `base` at the sizes of a chain.
/// @param lobe  of every level; empty: ggx of the roughness that the law gives the level
/// @param law   empty: chainRoughness()
/// @throws InvalidArgument unless 1 <= levels <= levelCount(base.target)
std::vector<PrefilterOptions> filterChain(const PrefilterOptions& base, const std::optional<Lobe>& lobe, std::optional<RoughnessLaw> law,
                                          int levels);

/// The law of an engine's own word (engine_profile.h), or of unity or unreal, which have no profile.
/// @param option  for messages. @throws InvalidArgument for an engine that filters by itself, or no engine
RoughnessLaw lawOfEngine(const std::string& engine, const std::string& option = "--law");

/// What a filtered map's file says of it: "mirrorball:lobes", a word a level as describe() has them, and "mirrorball:indexed_by", the
/// direction that it is looked up by: "reflection", or "normal" for diffuse light.
std::map<std::string, std::string> filterAttributes(const std::vector<PrefilterOptions>& levels);

} // namespace mirrorball
