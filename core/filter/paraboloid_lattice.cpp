#include "paraboloid_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr int taps = 8, before = 3; ///< of a stencil, and how many of them lie before the first of the two in the middle

/// Lagrange weights at f in [0, 1] between the points 0 and 1, for points -3 to 4.
std::array<float, taps> lagrangeWeights(double f)
{
    std::array<float, taps> weights{};
    for (int i = 0; i < taps; ++i) {
        double weight = 1.0;
        for (int j = 0; j < taps; ++j)
            if (j != i)
                weight *= (f - (j - before)) / (i - j);
        weights[static_cast<size_t>(i)] = static_cast<float>(weight);
    }
    return weights;
}

} // namespace

ParaboloidLattice::ParaboloidLattice(double radius, int perTexel)
    : m_step(1.0 / (radius * perTexel)), m_reach(static_cast<int>(std::ceil(radius * perTexel)) + taps / 2)
{
    const int side = 2 * m_reach + 1;
    const double farthest = 1.0 + 1.5 * taps / 2 * m_step; // the corner of a stencil about the rim
    for (int half = 0; half < 2; ++half)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::dvec2 q = m_step * glm::dvec2(x - m_reach, y - m_reach);
                const double q2 = glm::dot(q, q), scale = 1.0 / (1.0 + q2);
                if (q2 > farthest * farthest)
                    continue;
                const double z = scale * (1.0 - q2);
                m_places.push_back(static_cast<size_t>((half * side + y) * side + x));
                m_directions.emplace_back(2.0 * scale * q, half == 1 ? -z : z);
            }
}

std::vector<glm::vec3> ParaboloidLattice::read(std::span<const glm::vec3> sums, std::span<const glm::dvec3> directions,
                                               const JobControl& job) const
{
    const int side = 2 * m_reach + 1;
    std::vector<glm::vec4> square(2 * static_cast<size_t>(side) * static_cast<size_t>(side), glm::vec4(0.0f));
    for (size_t i = 0; i < m_places.size(); ++i)
        square[m_places[i]] = glm::vec4(sums[i], 0.0f);
    std::vector<glm::vec3> values(directions.size());
    parallelRows(
        static_cast<int>(directions.size()), job,
        [&](int first, int last) {
            for (int n = first; n < last; ++n) {
                const glm::dvec3& r = directions[static_cast<size_t>(n)];
                const glm::dvec2 place = glm::dvec2(r.x, r.y) / ((1.0 + std::abs(r.z)) * m_step) + static_cast<double>(m_reach);
                const glm::dvec2 corner = glm::floor(place), f = place - corner;
                const std::array<float, taps> wx = lagrangeWeights(f.x), wy = lagrangeWeights(f.y);
                const int x = static_cast<int>(corner.x) - before, y = static_cast<int>(corner.y) - before + (r.z < 0.0 ? side : 0);
                glm::vec4 value(0.0f);
                for (int j = 0; j < taps; ++j) {
                    const glm::vec4* row = &square[static_cast<size_t>(y + j) * static_cast<size_t>(side) + static_cast<size_t>(x)];
                    glm::vec4 sum(0.0f);
                    for (int i = 0; i < taps; ++i)
                        sum += wx[static_cast<size_t>(i)] * row[i];
                    value += wy[static_cast<size_t>(j)] * sum;
                }
                values[static_cast<size_t>(n)] = glm::vec3(value);
            }
        },
        4096);
    return values;
}

double latticePoints(double radius, int perTexel)
{
    const double reach = radius * perTexel + taps; // with what stencils at the rim read beyond it
    return 2.0 * pi * reach * reach;
}

int latticeDensity(const Lobe& lobe, double reach, double radius, double directions)
{
    constexpr int most = 8;
    if (lobe.kind == LobeKind::Tabulated)
        return 0;
    const LobeShape shape(lobe);
    const double texel = 2.0 / radius; // in the middle of a half
    if (shape.relative(std::cos(reach)) > 0.01 || shape.relative(std::cos(std::max(0.0, reach - texel))) > 0.03)
        return 0;
    // Five points from the peak of the lobe to half of it leave 1e-6 of the peak to the interpolation.
    const double halfWidth = radius * std::tan(0.5 * shape.support(0.5));
    int perTexel = halfWidth >= 5.0 ? 1 : 2;
    if (latticePoints(radius, perTexel) > 0.5 * directions)
        return 0;
    while (perTexel < most && latticePoints(radius, perTexel + 1) < directions / 8.0)
        ++perTexel;
    return perTexel;
}

std::optional<ParaboloidLattice> latticeFor(const ParaboloidHalves& halves, size_t directions)
{
    if (halves.kernel != ParaboloidKernel::Exact)
        return std::nullopt;
    const int perTexel = latticeDensity(halves.lobe, halves.reach, halves.radius, static_cast<double>(directions));
    return perTexel > 0 ? std::optional<ParaboloidLattice>(std::in_place, halves.radius, perTexel) : std::nullopt;
}

std::vector<glm::vec3> paraboloidSums(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const ParaboloidSums& sums,
                                      const JobControl& job)
{
    const std::optional<ParaboloidLattice> lattice = latticeFor(halves, directions.size());
    return lattice ? lattice->read(sums(lattice->directions()), directions, job) : sums(directions);
}

} // namespace mirrorball
