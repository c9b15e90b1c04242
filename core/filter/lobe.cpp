#include "lobe.h"

#include "lobe_coefficients.h"
#include "lobe_row.h"

#include "core/base/error.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace mirrorball {

namespace {

/// Exponents beyond this make a lobe narrower than a double's dot product can tell from its axis.
constexpr double mirrorExponent = 1e15;

/// Nodes and weights of 16-point Gauss-Legendre quadrature on [-1, 1], by Newton's iteration on P_16.
struct GaussLegendre16 {
    std::array<double, 16> node{};
    std::array<double, 16> weight{};

    GaussLegendre16()
    {
        constexpr int n = 16;
        for (int i = 0; i < n; ++i) {
            double x = std::cos(pi * (i + 0.75) / (n + 0.5));
            double derivative = 1.0;
            for (int iteration = 0; iteration < 100; ++iteration) {
                double p0 = 1.0, p1 = x;
                for (int l = 2; l <= n; ++l)
                    p0 = std::exchange(p1, ((2 * l - 1) * x * p1 - (l - 1) * p0) / l);
                derivative = n * (x * p1 - p0) / (x * x - 1.0);
                const double step = p1 / derivative;
                x -= step;
                if (std::abs(step) < 1e-16)
                    break;
            }
            node[static_cast<size_t>(i)] = x;
            weight[static_cast<size_t>(i)] = 2.0 / ((1.0 - x * x) * derivative * derivative);
        }
    }
};

const GaussLegendre16& gaussLegendre16()
{
    static const GaussLegendre16 rule;
    return rule;
}

/// Ends of the panels over [0, pi/2] on which k(cos t) P_l(cos t) sin t is smooth for all l <= bandLimit: no longer than one and a
/// half periods of P_l, broken at the kinks of a tabulated lobe.
std::vector<double> panelEnds(const Lobe& lobe, int bandLimit)
{
    const double longest = 1.5 * 2.0 * pi / std::max(12, bandLimit);
    std::vector<double> kinks;
    for (size_t i = lobe.samples.size(); i-- > 0;)
        kinks.push_back(std::acos(static_cast<double>(i) / static_cast<double>(lobe.samples.size() - 1)));
    kinks.push_back(pi / 2);

    std::vector<double> ends{0.0};
    double t = 0.0;
    for (const double kink : kinks) {
        while (t < kink) {
            const double length = std::min(longest, 0.5 * std::max(t, 1.0));
            t = kink - t < 1.2 * length ? kink : t + length;
            ends.push_back(t);
        }
    }
    return ends;
}

/// k_l by quadrature, for lobes without a closed form.
std::vector<double> quadratureCoefficients(const Lobe& lobe, int bandLimit)
{
    const LobeShape shape(lobe);
    const auto& rule = gaussLegendre16();
    const std::vector<double> ends = panelEnds(lobe, bandLimit);

    std::vector<double> x, w; // nodes in cos t, weights times kernel
    x.reserve(ends.size() * 16);
    w.reserve(ends.size() * 16);
    for (size_t panel = 0; panel + 1 < ends.size(); ++panel) {
        const double half = 0.5 * (ends[panel + 1] - ends[panel]);
        const double middle = 0.5 * (ends[panel + 1] + ends[panel]);
        for (size_t i = 0; i < 16; ++i) {
            const double t = middle + half * rule.node[i];
            const double c = std::cos(t);
            x.push_back(c);
            w.push_back(2.0 * pi * half * rule.weight[i] * std::sin(t) * shape.relative(c));
        }
    }

    std::vector<double> coefficients(static_cast<size_t>(bandLimit) + 1);
    std::vector<double> previous(x.size(), 0.0), current(x.size(), 1.0);
    for (int l = 0; l <= bandLimit; ++l) {
        // Runs the recurrence (l+1) P_(l+1) = (2l+1) x P_l - l P_(l-1) over all nodes at once while it sums.
        const double a = (2.0 * l + 1.0) / (l + 1.0), b = l / (l + 1.0);
        double sum = 0.0;
        for (size_t i = 0; i < x.size(); ++i) {
            const double p = current[i];
            sum += w[i] * p;
            current[i] = a * x[i] * p - b * previous[i];
            previous[i] = p;
        }
        coefficients[static_cast<size_t>(l)] = sum;
    }
    const double k0 = coefficients[0];
    for (double& k : coefficients)
        k /= k0;
    return coefficients;
}

/// Integral of c / (A - B c)^2 over [0, 1] for A = (1 + alpha^2)/2, B = (1 - alpha^2)/2; see LobeShape for where it comes from.
/// With q = B/A it is (q/(1-q) + ln(1-q)) / (A q)^2, whose series is used where q is small (alpha near 1).
double ggxIntegral(double alpha)
{
    const double a = 0.5 * (1.0 + alpha * alpha);
    const double q = (1.0 - alpha * alpha) / (1.0 + alpha * alpha);
    if (q < 0.05) {
        double sum = 0.0, power = 1.0;
        for (int k = 0; k < 14; ++k, power *= q)
            sum += power * (k + 1.0) / (k + 2.0);
        return sum / (a * a);
    }
    // 1 - q = 2 alpha^2 / (1 + alpha^2), written out because q rounds to 1 for a small alpha.
    const double oneMinusQ = 2.0 * alpha * alpha / (1.0 + alpha * alpha);
    return (q / oneMinusQ + std::log(oneMinusQ)) / (a * a * q * q);
}

} // namespace

