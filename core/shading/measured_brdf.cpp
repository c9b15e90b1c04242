#include "measured_brdf.h"

#include "half_angles.h"

#include "core/sphere/direction.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorball {

namespace {

/// Rusinkiewicz' coordinates of a pair of directions, as far as an isotropic material tells them apart.
struct HalfCoordinates {
    double rootH; ///< sqrt(theta_h/(pi/2)), [0, 1]
    double d;     ///< theta_d/(pi/2), [0, 1]
    double phi;   ///< phi_d/pi, [0, 1]
};

// cos(phi_d) = (n.v - n.l)/(2 sin(theta_h) sin(theta_d)): the azimuth of l about h, counted from away from n.
HalfCoordinates halfCoordinates(double nl, double nv, double lv)
{
    const HalfAngles h = halfAngles(nl, nv, lv);
    const double thetaH = std::acos(std::clamp(h.nh, 0.0, 1.0)), thetaD = std::acos(std::clamp(h.hl, 0.0, 1.0));
    const double sines = std::sin(thetaH) * std::sin(thetaD);
    const double phi = sines > 1e-12 ? std::acos(std::clamp(0.5 * (nv - nl) / sines, -1.0, 1.0)) : 0.0;
    return {std::sqrt(thetaH / (0.5 * pi)), thetaD / (0.5 * pi), phi / pi};
}

constexpr int stepsH = 90, stepsD = 90, stepsPhi = 180;

size_t cell(int h, int d, int phi)
{
    return (static_cast<size_t>(h) * stepsD + static_cast<size_t>(d)) * stepsPhi + static_cast<size_t>(phi);
}

class HalfAngleTable final : public MeasuredBrdf::Table {
public:
    explicit HalfAngleTable(std::array<std::vector<float>, 3> values) : m_values(std::move(values)) {}

    glm::dvec3 value(double nl, double nv, double lv) const override
    {
        const HalfCoordinates at = halfCoordinates(nl, nv, lv);
        const double h = std::clamp(at.rootH * stepsH - 0.5, 0.0, stepsH - 1.0), d = std::clamp(at.d * stepsD - 0.5, 0.0, stepsD - 1.0);
        const double phi = at.phi * stepsPhi - 0.5 + stepsPhi; // never below 0; phi_d has the period pi
        const int h0 = static_cast<int>(h), d0 = static_cast<int>(d), p0 = static_cast<int>(phi);
        const double th = h - h0, td = d - d0, tp = phi - p0;
        glm::dvec3 sum(0.0);
        for (int corner = 0; corner < 8; ++corner) {
            const int dh = corner & 1, dd = (corner >> 1) & 1, dp = corner >> 2;
            const double weight = (dh ? th : 1.0 - th) * (dd ? td : 1.0 - td) * (dp ? tp : 1.0 - tp);
            const size_t i = cell(std::min(h0 + dh, stepsH - 1), std::min(d0 + dd, stepsD - 1), (p0 + dp) % stepsPhi);
            sum += weight * glm::dvec3(m_values[0][i], m_values[1][i], m_values[2][i]);
        }
        return sum;
    }

private:
    std::array<std::vector<float>, 3> m_values;
};

/// The cells beside one; beyond the ends of theta there is none.
template <typename Visit>
void visitNeighbors(int h, int d, int phi, Visit&& visit)
{
    if (h > 0)
        visit(cell(h - 1, d, phi));
    if (h + 1 < stepsH)
        visit(cell(h + 1, d, phi));
    if (d > 0)
        visit(cell(h, d - 1, phi));
    if (d + 1 < stepsD)
        visit(cell(h, d + 1, phi));
    visit(cell(h, d, (phi + 1) % stepsPhi));
    visit(cell(h, d, (phi + stepsPhi - 1) % stepsPhi));
}

/// Fills holes (below 0) shell by shell from the cells that are known. @return how many there were
size_t fillHoles(std::vector<float>& values)
{
    struct Place {
        int h, d, phi;
    };
    std::vector<Place> shell;
    size_t holes = 0;
    const auto touchesKnown = [&](int h, int d, int phi) {
        bool touches = false;
        visitNeighbors(h, d, phi, [&](size_t i) { touches = touches || values[i] >= 0.0f; });
        return touches;
    };
    for (int h = 0; h < stepsH; ++h)
        for (int d = 0; d < stepsD; ++d)
            for (int phi = 0; phi < stepsPhi; ++phi)
                if (values[cell(h, d, phi)] < 0.0f) {
                    ++holes;
                    if (touchesKnown(h, d, phi))
                        shell.push_back({h, d, phi});
                }
    if (holes == values.size()) {
        std::fill(values.begin(), values.end(), 0.0f);
        return holes;
    }
    std::vector<float> filled;
    while (!shell.empty()) {
        filled.clear();
        for (const Place& p : shell) {
            float sum = 0.0f;
            int count = 0;
            visitNeighbors(p.h, p.d, p.phi, [&](size_t i) {
                if (values[i] >= 0.0f) {
                    sum += values[i];
                    ++count;
                }
            });
            filled.push_back(sum / static_cast<float>(count));
        }
        for (size_t i = 0; i < shell.size(); ++i)
            values[cell(shell[i].h, shell[i].d, shell[i].phi)] = filled[i];
        std::vector<Place> next;
        for (const Place& p : shell) {
            const auto add = [&](int h, int d, int phi) {
                if (h < 0 || h >= stepsH || d < 0 || d >= stepsD)
                    return;
                phi = (phi + stepsPhi) % stepsPhi;
                float& value = values[cell(h, d, phi)];
                if (value < 0.0f && value > -2e30f) {
                    value = -3e30f; // noted for the next shell
                    next.push_back({h, d, phi});
                }
            };
            add(p.h - 1, p.d, p.phi);
            add(p.h + 1, p.d, p.phi);
            add(p.h, p.d - 1, p.phi);
            add(p.h, p.d + 1, p.phi);
            add(p.h, p.d, p.phi - 1);
            add(p.h, p.d, p.phi + 1);
        }
        shell = std::move(next);
    }
    return holes;
}

struct ScatteredPoint {
    std::array<double, 3> place;
    std::array<double, 3> logValue; ///< ln(floor + f)
};

constexpr double floorValue = 1e-5;

struct PointCloud {
    std::vector<ScatteredPoint> points;
    size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(size_t i, size_t axis) const { return points[i].place[axis]; }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const
    {
        return false;
    }
};

std::array<double, 3> placeOf(double nl, double nv, double lv)
{
    const HalfCoordinates at = halfCoordinates(nl, nv, lv);
    const double phi = pi * std::min(at.phi, 1.0 - at.phi);
    return {at.rootH * std::cos(phi), at.rootH * std::sin(phi), at.d};
}

class ScatteredTable final : public MeasuredBrdf::Table {
public:
    explicit ScatteredTable(std::vector<ScatteredPoint> points) : m_cloud{std::move(points)}, m_tree(3, m_cloud) { m_tree.buildIndex(); }

