#include "irradiance_sh.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace mirrorball {

namespace {

using Nine = std::array<double, 9>;

/// A polynomial of degree 2 on the sphere: constant + linear . n + n^T form n, `form` symmetric.
struct Quadratic {
    double constant = 0.0;
    glm::dvec3 linear{0.0};
    glm::dmat3 form{0.0};
    double operator()(const glm::dvec3& n) const { return constant + glm::dot(linear, n) + glm::dot(n, form * n); }
};

/// Of sum_i e_i Y_i.
Quadratic quadratic(const Nine& e)
{
    const auto p = [&](int i) { return e[static_cast<size_t>(i)] * shNorm(i); };
    const double xy = p(4) / 2.0, yz = p(5) / 2.0, zx = p(7) / 2.0;
    return {p(0) - p(6), {p(3), p(1), p(2)}, glm::dmat3(p(8), xy, zx, xy, -p(8), yz, zx, yz, 3.0 * p(6))};
}

/// The inverse. The trace of `form` is a constant on the sphere, and 3 z^2 - 1 = 2 z^2 - x^2 - y^2.
Nine harmonics(const Quadratic& q)
{
    const double trace = q.form[0][0] + q.form[1][1] + q.form[2][2];
    const double z = (q.form[2][2] - trace / 3.0) / 2.0, xx = (q.form[0][0] - q.form[1][1]) / 2.0;
    Nine p{q.constant + trace / 3.0, q.linear.y, q.linear.z, q.linear.x, 2.0 * q.form[0][1], 2.0 * q.form[1][2], z, 2.0 * q.form[0][2], xx};
    for (int i = 0; i < 9; ++i)
        p[static_cast<size_t>(i)] /= shNorm(i);
    return p;
}

Nine irradianceOf(const RadianceSh& sh, int channel)
{
    Nine e{};
    for (int i = 0; i < 9; ++i)
        e[static_cast<size_t>(i)] = shCosineFactor(i) * sh.coefficients[static_cast<size_t>(i)][channel];
    return e;
}

double valueAt(const Nine& e, const glm::dvec3& n)
{
    double sum = 0.0;
    for (int i = 0; i < 9; ++i)
        sum += e[static_cast<size_t>(i)] * shNorm(i) * shPolynomial(i, n);
    return sum;
}

/// A symmetric matrix as its eigenvalues and, in columns, its eigenvectors: Jacobi's rotations.
struct Eigen {
    glm::dvec3 values{0.0};
    glm::dmat3 vectors{1.0};
};
Eigen eigen(glm::dmat3 a)
{
    Eigen result;
    for (int sweep = 0; sweep < 30; ++sweep)
        for (int i = 0; i < 2; ++i)
            for (int j = i + 1; j < 3; ++j) {
                if (a[i][j] == 0.0)
                    continue;
                const double angle = 0.5 * std::atan2(2.0 * a[i][j], a[j][j] - a[i][i]), c = std::cos(angle), s = std::sin(angle);
                glm::dmat3 turn(1.0);
                turn[i][i] = turn[j][j] = c;
                turn[j][i] = s;
                turn[i][j] = -s;
                a = glm::transpose(turn) * a * turn;
                result.vectors = result.vectors * turn;
            }
    result.values = {a[0][0], a[1][1], a[2][2]};
    return result;
}

/// Where the polynomial is least on the whole sphere: n = (mu - form)^-1 linear/2 for the one mu at or below the least eigenvalue that
/// makes n a unit vector. Where `linear` has nothing along that eigenvalue's vector, mu may end at it, and the vector fills what is
/// missing. Source: More and Sorensen, "Computing a Trust Region Step", 1983.
glm::dvec3 leastDirection(const Nine& e)
{
    const Quadratic q = quadratic(e);
    const Eigen axes = eigen(q.form);
    const glm::dvec3 half = 0.5 * glm::transpose(axes.vectors) * q.linear;
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (axes.values[i] < axes.values[least])
            least = i;
    const auto at = [&](double below) { // mu = least eigenvalue - below
        glm::dvec3 n(0.0);
        for (int i = 0; i < 3; ++i)
            if (const double gap = axes.values[i] - axes.values[least] + below; gap > 0.0)
                n[i] = -half[i] / gap;
        return n;
    };
    double low = 0.0, high = glm::length(half) + 1e-300; // |n| is at most |half| / below
    for (int step = 0; step < 200 && low < high; ++step) {
        const double middle = 0.5 * (low + high);
        (glm::length(at(middle)) > 1.0 ? low : high) = middle;
    }
    glm::dvec3 n = at(high);
    if (const double rest = 1.0 - glm::dot(n, n); rest > 1e-12)
        n[least] += (half[least] > 0.0 ? -1.0 : 1.0) * std::sqrt(rest);
    return glm::normalize(axes.vectors * n);
}

/// The nearest coefficients whose polynomial is at least `least` in all of the given directions: Hildreth's coordinate ascent on the
/// multipliers of the constraints.
Nine projected(const Nine& e, const std::vector<glm::dvec3>& directions, std::vector<double>& multipliers, double least)
{
    std::vector<Nine> rows;
    for (const glm::dvec3& n : directions) {
        Nine row{};
        for (int i = 0; i < 9; ++i)
            row[static_cast<size_t>(i)] = shNorm(i) * shPolynomial(i, n);
        rows.push_back(row);
    }
    multipliers.resize(rows.size(), 0.0);
    Nine x = e;
    for (size_t k = 0; k < rows.size(); ++k)
        for (size_t i = 0; i < 9; ++i)
            x[i] += multipliers[k] * rows[k][i];
    for (int sweep = 0; sweep < 2000; ++sweep) {
        double change = 0.0;
        for (size_t k = 0; k < rows.size(); ++k) {
            double value = -least, square = 0.0;
            for (size_t i = 0; i < 9; ++i) {
                value += rows[k][i] * x[i];
                square += rows[k][i] * rows[k][i];
            }
            const double step = std::max(-multipliers[k], -value / square);
            multipliers[k] += step;
            change = std::max(change, std::abs(step));
            for (size_t i = 0; i < 9; ++i)
                x[i] += step * rows[k][i];
        }
        if (change <= 1e-14 * std::abs(e[0]))
            break;
    }
    return x;
}

/// Cutting planes: the direction where the polynomial is most negative becomes a constraint, until there is none.
Nine nonNegative(const Nine& e)
{
    if (valueAt(e, leastDirection(e)) >= 0.0)
        return e;
    if (e[0] <= 0.0) // no light at all, or less: the nearest is the dark
        return {};
    const double margin = 1e-9 * e[0] * shNorm(0);
    std::vector<glm::dvec3> directions;
    std::vector<double> multipliers;
    Nine x = e;
    for (int round = 0; round < 60; ++round) {
        const glm::dvec3 worst = leastDirection(x);
        if (valueAt(x, worst) >= 0.5 * margin)
            return x;
        directions.push_back(worst);
        x = projected(e, directions, multipliers, margin);
    }
    const double missing = valueAt(x, leastDirection(x)); // what is left of the cutting is lifted away
    x[0] += std::max(0.0, -missing) * (1.0 + 1e-9) / shNorm(0);
    return x;
}

} // namespace