bool Lobe::isMirror() const { return (kind == LobeKind::Ggx && alpha < 1e-7) || (kind == LobeKind::Phong && exponent > mirrorExponent); }

Lobe phongLobe(double n)
{
    if (!std::isfinite(n) || n < 0.0)
        throw InvalidArgument("exponent: must be a finite number of at least 0");
    return {.kind = LobeKind::Phong, .exponent = n};
}

Lobe diffuseLobe() { return {.kind = LobeKind::Diffuse, .exponent = 1.0}; }

Lobe ggxLobe(double alpha)
{
    if (!(alpha >= 0.0 && alpha <= 1.0))
        throw InvalidArgument("alpha: must lie in [0, 1]; roughness R means alpha = R^2");
    return {.kind = LobeKind::Ggx, .alpha = alpha};
}

Lobe tabulatedLobe(std::vector<double> samples)
{
    if (samples.size() < 2)
        throw InvalidArgument("tabulated lobe: needs at least 2 samples over cos t in [0, 1]");
    for (const double s : samples)
        if (!std::isfinite(s) || s < 0.0)
            throw InvalidArgument("tabulated lobe: samples must be finite and not negative");
    if (*std::max_element(samples.begin(), samples.end()) <= 0.0)
        throw InvalidArgument("tabulated lobe: at least one sample must be above 0");
    return {.kind = LobeKind::Tabulated, .samples = std::move(samples)};
}

std::string describe(const Lobe& lobe)
{
    const LobeRow& row = rowOf(lobe.kind);
    std::ostringstream text;
    text << row.word;
    if (row.value)
        text << ':' << lobe.*row.value;
    else if (lobe.kind == LobeKind::Tabulated)
        text << ':' << lobe.samples.size();
    return text.str();
}

// GGX with N = V = R: the half vector lies at t/2 from N, cos^2(t/2) = (1+c)/2, so
//   D(t/2) = alpha^2 / (pi (sin^2(t/2) + alpha^2 cos^2(t/2))^2) = alpha^2 / (pi (A - B c)^2),  A = (1+alpha^2)/2, B = (1-alpha^2)/2
// and k ~ D c. At c = 1 the denominator is alpha^4, hence k(c)/k(1) = c (alpha^2 / (A - B c))^2.
LobeShape::LobeShape(const Lobe& lobe) : m_lobe(lobe)
{
    switch (lobe.kind) {
    case LobeKind::Phong:
        m_integral = 2.0 * pi / (lobe.exponent + 1.0);
        break;
    case LobeKind::Diffuse:
        m_integral = pi;
        break;
    case LobeKind::Ggx:
        m_integral = 2.0 * pi * std::pow(lobe.alpha, 4) * ggxIntegral(lobe.alpha);
        break;
    case LobeKind::Tabulated: {
        m_peak = *std::max_element(lobe.samples.begin(), lobe.samples.end());
        double sum = 0.0;
        for (size_t i = 0; i + 1 < lobe.samples.size(); ++i)
            sum += 0.5 * (lobe.samples[i] + lobe.samples[i + 1]);
        m_integral = 2.0 * pi * sum / static_cast<double>(lobe.samples.size() - 1) / m_peak;
        break;
    }
    }
}

