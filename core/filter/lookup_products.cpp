#include "lookup_products.h"

#include "lobe.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace mirrorball {

namespace {

// Tables over an angle are even about 0 and finest there: nodes at angle = largest (i/(nodes - 1))^2.
constexpr size_t distances = 192; ///< between two axes, 0 to pi
constexpr size_t angles = 112;    ///< from r to an axis, 0 to pi

double alphaAt(size_t width)
{
    return width + 1 == LobeProducts::widths ? 1.0
                                             : std::pow(leastLookupAlpha, 1.0 - static_cast<double>(width) / (LobeProducts::widths - 1));
}

double angleAt(size_t i, size_t nodes)
{
    const double u = static_cast<double>(i) / static_cast<double>(nodes - 1);
    return pi * u * u;
}

CubicTaps angleTaps(double cosAngle, size_t nodes)
{
    return CubicTaps::at(std::sqrt(std::acos(std::clamp(cosAngle, -1.0, 1.0)) / pi) * static_cast<double>(nodes - 1), nodes);
}

/// P_l(x) for l = 0 .. L.
void legendre(double x, std::vector<double>& p)
{
    p[0] = 1.0;
    if (p.size() > 1)
        p[1] = x;
    for (size_t l = 1; l + 1 < p.size(); ++l) {
        const auto d = static_cast<double>(l);
        p[l + 1] = ((2.0 * d + 1.0) * x * p[l] - d * p[l - 1]) / (d + 1.0);
    }
}

double lobeScale(size_t l) { return (2.0 * static_cast<double>(l) + 1.0) / (4.0 * pi); }

/// All channels taken together: the mean of what each holds of degree l and order m, times the root of lobeScale(l).
double meanPart(const KernelSpectrum& spectrum, size_t l, int m)
{
    const int channels = spectrum.isGray ? 1 : 3;
    double sum = 0.0;
    for (int c = 0; c < channels; ++c)
        sum += spectrum.order(m, c)[l];
    return sum / channels * std::sqrt(lobeScale(l));
}

} // namespace

CubicTaps CubicTaps::at(double x, size_t nodes)
{
    x = std::clamp(x, 0.0, static_cast<double>(nodes - 1));
    const size_t first = std::min(static_cast<size_t>(std::max(x - 1.0, 0.0)), nodes - 4);
    const double t = x - static_cast<double>(first), a = t - 1.0, b = t - 2.0, c = t - 3.0;
    return {first, {-a * b * c / 6.0, t * b * c / 2.0, -t * a * c / 2.0, t * a * b / 6.0}};
}

std::shared_ptr<const LobeProducts> LobeProducts::of(int bandLimit)
{
    static std::mutex mutex;
    static std::map<int, std::shared_ptr<const LobeProducts>> made;
    const std::lock_guard lock(mutex);
    auto& products = made[bandLimit];
    if (!products)
        products.reset(new LobeProducts(bandLimit));
    return products;
}

LobeProducts::LobeProducts(int bandLimit)
{
    const auto degrees = static_cast<size_t>(bandLimit) + 1;
    m_k.resize(degrees * widths);
    for (size_t j = 0; j < widths; ++j) {
        const std::vector<double> k = legendreCoefficients(ggxLobe(alphaAt(j)), bandLimit);
        for (size_t l = 0; l < degrees; ++l)
            m_k[l * widths + j] = k[l];
    }
    m_products.assign(distances * widths * widths, 0.0);
    std::vector<double> p(degrees);
    for (size_t i = 0; i < distances; ++i) {
        legendre(std::cos(angleAt(i, distances)), p);
        double* to = m_products.data() + i * widths * widths;
        for (size_t l = 1; l < degrees; ++l) {
            const double* k = m_k.data() + l * widths;
            const double scale = naturalPower(static_cast<int>(l)) * lobeScale(l) * p[l];
            for (size_t a = 0; a < widths; ++a) {
                const double part = scale * k[a];
                for (size_t b = 0; b < widths; ++b)
                    to[a * widths + b] += part * k[b];
            }
        }
    }
}

CubicTaps LobeProducts::taps(double alpha)
{
    static const double step = -std::log(leastLookupAlpha) / (widths - 1);
    return CubicTaps::at(std::log(alpha / leastLookupAlpha) / step, widths);
}

double LobeProducts::at(const CubicTaps& a, const CubicTaps& b, double cosDistance) const
{
    const CubicTaps d = angleTaps(cosDistance, distances);
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        const double* slab = m_products.data() + (d.first + i) * widths * widths + a.first * widths + b.first;
        double part = 0.0;
        for (size_t j = 0; j < 4; ++j, slab += widths)
            part += a.weight[j] * (b.weight[0] * slab[0] + b.weight[1] * slab[1] + b.weight[2] * slab[2] + b.weight[3] * slab[3]);
        sum += d.weight[i] * part;
    }
    return sum;
}

