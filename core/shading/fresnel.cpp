#include "fresnel.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace mirrorball {

// Equation 13 holds two differences that cancel: g - c for n near 1, and n^2 - 1 itself. With n^2 - 1 = (n - 1)(n + 1) and
// g - c = (n^2 - 1)/(g + c) nothing cancels, so that
//   F = 1/2 s^2 (1 + p^2),   s = (n^2 - 1)/(g + c)^2,   p = (c (g + c) - 1)/(c (g - c) + 1).
// s is the amplitude of the part polarised across the plane of incidence, s p that of the part in the plane (p = 0 at Brewster's
// angle). For n = 1 the surface is not there: s is 0 at every angle, also at grazing, where g + c = 0 and s would read 0/0.
// For n < 1 the denominator of p is cg + 1 - c^2 >= 0, and it is 0 only for c = 1, g = 0, that is n = 0.
double fresnelDielectric(double cosTheta, double index)
{
    const double c = std::clamp(cosTheta, 0.0, 1.0);
    const double n2m1 = (index - 1.0) * (index + 1.0);
    if (n2m1 == 0.0)
        return 0.0;
    const double g2 = n2m1 + c * c;
    if (g2 <= 0.0)
        return 1.0; // total internal reflection
    const double g = std::sqrt(g2);
    const double sum = g + c;
    const double s = n2m1 / (sum * sum);
    const double p = (c * sum - 1.0) / (c * (n2m1 / sum) + 1.0);
    return std::min(1.0, 0.5 * s * s * (1.0 + p * p));
}

// The same with eta = n + ik: w = sqrt(eta^2 - sin^2) takes the place of g, and the amplitudes
//   r_s = (c - w)/(c + w),   r_p = (eta^2 c - w)/(eta^2 c + w)
// are expanded by their own denominators, so that the factor 1 - eta^2 stands outside and nothing cancels near eta = 1:
//   r_s = (1 - eta^2)/(c + w)^2,   r_p = (eta^2 - 1)(c^2 (eta^2 + 1) - 1)/(eta^2 c + w)^2.
double fresnelConductor(double cosTheta, double n, double k)
{
    if (k == 0.0)
        return fresnelDielectric(cosTheta, n);
    const double c = std::clamp(cosTheta, 0.0, 1.0);
    const std::complex<double> eta2m1((n - 1.0) * (n + 1.0) - k * k, 2.0 * n * k);
    const std::complex<double> w = std::sqrt(eta2m1 + c * c);
    const std::complex<double> acrossSum = c + w;
    const std::complex<double> inPlaneSum = (eta2m1 + 1.0) * c + w;
    const double across = std::norm(eta2m1 / (acrossSum * acrossSum));
    const double inPlane = std::norm((eta2m1 / inPlaneSum) * ((c * c * (eta2m1 + 2.0) - 1.0) / inPlaneSum));
    return std::min(1.0, 0.5 * (across + inPlane));
}

glm::dvec3 fresnelConductor(double cosTheta, const ConductorIndex& index)
{
    return {fresnelConductor(cosTheta, index.n.x, index.k.x), fresnelConductor(cosTheta, index.n.y, index.k.y),
            fresnelConductor(cosTheta, index.n.z, index.k.z)};
}

double fresnelSchlick(double cosTheta, double f0)
{
    const double m = 1.0 - std::clamp(cosTheta, 0.0, 1.0);
    return f0 + (1.0 - f0) * (m * m) * (m * m) * m;
}

glm::dvec3 reflectance(const Fresnel& fresnel, double cosTheta)
{
    switch (fresnel.kind) {
    case FresnelKind::Dielectric:
        return glm::dvec3(fresnelDielectric(cosTheta, fresnel.index));
    case FresnelKind::Conductor:
        return fresnelConductor(cosTheta, fresnel.conductor);
    case FresnelKind::None:
        break;
    }
    return glm::dvec3(1.0);
}

void validate(const Fresnel& fresnel)
{
    if (fresnel.kind == FresnelKind::Dielectric && !(std::isfinite(fresnel.index) && fresnel.index > 0.0))
        throw InvalidArgument("fresnel: the index of refraction must be finite and greater than 0");
    if (fresnel.kind == FresnelKind::Conductor)
        for (int i = 0; i < 3; ++i) {
            const double n = fresnel.conductor.n[i], k = fresnel.conductor.k[i];
            if (!(std::isfinite(n) && n > 0.0 && std::isfinite(k) && k >= 0.0))
                throw InvalidArgument("fresnel: a conductor needs a finite n > 0 and a finite k >= 0 in every channel");
        }
}

} // namespace mirrorball
