#pragma once

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace mirrorball {

enum class BrdfFresnelKind {
    None,       ///< F = 1
    Dielectric, ///< exact, of a real index of refraction
    Schlick,    ///< the approximation from the reflectance at normal incidence
    Metal,      ///< exact, from the metal's spectrum through the observer
};

/// Which Fresnel term stands inside a BRDF's integral, evaluated at h.l. A value.
struct BrdfFresnel {
    BrdfFresnelKind kind = BrdfFresnelKind::None;
    double index = 1.5;  ///< dielectric: n > 0
    double f0 = 0.04;    ///< Schlick: [0, 1]
    std::string metal{}; ///< one of metalNames()
    bool operator==(const BrdfFresnel&) const = default;
};

/// F of one angle, exact: for many there is FresnelCurve. @param c  as there. @throws InvalidArgument as there
glm::dvec3 fresnelRgb(const BrdfFresnel& fresnel, double c);

/// F as RGB, made ready for many angles.
///   dielectric  fresnelDielectric(c, n)                                              000 eq. 13
///   Schlick     f0 + (1 - f0)(1 - c)^5                                               Schlick 1994
///   metal       rgb of F(lambda, c) under D65 (observer.h): (1, 1, 1) for a mirror   every wavelength by fresnelConductor()
/// A metal is a table over c, its samples 1/4096 apart and linear between them: within 1e-6 of the sum over wavelengths.
class FresnelCurve {
public:
    /// @throws InvalidArgument naming the option for an index, a reflectance or a metal that is none
    explicit FresnelCurve(const BrdfFresnel& fresnel);

    /// F at the cosine c of the angle between light and half vector, clamped to [0, 1].
    glm::dvec3 at(double c) const;
    /// Whether the three channels are alike.
    bool isGray() const { return m_fresnel.kind != BrdfFresnelKind::Metal; }
    bool isOne() const { return m_fresnel.kind == BrdfFresnelKind::None; }

private:
    BrdfFresnel m_fresnel;
    std::shared_ptr<const std::vector<glm::dvec3>> m_table{}; ///< made once for each metal
};

} // namespace mirrorball
