#include "exact_paraboloid_sum.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// A lobe from its axis to where it ends, equally spaced over the chord 2 sin(t/2), as which it is flat at the axis; linear between.
class LobeTable {
public:
    LobeTable(const Lobe& lobe, double reach) : m_longest(2.0 * std::sin(0.5 * reach)), m_samples(last + 2)
    {
        const LobeShape shape(lobe);
        for (int i = 0; i <= last; ++i) {
            const double chord = m_longest * i / last;
            m_samples[static_cast<size_t>(i)] = shape.relative(1.0 - 0.5 * chord * chord);
        }
    }
    double longest() const { return m_longest; }
    double scale() const { return last / m_longest; }
    const double* samples() const { return m_samples.data(); }

private:
    static constexpr int last = 1 << 14;
    double m_longest;
    std::vector<double> m_samples; ///< one more than are reached, 0
};

/// Texels of a row of a half.
struct Row {
    int first = 0, last = -1;
    double x = 0.0, y = 0.0; ///< the first one's place in radii of the disc, from its middle
    double texel = 0.0;      ///< in radii
};

/// What each texel of a row weighs for the lobe about r.
MIRRORBALL_CLONES void weigh(const Row& row, const glm::dvec3& r, const LobeTable& lobe, double* __restrict weights)
{
    const double longest2 = lobe.longest() * lobe.longest(), scale = lobe.scale();
    const double* samples = lobe.samples();
    const double y = row.y, y2 = y * y;
    const int count = row.last - row.first + 1;
    for (int i = 0; i < count; ++i) {
        const double x = row.x + i * row.texel, q2 = x * x + y2, lift = 1.0 / (1.0 + q2);
        const double dx = r.x - 2.0 * lift * x, dy = r.y - 2.0 * lift * y, dz = r.z - lift * (1.0 - q2);
        const double chord2 = dx * dx + dy * dy + dz * dz;
        const double place = std::sqrt(std::min(chord2, longest2)) * scale;
        const int k = static_cast<int>(place);
        const double weight = samples[k] + (place - k) * (samples[k + 1] - samples[k]);
        weights[i] = chord2 <= longest2 ? weight : 0.0;
    }
}

/// The sum over one half for the lobe about r, which is given in the half's own axes.
glm::dvec4 sumOver(const ParaboloidHalves& halves, int half, const glm::dvec3& r, const LobeTable& lobe, std::vector<double>& weights)
{
    const int side = halves.side;
    const double middle = 0.5 * side;
    // A cap that holds the point of projection, or nearly, covers whatever it meets of the disc: look at all of it.
    const bool isCircle = r.z + std::cos(halves.reach) > 0.01;
    const CapCircle circle = isCircle ? circleOfCap(r, halves.reach) : CapCircle{{}, 4.0};
    const glm::dvec2 center(middle + halves.radius * circle.center.x, middle - halves.radius * circle.center.y);
    const double radius = halves.radius * circle.radius;
    const auto clipped = [side](double at) { return static_cast<int>(std::clamp(std::floor(at), -1.0, static_cast<double>(side))); };
    glm::dvec4 sum(0.0);
    for (int y = std::max(0, clipped(center.y - radius)); y <= std::min(side - 1, clipped(center.y + radius)); ++y) {
        const double away = std::max(0.0, std::abs(y + 0.5 - center.y) - 1.0), wide = radius * radius - away * away;
        if (wide < 0.0)
            continue;
        Row row{.y = (middle - y - 0.5) / halves.radius, .texel = 1.0 / halves.radius};
        row.first = std::max(0, clipped(center.x - std::sqrt(wide) - 1.0));
        row.last = std::min(side - 1, clipped(center.x + std::sqrt(wide) + 1.0));
        if (row.last < row.first)
            continue;
        row.x = (row.first + 0.5 - middle) / halves.radius;
        weigh(row, r, lobe, weights.data());
        const glm::vec4* texels = &halves.texels[static_cast<size_t>(2 * y + half) * static_cast<size_t>(side)];
        for (int x = row.first; x <= row.last; ++x)
            sum += weights[static_cast<size_t>(x - row.first)] * glm::dvec4(texels[x]);
    }
    return sum;
}

} // namespace

std::vector<glm::dvec3> exactParaboloidSum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job)
{
    const LobeTable lobe(halves.lobe, halves.reach);
    std::vector<glm::dvec3> result(directions.size());
    parallelRows(
        static_cast<int>(directions.size()), job,
        [&](int first, int last) {
            std::vector<double> weights(static_cast<size_t>(halves.side));
            for (int n = first; n < last; ++n) {
                const glm::dvec3 r = directions[static_cast<size_t>(n)];
                glm::dvec4 sum(0.0);
                for (int half = 0; half < 2; ++half) {
                    const glm::dvec3 own(r.x, r.y, half == 1 ? -r.z : r.z);
                    if (own.z >= halves.leastAlongAxis)
                        sum += sumOver(halves, half, own, lobe, weights);
                }
                result[static_cast<size_t>(n)] = sum.w > 0.0 ? glm::dvec3(sum) / sum.w : glm::dvec3(0.0);
            }
        },
        64);
    return result;
}

} // namespace mirrorball
