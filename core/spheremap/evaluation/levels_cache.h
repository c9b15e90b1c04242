#pragma once

#include "sphere_map_cache.h"

#include <vector>

namespace mirrorball {

/// New texels of one level of a chain.
struct LevelPatch {
    int level = 1;
    TexelRect rect{}; ///< in texels of the level
    Image texels{};
};

/// The coarser levels of a hand-made chain while an artist paints: what evaluateLevels() gives below the largest, but a stroke evaluates
/// again only what it touched of each.
class LevelsCache {
public:
    /// @param options  as of evaluateLevels(); `size` is that of level 0. @throws InvalidArgument naming the field
    explicit LevelsCache(const EvaluateOptions& options);

    /// Brings the levels to a document. @return what may have changed of levels 1, 2, ...; at first all of each
    /// @throws as evaluate(); the next update then starts afresh
    std::vector<LevelPatch> update(const SphereMapDocument& document, const JobControl& job = {});

private:
    std::vector<SphereMapCache> m_levels{}; ///< each finer than its level by a whole factor
};

} // namespace mirrorball