    glm::dvec3 value(double nl, double nv, double lv) const override
    {
        constexpr size_t wanted = 9; // eight, and the one whose distance is the radius
        const std::array<double, 3> place = placeOf(nl, nv, lv);
        std::array<size_t, wanted> nearest{};
        std::array<double, wanted> squares{};
        const size_t found = m_tree.knnSearch(place.data(), wanted, nearest.data(), squares.data());
        if (squares[0] < 1e-16)
            return unlog(m_cloud.points[nearest[0]].logValue);
        const double radius = std::sqrt(squares[found - 1]) * (found < wanted ? 1.5 : 1.0) + 1e-9;
        double weights = 0.0;
        std::array<double, 3> sum{};
        for (size_t i = 0; i < found; ++i) {
            const double distance = std::sqrt(squares[i]);
            const double part = std::max(radius - distance, 0.0) / (radius * distance);
            weights += part * part;
            for (size_t c = 0; c < 3; ++c)
                sum[c] += part * part * m_cloud.points[nearest[i]].logValue[c];
        }
        if (weights <= 0.0)
            return unlog(m_cloud.points[nearest[0]].logValue);
        for (double& s : sum)
            s /= weights;
        return unlog(sum);
    }

private:
    static glm::dvec3 unlog(const std::array<double, 3>& log)
    {
        return glm::max(glm::dvec3(std::exp(log[0]), std::exp(log[1]), std::exp(log[2])) - floorValue, glm::dvec3(0.0));
    }

    PointCloud m_cloud;
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud>, PointCloud, 3, size_t> m_tree;
};

} // namespace

MeasuredBrdf halfAngleBrdf(std::string name, std::array<std::vector<float>, 3> values)
{
    MeasuredBrdf::Gaps gaps{.samples = static_cast<size_t>(stepsH) * stepsD * stepsPhi};
    for (std::vector<float>& channel : values) {
        assert(channel.size() == gaps.samples);
        gaps.holes = std::max(gaps.holes, fillHoles(channel));
    }
    return {std::move(name), std::make_shared<HalfAngleTable>(std::move(values)), gaps};
}

MeasuredBrdf scatteredBrdf(std::string name, std::vector<MeasuredBrdf::Sample> samples, MeasuredBrdf::Gaps gaps)
{
    std::vector<ScatteredPoint> points;
    points.reserve(samples.size());
    for (const MeasuredBrdf::Sample& sample : samples) {
        ScatteredPoint point{placeOf(sample.nl, sample.nv, sample.lv), {}};
        bool clamped = false;
        for (int c = 0; c < 3; ++c) {
            clamped = clamped || sample.value[c] < 0.0;
            point.logValue[static_cast<size_t>(c)] = std::log(floorValue + std::max(sample.value[c], 0.0));
        }
        gaps.clamped += clamped;
        points.push_back(point);
    }
    return {std::move(name), std::make_shared<ScatteredTable>(std::move(points)), gaps, std::move(samples)};
}

} // namespace mirrorball
