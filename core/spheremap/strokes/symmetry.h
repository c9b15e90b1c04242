#pragma once

#include "core/base/fields.h"

#include <glm/glm.hpp>

#include <vector>

namespace mirrorball {

/// Repeats a stroke about the center of the disc: turned `radial` times, and mirrored in a line through the center. Turning and mirroring
/// the disc about its center turns and mirrors the sphere about +Z, so what is symmetric on the disc is symmetric on the model.
struct Symmetry {
    int radial = 1;
    bool mirror = false;
    double axisDeg = 90.0;
    UnknownKeys unknown{};

    bool operator==(const Symmetry&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"radial", "how often a stroke repeats around the center", 1, 64}, self.radial);
        visit(Field{"mirror", "also draws the mirror image"}, self.mirror);
        visit(Field{"axis", "the mirror line, counterclockwise from the right: 90 exchanges left and right", -360, 360, "degrees"},
              self.axisDeg);
    }
};

/// The maps of the group, the identity first: radial turns by 2 pi k / radial, then with `mirror` each of them after the reflection in
/// the axis. Columns as GLM has them: q' = M q.
std::vector<glm::dmat2> symmetryMaps(const Symmetry& symmetry);

} // namespace mirrorball
