#include "horizon_split.h"

#include "zonal_quadrature.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

HorizonSplit::HorizonSplit(const Lobe& lobe, double width) : m_lobe(lobe), m_width(width) {}

double HorizonSplit::nearShare(double s)
{
    const double c = 2.0 * std::clamp(s, 0.0, 1.0) - 1.0, c2 = c * c;
    double odd = 0.0;
    for (size_t i = std::size(nearSeries); i-- > 0;)
        odd = odd * c2 + nearSeries[i];
    return 0.5 - c * odd;
}

std::vector<double> HorizonSplit::farCoefficients(int last) const
{
    // W is a polynomial; what x^n adds at the horizon, x^(n+5), is too small to need panels of its own.
    const double scale = (m_lobe.exponent + 1.0) / (2.0 * pi);
    const int degree = static_cast<int>(std::ceil(40.0 / m_width));
    return zonalCoefficients(std::array{0.0, std::acos(m_width), pi / 2}, degree, last, [&](double, double x) {
        return x > 0.0 ? scale * std::pow(x, m_lobe.exponent) * (1.0 - nearShare(x / m_width)) : 0.0;
    });
}

} // namespace mirrorball
