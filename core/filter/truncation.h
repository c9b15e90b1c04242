#pragma once

#include "spectrum.h"

#include <glm/glm.hpp>

#include <vector>

namespace mirrorball {

/// What ending a lobe's spectrum at a band limit, and reading it off rings, does to a probe: root mean squares over the sphere, an absolute
/// radiance in each channel, at most.
///
///   truncation(B)^2 = 1/(4 pi) sum_(l>B) k_l^2 p_l,    p_l the probe's power of degree l about its mean
///
/// The power is known as far as the probe's spectrum is. Beyond, it is taken to be no more than what its last degrees have per coefficient,
/// nor more together than the variance of the texels leaves over. The texels' grid repeats all of it about every multiple of the row's
/// length, eight times about the first, sixteen about the second.
class TruncationModel {
public:
    /// @param k  the lobe's Legendre coefficients; the longer, the farther band limits can be looked for
    TruncationModel(const Spectrum& spectrum, const std::vector<double>& k);

    /// The largest band limit that can be asked for.
    int longest() const { return static_cast<int>(m_tail.size()) - 1; }
    glm::dvec3 truncation(int bandLimit) const;
    /// Of a RingGrid of so many rings; see RingGrid::interpolationError().
    glm::dvec3 interpolation(int bandLimit, int rings) const;

    /// Relative error of the norm, whose repetitions beyond the band limit are not seen.
    double normError(int bandLimit) const;
    /// The smallest band limit that keeps it within that.
    int bandLimitForNorm(double relative) const;

    /// The smallest band limit whose truncation is within s * shape; -1: beyond longest().
    int bandLimitFor(double s, const glm::dvec3& shape) const;
    /// The smallest number of rings that RingGrid likes whose interpolation is within s * shape.
    int ringsFor(int bandLimit, double s, const glm::dvec3& shape) const;

    /// How the error is spread over the channels: that of the variance, the largest being 1.
    glm::dvec3 shape() const { return m_shape; }

private:
    std::vector<glm::dvec3> m_power{}; ///< k_l^2 p_l / (4 pi), continued as said above
    std::vector<glm::dvec3> m_tail{};  ///< [B]: truncation squared, without the grid's repetitions
    std::vector<double> m_largest{};   ///< [l]: the largest |k| from l on
    glm::dvec3 m_variance{0.0}, m_shape{1.0};
    int m_rowLength = 0;
    double repetitions(int bandLimit) const; ///< sum of k^2 over them, times how often
};

} // namespace mirrorball
