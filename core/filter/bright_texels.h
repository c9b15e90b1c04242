#pragma once

#include "lobe.h"

#include "core/image/environment_map.h"

#include <vector>

namespace mirrorball {

/// A probe split into a calm part and the excess of its few brightest texels.
///
/// A sun of some dozen texels holds most of a probe's energy and its spectrum is flat, so that a lobe with a kink at the horizon
/// (diffuse, rough ggx, small exponents), whose own spectrum falls slowly, would have to be followed to l of 1500. The sum is linear:
/// the excess of those texels goes through the lobe one by one, in closed form, and the calm rest is done by l of 100.
struct BrightTexels {
    std::vector<glm::dvec3> directions{};
    std::vector<glm::dvec3> flux{}; ///< excess radiance times texel solid angle, RGB
};

/// Whether a lobe is applied to the bright texels one by one: those with a long spectrum of their own, whose kernel is cheap.
bool splitsBrightTexels(const Lobe& lobe);

/// Takes the excess of the texels that hold more than 1/2000 of the probe's energy each, at most 96 of them, out of `latlong`.
/// @param latlong the whole probe on entry, the calm part on return
BrightTexels takeBrightTexels(EnvironmentMap& latlong);

/// Bright texels seen through a lobe: sum_b flux_b k(r.d_b), not yet divided by the filter of a constant 1.
class BrightLobe {
public:
    BrightLobe(const BrightTexels& bright, const Lobe& lobe);
    bool empty() const { return m_x.empty(); }
    /// @param weights  scratch space of the calling thread
    glm::dvec3 radiance(const glm::dvec3& r, std::vector<double>& weights) const;

private:
    Lobe m_lobe;
    LobeShape m_shape;
    std::vector<double> m_x{}, m_y{}, m_z{}, m_red{}, m_green{}, m_blue{}; ///< planes, so that the sums vectorise
};

} // namespace mirrorball