double LobeShape::logRelative(double c) const
{
    if (c <= 0.0)
        return -std::numeric_limits<double>::infinity();
    c = std::min(c, 1.0);
    switch (m_lobe.kind) {
    case LobeKind::Phong:
        return m_lobe.exponent * std::log(c);
    case LobeKind::Diffuse:
        return std::log(c);
    case LobeKind::Ggx:
    case LobeKind::Tabulated:
        break;
    }
    return std::log(relative(c));
}

double LobeShape::relative(double c) const
{
    if (c <= 0.0)
        return 0.0;
    c = std::min(c, 1.0);
    switch (m_lobe.kind) {
    case LobeKind::Phong:
        return std::exp(m_lobe.exponent * std::log(c));
    case LobeKind::Diffuse:
        return c;
    case LobeKind::Ggx: {
        const double a2 = m_lobe.alpha * m_lobe.alpha;
        const double ratio = a2 / (0.5 * (1.0 - c) + a2 * 0.5 * (1.0 + c));
        return c * ratio * ratio;
    }
    case LobeKind::Tabulated: {
        const double position = c * static_cast<double>(m_lobe.samples.size() - 1);
        const auto i = std::min(static_cast<size_t>(position), m_lobe.samples.size() - 2);
        const double f = position - static_cast<double>(i);
        return ((1.0 - f) * m_lobe.samples[i] + f * m_lobe.samples[i + 1]) / m_peak;
    }
    }
    return 0.0;
}

double LobeShape::halfWidth() const { return support(0.5); }

double LobeShape::support(double level) const
{
    switch (m_lobe.kind) {
    case LobeKind::Phong: // cos^n t = level; 1 - c by expm1 because c rounds to 1 for large n
        if (m_lobe.exponent <= 0.0)
            return pi / 2;
        return 2.0 * std::asin(std::sqrt(0.5 * -std::expm1(std::log(level) / m_lobe.exponent)));
    case LobeKind::Diffuse:
        return std::acos(level);
    case LobeKind::Ggx: { // monotone in t: bisection
        double low = 0.0, high = pi / 2;
        for (int i = 0; i < 60; ++i) {
            const double t = 0.5 * (low + high);
            (relative(std::cos(t)) > level ? low : high) = t;
        }
        return high;
    }
    case LobeKind::Tabulated: { // not monotone: walk in from the horizon to the first sample above the level
        const auto last = m_lobe.samples.size() - 1;
        for (size_t i = 0; i <= last; ++i)
            if (m_lobe.samples[i] / m_peak > level)
                return i == 0 ? pi / 2 : std::acos(static_cast<double>(i - 1) / static_cast<double>(last));
        return 0.0;
    }
    }
    return pi / 2;
}

bool isUnresolved(const Lobe& lobe, int latlongWidth)
{
    if (lobe.isMirror())
        return true;
    return 2.0 * LobeShape(lobe).halfWidth() < 1.5 * 2.0 * pi / latlongWidth;
}

std::vector<double> legendreCoefficients(const Lobe& lobe, int bandLimit)
{
    if (lobe.isMirror())
        return std::vector<double>(static_cast<size_t>(bandLimit) + 1, 1.0);
    switch (lobe.kind) {
    case LobeKind::Phong:
        return phongCoefficients(lobe.exponent, bandLimit);
    case LobeKind::Diffuse:
        return phongCoefficients(1.0, bandLimit);
    case LobeKind::Ggx:
        return ggxCoefficients(lobe.alpha, bandLimit);
    case LobeKind::Tabulated:
        break;
    }
    return quadratureCoefficients(lobe, bandLimit);
}

} // namespace mirrorball
