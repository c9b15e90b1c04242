#pragma once

#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "warp.h"

namespace mirrorball {

/// A Gaussian blur on the sphere, not in the picture: the von Mises-Fisher kernel over the directions m that the texels stand for,
///   L'(n) = sum_j L_j w_j k_j / sum_j w_j k_j,  k_j = exp((n.m_j - 1)/sigma^2),  w_j the solid angle of texel j,
/// which for small sigma is the Gaussian of that standard deviation in every direction on the ball, so in the picture it narrows towards
/// the rim. Directions are normals on the front hemisphere of a map that is indexed by normal, mirror directions of one indexed by
/// reflection. A constant stays constant.
struct BlurLayer {
    static constexpr LayerKind kind{"blur", "Blur", "a Gaussian blur on the sphere", LayerRole::Warp};
    double sigmaDeg = 8.0;
    UnknownKeys unknown{};

    bool operator==(const BlurLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"sigma", "standard deviation on the sphere", 0, 90, "degrees"}, self.sigmaDeg);
    }
};

Warp prepare(const BlurLayer& layer, const Level& level);

} // namespace mirrorball
