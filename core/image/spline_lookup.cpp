#include "spline_lookup.h"

#include "core/sphere/disc.h"
#include "core/sphere/dual_paraboloid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mirrorball {

namespace {

/// Weights of the uniform cubic B-spline for the texels at -1, 0, 1, 2 from the one at or before the position.
std::array<float, 4> cubicWeights(double f)
{
    const double g = 1.0 - f;
    return {static_cast<float>(g * g * g / 6.0), static_cast<float>(2.0 / 3.0 - f * f * (1.0 - 0.5 * f)),
            static_cast<float>(2.0 / 3.0 - g * g * (1.0 - 0.5 * g)), static_cast<float>(f * f * f / 6.0)};
}

double cubicBasis(double t)
{
    t = std::abs(t);
    if (t >= 2.0)
        return 0.0;
    return t < 1.0 ? 2.0 / 3.0 - t * t * (1.0 - 0.5 * t) : (2.0 - t) * (2.0 - t) * (2.0 - t) / 6.0;
}

/// A row turned into its circular running mean of a real width: whole texels, and a part of the two at the ends.
void blurRow(float* row, int texels, double width)
{
    const double reach = 0.5 * (std::min(width, static_cast<double>(texels)) - 1.0);
    const int whole = static_cast<int>(std::floor(reach));
    const double part = reach - whole;
    const double scale = 1.0 / (1.0 + 2.0 * reach);
    for (int c = 0; c < 3; ++c) {
        // prefix[i] = sum of the first i texels of the row repeated three times around
        std::vector<double> prefix(static_cast<size_t>(3 * texels) + 1, 0.0);
        for (int i = 0; i < 3 * texels; ++i)
            prefix[static_cast<size_t>(i) + 1] = prefix[static_cast<size_t>(i)] + row[3 * (i % texels) + c];
        const auto value = [&](int i) { return prefix[static_cast<size_t>(i) + 1] - prefix[static_cast<size_t>(i)]; };
        for (int x = 0; x < texels; ++x) {
            const int at = texels + x;
            const double sum = prefix[static_cast<size_t>(at + whole + 1)] - prefix[static_cast<size_t>(at - whole)] +
                               part * (value(at - whole - 1) + value(at + whole + 1));
            row[3 * x + c] = static_cast<float>(sum * scale);
        }
    }
}

/// Latlong texels as coefficients of the spline, such that energy stays where it is at the poles too.
///
/// In units of the row spacing h the basis function of row i has the mass
///   m_i = integral of B(y - y_i) |sin(h y)| dy   (|sin|: over the pole the rows come back),
/// which for the first row is 1.25 times the mass of the texels, w_i = integral of sin(h y) over the row. The coefficients are the rows'
/// energy regrouped in order from the pole: row i takes what its mass asks for, first what is left of its own, then from the next row.
/// That is exact for both the constant and the energy, and a shift of an eighth of a texel over y at y rows from the pole.
EnvironmentMap splineCoefficients(EnvironmentMap map)
{
    const int n = map.layout.size, width = 2 * n;
    const double h = pi / n;
    const auto basisMass = [&](int y) {
        constexpr double node = 0.7745966692414834; // Gauss-Legendre of 3 points on quarter-texel pieces; knots and pole lie between them
        double sum = 0.0;
        for (int piece = -8; piece < 8; ++piece) {
            const double middle = 0.25 * (piece + 0.5);
            for (const auto& [offset, weight] : {std::pair{-node, 5.0 / 18.0}, {0.0, 8.0 / 18.0}, {node, 5.0 / 18.0}}) {
                const double t = middle + 0.125 * offset;
                sum += 0.25 * weight * cubicBasis(t) * std::abs(std::sin(h * (y + 0.5 + t)));
            }
        }
        return sum;
    };
    const auto texelMass = [&](int y) { return 2.0 * std::sin(h * (y + 0.5)) * std::sin(0.5 * h) / h; };

    const EnvironmentMap before = map;
    double surplus = 0.0; // of the basis over the texels, from the pole to this row: taken from the next row
    for (int i = 0; i < n / 2; ++i) {
        const double mass = basisMass(i), own = texelMass(i) - surplus;
        const double fraction = std::clamp(own / mass, 0.0, 1.0);
        surplus = mass - own;
        for (const auto& [row, next] : {std::pair{i, i + 1}, {n - 1 - i, n - 2 - i}}) {
            const float* a = before.image.row(row);
            const float* b = before.image.row(next);
            float* out = map.image.row(row);
            for (int k = 0; k < 3 * width; ++k)
                out[k] = static_cast<float>(fraction * a[k] + (1.0 - fraction) * b[k]);
        }
    }
    return map;
}

} // namespace