KernelProducts::KernelProducts(const KernelSpectrum& spectrum) : m_lobes(LobeProducts::of(spectrum.bandLimit))
{
    const auto degrees = static_cast<size_t>(spectrum.bandLimit) + 1;
    const auto allOrders = static_cast<size_t>(spectrum.orders) + 1;
    std::vector<double> power(allOrders, 0.0); // what of the square each order holds
    for (size_t m = 0; m < allOrders; ++m)
        for (size_t l = std::max(m, size_t{1}); l < degrees; ++l) {
            const double part = meanPart(spectrum, l, static_cast<int>(m));
            power[m] += naturalPower(static_cast<int>(l)) * part * part * (m == 0 ? 1.0 : 0.5);
        }
    for (const double part : power)
        m_square += part;
    m_orders = allOrders;
    for (double left = 0.0; m_orders > 1 && (left += power[m_orders - 1]) < 1e-7 * m_square;)
        --m_orders;

    m_products.assign(angles * m_orders * LobeProducts::widths, 0.0);
    const std::vector<double>& k = m_lobes->coefficients();
    std::vector<double> lambda(degrees), part(degrees);
    for (size_t m = 0; m < m_orders; ++m) {
        const OrderHarmonics harmonics(static_cast<int>(m), spectrum.bandLimit);
        for (size_t l = m; l < degrees; ++l)
            part[l] = naturalPower(static_cast<int>(l)) * meanPart(spectrum, l, static_cast<int>(m));
        for (size_t i = 0; i < angles; ++i) {
            harmonics.at(angleAt(i, angles), lambda);
            double* to = m_products.data() + (i * m_orders + m) * LobeProducts::widths;
            for (size_t l = std::max(m, size_t{1}); l < degrees; ++l) {
                const double value = part[l] * lambda[l];
                if (std::abs(value) < 1e-14)
                    continue;
                const double* lobe = k.data() + l * LobeProducts::widths;
                for (size_t j = 0; j < LobeProducts::widths; ++j)
                    to[j] += value * lobe[j];
            }
        }
    }
}

double KernelProducts::at(const CubicTaps& alpha, const glm::dvec3& axis) const
{
    const CubicTaps angle = angleTaps(axis.z, angles);
    const double across = std::hypot(axis.x, axis.y), twice = across > 0.0 ? 2.0 * axis.x / across : 2.0;
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        const double* row = m_products.data() + (angle.first + i) * m_orders * LobeProducts::widths + alpha.first;
        double before = 0.5 * twice, now = 1.0, part = 0.0; // cos((m - 1) chi), cos(m chi)
        for (size_t m = 0; m < m_orders; ++m, row += LobeProducts::widths) {
            part += now * (alpha.weight[0] * row[0] + alpha.weight[1] * row[1] + alpha.weight[2] * row[2] + alpha.weight[3] * row[3]);
            const double next = twice * now - before;
            before = now;
            now = next;
        }
        sum += angle.weight[i] * part;
    }
    return sum;
}

ExactProducts::ExactProducts(const KernelSpectrum& spectrum) : m_spectrum(spectrum)
{
    for (int m = 0; m <= spectrum.orders; ++m)
        m_harmonics.emplace_back(m, spectrum.bandLimit);
}

std::vector<double> ExactProducts::lobe(double alpha) const { return legendreCoefficients(ggxLobe(alpha), m_spectrum.bandLimit); }

glm::dvec3 ExactProducts::kernel(const std::vector<double>& lobe, const glm::dvec3& axis) const
{
    const auto degrees = static_cast<size_t>(m_spectrum.bandLimit) + 1;
    const double gamma = std::acos(std::clamp(axis.z, -1.0, 1.0)), chi = std::atan2(axis.y, axis.x);
    std::vector<double> lambda(degrees);
    glm::dvec3 sum(0.0);
    for (int m = 0; m <= m_spectrum.orders; ++m) {
        m_harmonics[static_cast<size_t>(m)].at(gamma, lambda);
        const double turned = std::cos(m * chi);
        for (size_t l = static_cast<size_t>(std::max(m, 1)); l < degrees; ++l)
            lambda[l] *= naturalPower(static_cast<int>(l)) * lobe[l] * std::sqrt(lobeScale(l)) * turned;
        for (int c = 0; c < (m_spectrum.isGray ? 1 : 3); ++c)
            for (size_t l = static_cast<size_t>(std::max(m, 1)); l < degrees; ++l)
                sum[c] += m_spectrum.order(m, c)[l] * lambda[l];
    }
    return m_spectrum.isGray ? glm::dvec3(sum.x) : sum;
}

double ExactProducts::lobes(const std::vector<double>& a, const std::vector<double>& b, double cosDistance) const
{
    std::vector<double> p(a.size());
    legendre(cosDistance, p);
    double sum = 0.0;
    for (size_t l = 1; l < a.size(); ++l)
        sum += naturalPower(static_cast<int>(l)) * a[l] * b[l] * lobeScale(l) * p[l];
    return sum;
}

double ExactProducts::square(int channel) const
{
    double sum = 0.0;
    for (int m = 0; m <= m_spectrum.orders; ++m)
        for (int l = std::max(m, 1); l <= m_spectrum.bandLimit; ++l)
            sum += naturalPower(l) * m_spectrum.term(l, m, channel);
    return sum;
}

} // namespace mirrorball
