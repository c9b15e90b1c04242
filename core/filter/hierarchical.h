#pragma once

#include "lobe.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <span>
#include <vector>

namespace mirrorball {

/// Coarse-to-fine summation: the reference sum in which a block of texels far from the lobe's edge, or dim, counts as one.
///
/// The probe's texels are the leaves of a pyramid of 2 x 2 blocks. A node keeps the flux of its texels F = sum L w, their solid angle
/// W = sum w, and where each is centered; k is taken at the centers, so that what is linear in the position within the node comes out
/// exactly and the error starts with the curvature of the lobe:
///   |error| <= 1/2 max|k''| (F var_F(x) + L_mean W var_W(x)) + max|k'| F |shift of the colors' centers|,   x = r.d
/// A node is split only where that exceeds its share of the tolerance, and the shares of all nodes add up to the whole.
/// Source: J. Kautz, P. Vazquez, W. Heidrich and H.-P. Seidel, "A Unified Approach to Prefiltered Environment Maps", 2000 (named by
/// 000 figure 13), with a bound in place of its threshold.

/// The pyramid of a latlong probe: sums are built up pairwise, in double.
class RadianceTree {
public:
    explicit RadianceTree(const EnvironmentMap& latlong, const JobControl& job = {});

    struct Node {
        glm::dvec3 flux{0.0};       ///< RGB
        glm::dvec3 fluxCenter{0.0}; ///< mean direction weighted by brightness: shorter than 1
        glm::dvec3 center{0.0};     ///< mean direction weighted by solid angle
        double brightness = 0.0;    ///< sum w (|R| + |G| + |B|)/3
        double solidAngle = 0.0;
        double fluxSpread = 0.0; ///< variance of the directions about fluxCenter, trace
        double spread = 0.0;     ///< the same about `center`
        double shift = 0.0;      ///< largest distance of a channel's center from fluxCenter, times that channel's flux
        double radius = 0.0;     ///< no texel center is farther from fluxCenter or center
    };
    /// A texel has no Node: its sums are the texel.
    struct Level {
        int width = 0, height = 0;
        std::vector<Node> nodes{};
    };
    const std::vector<Level>& levels() const { return m_levels; } ///< [0]: blocks of 2 x 2 texels
    const EnvironmentMap& map() const { return *m_map; }
    double meanBrightness() const { return m_meanBrightness; }
    /// Direction and solid angle of a texel.
    glm::dvec3 direction(int x, int y) const
    {
        const auto i = static_cast<size_t>(x), j = static_cast<size_t>(y);
        return {m_sinLon[i] * m_cosLat[j], m_sinLat[j], m_cosLon[i] * m_cosLat[j]};
    }
    double solidAngle(int y) const { return m_solidAngle[static_cast<size_t>(y)]; }

private:
    const EnvironmentMap* m_map; ///< must outlive the tree
    std::vector<Level> m_levels{};
    std::vector<double> m_sinLon{}, m_cosLon{}, m_sinLat{}, m_cosLat{}, m_solidAngle{};
    double m_meanBrightness = 0.0;
};

struct HierarchicalOptions {
    double tolerance = 1e-5; ///< what is promised, see errorLimits(); (0, 1]
};

/// How many nodes and texels were summed, over all directions: what the method's time goes into.
struct HierarchicalSums {
    std::vector<glm::dvec3> values{}; ///< as referenceSum()'s
    double terms = 0.0;
};

/// @throws InvalidArgument when the lobe is a mirror; Cancelled
HierarchicalSums hierarchicalSum(const RadianceTree& tree, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                 const HierarchicalOptions& options = {}, const JobControl& job = {});

} // namespace mirrorball