EnvironmentMap smoothedPoles(EnvironmentMap map)
{
    if (map.layout.kind != Parameterization::Latlong)
        return map;
    const int n = map.layout.size, width = 2 * n;
    for (int y = 0; y < n; ++y) {
        const double texels = 1.0 / std::sin(pi / n * (y + 0.5));
        if (y == 0 || y == n - 1)
            blurRow(map.image.row(y), width, width); // around a pole itself nothing may depend on the longitude
        else if (texels > 1.0 + 1e-3)
            for (int pass = 0; pass < 3; ++pass) // three times: as smooth as the spline
                blurRow(map.image.row(y), width, texels);
    }
    return map;
}

SplineLookup::SplineLookup(EnvironmentMap map)
    : m_map(map.layout.kind == Parameterization::Latlong ? splineCoefficients(smoothedPoles(std::move(map))) : std::move(map))
{
}

glm::vec3 SplineLookup::radiance(const glm::dvec3& d) const
{
    const MapLayout& layout = m_map.layout;
    const int n = layout.size;
    const glm::dvec2 p = coordinate(layout, d);
    const int x = static_cast<int>(std::floor(p.x - 0.5)), y = static_cast<int>(std::floor(p.y - 0.5));
    const std::array<float, 4> wx = cubicWeights(p.x - 0.5 - x), wy = cubicWeights(p.y - 0.5 - y);
    const Texel chart{std::min(static_cast<int>(p.x), layout.width() - 1), std::min(static_cast<int>(p.y), layout.height() - 1)};
    const int chartWidth = layout.kind == Parameterization::Latlong ? 2 * n : n;
    const int left = chart.x / chartWidth * chartWidth, top = chart.y / n * n;
    bool inside = x - 1 >= left && x + 2 < left + chartWidth && y - 1 >= top && y + 2 < top + n;
    if (inside && (layout.kind == Parameterization::Sphere || layout.kind == Parameterization::Angular ||
                   (layout.kind == Parameterization::Paraboloid && layout.border < 2))) {
        const disc::Disc disc =
            layout.kind == Parameterization::Paraboloid ? dual_paraboloid::half(n, layout.border, chart.x >= n) : disc::inscribed(n);
        inside = disc.holdsCentre(x - 1, y - 1) && disc.holdsCentre(x + 2, y - 1) && disc.holdsCentre(x - 1, y + 2) &&
                 disc.holdsCentre(x + 2, y + 2);
    }
    glm::vec3 sum(0.0f);
    for (int j = 0; j < 4; ++j) {
        glm::vec3 rowSum(0.0f);
        for (int i = 0; i < 4; ++i) {
            Texel t{x - 1 + i, y - 1 + j};
            if (!inside)
                t = acrossSeam(layout, chart, t.x, t.y);
            const float* texel = m_map.image.texel(t.x, t.y);
            rowSum += wx[static_cast<size_t>(i)] * glm::vec3(texel[0], texel[1], texel[2]);
        }
        sum += wy[static_cast<size_t>(j)] * rowSum;
    }
    return sum;
}

} // namespace mirrorball
