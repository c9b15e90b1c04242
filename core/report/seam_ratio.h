#pragma once

#include "core/image/environment_map.h"

namespace mirrorball {

/// How visible the seams of a map are: the step in radiance from a texel over the edge of its chart (cube face, paraboloid half, the ends
/// of a latlong's rows, an octahedron's outer edges, a disc's rim) against the step from the same texel back into its chart. Both are taken
/// per radian between the texels' centers, root mean square over all such texels and channels.
struct SeamSteps {
    double across = 0.0; ///< radiance per radian
    double inside = 0.0; ///< the same

    /// About 1 where no seam shows; 0 where both vanish (a constant map); infinite where only the seam has a step.
    double ratio() const;
};

/// @param map  of at least 2 texels a chart edge; a smaller one has no inside, and both steps are 0
SeamSteps seamSteps(const EnvironmentMap& map);

} // namespace mirrorball
