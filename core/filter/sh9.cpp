#include "sh9.h"

#include "lobe.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorball {

Sh9::Sh9(const Spectrum& spectrum)
{
    assert(spectrum.bandLimit >= 2);
    for (size_t c = 0; c < 3; ++c)
        m_quadratics[c] = quadratic(spectrum, spectrum.coefficients[c]);
    m_quadratics[3] = quadratic(spectrum, spectrum.unit);
}

// The spectrum counts colatitude from +Y and azimuth along the rows, so that its own axes are (x', y', z') = (-z, x, y). There
//   sum_m a_lm Y_lm = a_l0 Y_l0 + 2 Re sum_(m>0) a_lm Y_lm,  with Condon and Shortley's sign:
//   Y_10 = sqrt(3/4pi) z',  Y_11 = -sqrt(3/8pi) (x' + i y')
//   Y_20 = sqrt(5/16pi) (3 z'^2 - 1),  Y_21 = -sqrt(15/8pi) z' (x' + i y'),  Y_22 = sqrt(15/32pi) (x' + i y')^2
Sh9::Quadratic Sh9::quadratic(const Spectrum& spectrum, const std::vector<std::complex<double>>& a)
{
    const std::vector<double> k = legendreCoefficients(diffuseLobe(), 2);
    const auto at = [&](int l, int m) { return k[static_cast<size_t>(l)] * a[spectrum.index(l, m)]; };
    const double y1 = std::sqrt(3.0 / (8.0 * pi)), y21 = std::sqrt(15.0 / (8.0 * pi)), y22 = std::sqrt(15.0 / (32.0 * pi));
    const double y20 = std::sqrt(5.0 / (16.0 * pi)) * at(2, 0).real();

    const glm::dvec3 linear(-2.0 * y1 * at(1, 1).real(), 2.0 * y1 * at(1, 1).imag(), std::sqrt(3.0 / (4.0 * pi)) * at(1, 0).real());
    const double xz = -y21 * at(2, 1).real(), yz = y21 * at(2, 1).imag(); // half of each product's factor: the form is symmetric
    const double xx = 2.0 * y22 * at(2, 2).real(), xy = -2.0 * y22 * at(2, 2).imag();
    const glm::dmat3 form(xx, xy, xz, xy, -xx, yz, xz, yz, 3.0 * y20);

    const glm::dmat3 axes(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0); // columns: x, y, z in the spectrum's axes
    return {.constant = at(0, 0).real() / std::sqrt(4.0 * pi) - y20,
            .linear = glm::transpose(axes) * linear,
            .form = glm::transpose(axes) * form * axes};
}

glm::dvec3 Sh9::irradianceOverPi(const glm::dvec3& r) const
{
    return glm::dvec3(m_quadratics[0](r), m_quadratics[1](r), m_quadratics[2](r)) / m_quadratics[3](r);
}

EnvironmentMap filterSh9(const Spectrum& spectrum, const MapLayout& target, double yaw, const JobControl& job)
{
    const Sh9 sh9(spectrum);
    EnvironmentMap map(target);
    parallelRows(map.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < map.image.width; ++x) {
                const glm::vec3 value(sh9.irradianceOverPi(yawed(texelDirection(target, x, y), -yaw)));
                std::copy_n(&value.x, 3, map.image.texel(x, y));
            }
    });
    return map;
}

} // namespace mirrorball