double shNorm(int i)
{
    static const std::array<double, 9> norms{std::sqrt(1.0 / (4.0 * pi)),  std::sqrt(3.0 / (4.0 * pi)),  std::sqrt(3.0 / (4.0 * pi)),
                                             std::sqrt(3.0 / (4.0 * pi)),  std::sqrt(15.0 / (4.0 * pi)), std::sqrt(15.0 / (4.0 * pi)),
                                             std::sqrt(5.0 / (16.0 * pi)), std::sqrt(15.0 / (4.0 * pi)), std::sqrt(15.0 / (16.0 * pi))};
    return norms[static_cast<size_t>(i)];
}

double shPolynomial(int i, const glm::dvec3& d)
{
    const std::array<double, 9> values{1.0, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3.0 * d.z * d.z - 1.0, d.z * d.x, d.x * d.x - d.y * d.y};
    return values[static_cast<size_t>(i)];
}

double shCosineFactor(int i) { return i == 0 ? 1.0 : i < 4 ? 2.0 / 3.0 : 0.25; }

// The spectrum counts colatitude from +Y and azimuth along the rows; its own axes are (x', y', z') = (-z, x, y). With Condon and
// Shortley's sign, a real function is a_l0 Y_l0 + 2 Re sum_(m > 0) a_lm Y_lm. Its polynomials, written in our axes:
//   3 z'^2 - 1 = 3 y^2 - 1 = -(3 z^2 - 1)/2 - 3/2 (x^2 - y^2),   x'^2 - y'^2 = z^2 - x^2 = (3 z^2 - 1)/2 - (x^2 - y^2)/2
RadianceSh radianceSh(const Spectrum& spectrum)
{
    assert(spectrum.bandLimit >= 2);
    RadianceSh sh;
    const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
    for (int channel = 0; channel < 3; ++channel) {
        const auto a = [&](int l, int m) { return spectrum.coefficients[static_cast<size_t>(channel)][spectrum.index(l, m)]; };
        const Nine values{a(0, 0).real(),
                          a(1, 0).real(),
                          root2 * a(1, 1).real(),
                          root2 * a(1, 1).imag(),
                          root2 * a(2, 1).imag(),
                          root2 * a(2, 1).real(),
                          -0.5 * a(2, 0).real() + std::sqrt(1.5) * a(2, 2).real(),
                          root2 * a(2, 2).imag(),
                          -0.5 * root3 * a(2, 0).real() - std::sqrt(0.5) * a(2, 2).real()};
        for (size_t i = 0; i < 9; ++i)
            sh.coefficients[i][channel] = values[i];
    }
    return sh;
}

