#pragma once

#include "spectrum.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <array>
#include <glm/glm.hpp>

namespace mirrorball {

/// Diffuse light from nine coefficients: the spectrum up to l = 2 times k = 1, 2/3, 1/4, which is a quadratic polynomial of the normal.
///   E(r) = c_0 + c_1 . r + r^T C_2 r
/// for each channel, and for a constant 1, which normalizes as in every method.
/// Source: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001, eqs. 7-13 (over pi).
class Sh9 {
public:
    /// @param spectrum  of band limit 2 or more
    explicit Sh9(const Spectrum& spectrum);
    glm::dvec3 irradianceOverPi(const glm::dvec3& r) const;

private:
    struct Quadratic {
        double constant = 0.0;
        glm::dvec3 linear{0.0};
        glm::dmat3 form{0.0};
        double operator()(const glm::dvec3& r) const { return constant + glm::dot(linear, r) + glm::dot(r, form * r); }
    };
    static Quadratic quadratic(const Spectrum& spectrum, const std::vector<std::complex<double>>& coefficients);
    std::array<Quadratic, 4> m_quadratics{}; ///< R, G, B, a constant 1
};

/// Degrees that the method looks at: two for the map, the others for what it misses.
inline constexpr int sh9BandLimit = 24;

/// The diffuse map. @throws Cancelled
EnvironmentMap filterSh9(const Spectrum& spectrum, const MapLayout& target, double yaw, const JobControl& job = {});

} // namespace mirrorball
