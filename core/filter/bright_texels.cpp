#include "bright_texels.h"

#include "bright_sum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>

namespace mirrorball {

bool splitsBrightTexels(const Lobe& lobe) { return lobe.kind != LobeKind::Phong || lobe.exponent < 8.0; }

bool BrightTexelFinder::Candidate::operator<(const Candidate& other) const
{
    return std::tie(other.power, y, x) < std::tie(power, other.y, other.x);
}

void BrightTexelFinder::dropDimmest()
{
    const size_t most = brightSplits[m_deepest].mostTexels + 1; // one more says how bright the rest is
    if (m_candidates.size() <= most)
        return;
    const auto end = m_candidates.begin() + static_cast<ptrdiff_t>(most);
    std::nth_element(m_candidates.begin(), end - 1, m_candidates.end());
    m_candidates.erase(end, m_candidates.end());
    m_floor = m_candidates.back().power;
}

void BrightTexelFinder::addRows(int firstRow, int rows, const float* rgb)
{
    const int width = m_layout.width();
    m_rowPower.resize(static_cast<size_t>(m_layout.height()));
    for (int y = firstRow; y < firstRow + rows; ++y) {
        const double solidAngle = texelSolidAngle(m_layout, 0, y);
        const float least = static_cast<float>(m_floor / solidAngle * (1.0 - 1e-6)); // in float, and on the safe side
        double power = 0.0;
        for (int x = 0; x < width; ++x, rgb += 3) {
            const float sum = std::abs(rgb[0]) + std::abs(rgb[1]) + std::abs(rgb[2]);
            power += sum;
            if (sum >= least)
                m_candidates.push_back({solidAngle * sum, x, y, {rgb[0], rgb[1], rgb[2]}});
        }
        m_rowPower[static_cast<size_t>(y)] = solidAngle * power;
        if (m_candidates.size() > 4 * brightSplits[m_deepest].mostTexels)
            dropDimmest();
    }
}

BrightTexels BrightTexelFinder::take(size_t split) const
{
    const auto [mostTexels, smallestShare] = brightSplits[split];
    std::vector<Candidate> brightest = m_candidates;
    std::sort(brightest.begin(), brightest.end());
    // The share counts in the energy of what is left: beside a sun that holds nearly all of it a texel may be dim and still outshine the
    // sky.
    const double total = std::accumulate(m_rowPower.begin(), m_rowPower.end(), 0.0);
    double left = total, threshold = 0.0;
    for (int step = 0; step < 16; ++step) {
        threshold = smallestShare * left;
        double calm = total;
        for (size_t i = 0; i < std::min(mostTexels, brightest.size()) && brightest[i].power > threshold; ++i)
            calm -= brightest[i].power - threshold;
        if (calm > 0.99 * left)
            break;
        left = calm;
    }
    const auto dim = std::find_if(brightest.begin(), brightest.end(), [&](const Candidate& c) { return c.power <= threshold; });
    const auto above = static_cast<size_t>(dim - brightest.begin());
    const double level = above > mostTexels ? brightest[mostTexels].power : threshold;
    brightest.resize(std::min(above, mostTexels));

    BrightTexels bright;
    for (const Candidate& b : brightest) {
        BrightTexels::Change change{.x = b.x, .y = b.y, .before = glm::dvec3(0.0), .calm = glm::dvec3(0.0)};
        for (int c = 0; c < 3; ++c) { // what stays is a float's value, so that the two parts add up exactly
            change.before[c] = b.radiance[static_cast<size_t>(c)];
            change.calm[c] = static_cast<float>(change.before[c] * level / b.power);
        }
        bright.directions.push_back(texelDirection(m_layout, b.x, b.y));
        bright.flux.push_back((change.before - change.calm) * texelSolidAngle(m_layout, b.x, b.y));
        bright.energy += bright.flux.back();
        bright.squares += bright.flux.back() * (change.before + change.calm);
        bright.changes.push_back(change);
    }
    return bright;
}

namespace {

/// What a narrow lobe may leave out of a sum, relative to its peak: a sun of 1e12 times the dark stays right.
constexpr double supportLevel = 1e-30;

/// Texels of a group at most.
constexpr size_t groupSize = 32;

/// Divides indices into runs of neighbors: halves along the longest axis until they are few.
void divide(std::vector<size_t>& order, size_t first, size_t last, const std::vector<glm::dvec3>& at, std::vector<size_t>& ends)
{
    if (last - first <= groupSize) {
        ends.push_back(last);
        return;
    }
    glm::dvec3 low(1.0), high(-1.0);
    for (size_t i = first; i < last; ++i) {
        low = glm::min(low, at[order[i]]);
        high = glm::max(high, at[order[i]]);
    }
    const glm::dvec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const size_t middle = (first + last) / 2;
    std::nth_element(order.begin() + static_cast<ptrdiff_t>(first), order.begin() + static_cast<ptrdiff_t>(middle),
                     order.begin() + static_cast<ptrdiff_t>(last),
                     [&](size_t a, size_t b) { return std::tie(at[a][axis], a) < std::tie(at[b][axis], b); });
    divide(order, first, middle, at, ends);
    divide(order, middle, last, at, ends);
}

} // namespace

BrightLobe::BrightLobe(const BrightTexels& bright, const Lobe& lobe) : m_lobe(lobe), m_shape(lobe)
{
    const double peak = 1.0 / m_shape.integral(), reach = m_shape.support(supportLevel);
    std::vector<size_t> order(bright.directions.size()), ends;
    std::iota(order.begin(), order.end(), size_t{0});
    if (!order.empty())
        divide(order, 0, order.size(), bright.directions, ends);
    size_t first = 0;
    for (const size_t last : ends) {
        Group group{.center = glm::dvec3(0.0), .cosReach = -2.0, .first = first, .last = last};
        for (size_t i = first; i < last; ++i)
            group.center += bright.directions[order[i]];
        group.center = glm::length(group.center) > 0.0 ? glm::normalize(group.center) : bright.directions[order[first]];
        double radius = 0.0;
        for (size_t i = first; i < last; ++i) {
            const glm::dvec3& d = bright.directions[order[i]];
            radius = std::max(radius, 2.0 * std::asin(std::min(1.0, 0.5 * glm::length(d - group.center))));
            m_x.push_back(d.x);
            m_y.push_back(d.y);
            m_z.push_back(d.z);
            m_red.push_back(peak * bright.flux[order[i]].r);
            m_green.push_back(peak * bright.flux[order[i]].g);
            m_blue.push_back(peak * bright.flux[order[i]].b);
        }
        if (reach + radius < pi)
            group.cosReach = std::cos(reach + radius) - 1e-12;
        m_groups.push_back(group);
        first = last;
    }
}

glm::dvec3 BrightLobe::radiance(const glm::dvec3& r) const
{
    glm::dvec3 sum(0.0);
    const BrightPlanes planes{m_x.data(), m_y.data(), m_z.data(), m_red.data(), m_green.data(), m_blue.data()};
    for (const Group& group : m_groups)
        if (glm::dot(r, group.center) >= group.cosReach)
            sum += brightSum(planes, group.first, group.last, m_lobe, m_shape, r);
    return sum;
}

} // namespace mirrorball