RadianceSh turned(const RadianceSh& sh, double yaw)
{
    const glm::dvec3 x = yawed({1.0, 0.0, 0.0}, yaw), z = yawed({0.0, 0.0, 1.0}, yaw);
    const glm::dmat3 turn(x, glm::dvec3(0.0, 1.0, 0.0), z);
    RadianceSh result;
    for (int channel = 0; channel < 3; ++channel) {
        Nine l{};
        for (size_t i = 0; i < 9; ++i)
            l[i] = sh.coefficients[i][channel];
        Quadratic q = quadratic(l);
        q.linear = turn * q.linear;
        q.form = turn * q.form * glm::transpose(turn);
        const Nine back = harmonics(q);
        for (size_t i = 0; i < 9; ++i)
            result.coefficients[i][channel] = back[i];
    }
    return result;
}

glm::dvec3 irradianceOverPi(const RadianceSh& sh, const glm::dvec3& n)
{
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 9; ++i)
        sum += shCosineFactor(i) * shNorm(i) * shPolynomial(i, n) * sh.coefficients[static_cast<size_t>(i)];
    return sum;
}

glm::dvec3 leastIrradianceOverPi(const RadianceSh& sh)
{
    glm::dvec3 least;
    for (int channel = 0; channel < 3; ++channel) {
        const Nine e = irradianceOf(sh, channel);
        least[channel] = valueAt(e, leastDirection(e));
    }
    return least;
}

RadianceSh nonNegative(const RadianceSh& sh)
{
    RadianceSh result = sh;
    for (int channel = 0; channel < 3; ++channel) {
        const Nine e = irradianceOf(sh, channel);
        const Nine fit = nonNegative(e);
        if (fit != e)
            for (int i = 0; i < 9; ++i)
                result.coefficients[static_cast<size_t>(i)][channel] = fit[static_cast<size_t>(i)] / shCosineFactor(i);
    }
    return result;
}

} // namespace mirrorball
