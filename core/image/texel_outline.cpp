#include "texel_outline.h"

#include "core/sphere/cube_map.h"
#include "core/sphere/disc.h"
#include "core/sphere/dual_paraboloid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace mirrorball {

namespace {

constexpr double offChart = 1e9; ///< a bend larger than any tolerance
constexpr double samePoint = 1e-13;
constexpr double least = 1e-9; ///< texels: what is smaller is rounding

bool isOnRim(const MapLayout& layout, const glm::dvec2& p)
{
    const glm::dvec2 q = disc::inscribed(layout.size).fromImage(p);
    return std::abs(glm::dot(q, q) - 1.0) < 1e-12;
}

double twiceArea(const std::vector<glm::dvec2>& corners)
{
    double sum = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 &a = corners[i] - corners[0], &b = corners[(i + 1) % corners.size()] - corners[0];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum;
}

} // namespace

glm::dvec3 TexelOutlines::directionIn(int x, int y, const glm::dvec2& p) const
{
    const int n = m_target.size;
    glm::dvec3 d;
    switch (mapping(m_target.kind).charts) {
    case Charts::Faces: {
        const int face = y / n;
        d = glm::normalize(cube_map::facePoint(face, 2.0 * p.x / n - 1.0, 2.0 * (p.y - static_cast<double>(face) * n) / n - 1.0));
        break;
    }
    case Charts::Halves: {
        const glm::dvec2 q = dual_paraboloid::half(n, m_target.border, x >= n).fromImage(p);
        const double rho2 = glm::dot(q, q), scale = 1.0 / (1.0 + rho2), z = (1.0 - rho2) * scale;
        d = {2.0 * q.x * scale, 2.0 * q.y * scale, x >= n ? -z : z};
        break;
    }
    case Charts::Disc: // to either side of the rim rounding would put it on either side of -Z
        d = isOnRim(m_target, p) ? glm::dvec3(0.0, 0.0, -1.0) : direction(m_target, p);
        break;
    case Charts::Whole:
        d = direction(m_target, p);
        break;
    }
    return turnedBack(d);
}

void TexelOutlines::directions(int x, int y, const Places& places, double* dx, double* dy, double* dz) const
{
    const int n = m_target.size;
    const glm::dvec2 &first = places.first, &step = places.step;
    const auto put = [&](const glm::dvec3& d) {
        *dx++ = d.x;
        *dy++ = d.y;
        *dz++ = d.z;
    };
    if (m_target.kind == Parameterization::Cube) { // linear in either
        const int face = y / n;
        const auto at = [&](double s, double t) {
            const glm::dvec3 d = cube_map::facePoint(face, s, t);
            return turnedBack(d);
        };
        const glm::dvec3 middle = at(0.0, 0.0), alongS = at(1.0, 0.0) - middle, alongT = at(0.0, 1.0) - middle;
        for (int j = 0; j < places.rows; ++j) {
            const glm::dvec3 left = middle + (2.0 * (first.y + step.y * j - static_cast<double>(face) * n) / n - 1.0) * alongT;
            for (int i = 0; i < places.columns; ++i)
                put(left + (2.0 * (first.x + step.x * i) / n - 1.0) * alongS);
        }
        return;
    }
    if (m_target.kind == Parameterization::Latlong && !m_turns) { // separable
        std::vector<glm::dvec2> meridians;
        for (int i = 0; i < places.columns; ++i) {
            const glm::dvec3 d = directionIn(x, y, {first.x + step.x * i, 0.5 * n});
            meridians.emplace_back(d.x, d.z);
        }
        for (int j = 0; j < places.rows; ++j) {
            const double row = first.y + step.y * j, latitude = 0.5 * pi - row * pi / n;
            const double sine = std::sin(latitude), cosine = row == 0.0 || row == n ? 0.0 : std::cos(latitude);
            for (const glm::dvec2& m : meridians)
                put({cosine * m.x, sine, cosine * m.y});
        }
        return;
    }
    for (int j = 0; j < places.rows; ++j)
        for (int i = 0; i < places.columns; ++i)
            put(directionIn(x, y, {first.x + step.x * i, first.y + step.y * j}));
}

bool TexelOutlines::endsAtRim(int x, int y) const
{
    if (!disc::hasRim(m_target) || !isInside(m_target, x, y))
        return false;
    const disc::Disc disc = disc::at(m_target, x);
    const double dx = std::max(std::abs(x - disc.center.x), std::abs(x + 1 - disc.center.x));
    const double dy = std::max(std::abs(y - disc.center.y), std::abs(y + 1 - disc.center.y));
    return dx * dx + dy * dy > disc.radius * disc.radius;
}

double TexelOutlines::bendBetween(const glm::dvec3& d0, const glm::dvec3& middle, const glm::dvec3& d1) const
{
    const unsigned common = m_source.chartsOf(d0) & m_source.chartsOf(middle) & m_source.chartsOf(d1);
    if (common == 0)
        return offChart;
    const int chart = std::countr_zero(common);
    const glm::dvec2 off =
        0.5 * (m_source.position(chart, d0, middle) + m_source.position(chart, d1, middle)) - m_source.position(chart, middle, d0);
    return std::max(std::abs(off.x), std::abs(off.y));
}

double TexelOutlines::bend(int x, int y, const glm::dvec2& from, const glm::dvec2& to) const
{
    return bendBetween(directionIn(x, y, from), directionIn(x, y, 0.5 * (from + to)), directionIn(x, y, to));
}

int TexelOutlines::halvings(double bend)
{
    int count = 0;
    for (; bend > outlineTolerance && count < mostHalvings; bend *= 0.25)
        ++count;
    return count;
}

/// Appends the points after d0 up to and with d1. An edge that leaves its chart is halved until its parts do not.
template <class At>
void TexelOutlines::follow(const At& at, double t0, const glm::dvec3& d0, double t1, const glm::dvec3& d1, int depth,
                           std::vector<glm::dvec3>& out) const
{
    const double t = 0.5 * (t0 + t1);
    const glm::dvec3 middle = at(t);
    const double bend = bendBetween(d0, middle, d1);
    if (bend == offChart && depth < mostHalvings) {
        follow(at, t0, d0, t, middle, depth + 1, out);
        follow(at, t, middle, t1, d1, depth + 1, out);
        return;
    }
    const int parts = bend == offChart ? 1 : 1 << halvings(bend);
    for (int i = 1; i < parts; ++i)
        out.push_back(at(t0 + (t1 - t0) * i / parts));
    out.push_back(d1);
}

std::vector<glm::dvec3> TexelOutlines::boundary(int x, int y, Rim rim) const
{
    if (rim == Rim::Ends && endsAtRim(x, y))
        return clippedBoundary(x, y);
    const std::array<glm::dvec2, 4> corners{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
    std::vector<glm::dvec3> points;
    for (size_t i = 0; i < 4; ++i) {
        const glm::dvec2 from = corners[i], to = corners[(i + 1) % 4];
        const auto at = [&](double t) { return directionIn(x, y, glm::mix(from, to, t)); };
        follow(at, 0.0, at(0.0), 1.0, at(1.0), 0, points);
    }
    return points;
}

/// The square within the disc: parts of its sides, joined by arcs of the rim.
std::vector<glm::dvec3> TexelOutlines::clippedBoundary(int x, int y) const
{
    const disc::Disc disc = disc::at(m_target, x);
    const std::array<glm::dvec2, 4> corners{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
    struct Side {
        glm::dvec2 from, to;
    };
    std::vector<Side> kept;
    for (size_t i = 0; i < 4; ++i) {
        const glm::dvec2 a = corners[i] - disc.center, step = corners[(i + 1) % 4] - corners[i];
        // |a + t step| = radius, with |step| = 1
        const double b = glm::dot(a, step), c = glm::dot(a, a) - disc.radius * disc.radius, root2 = b * b - c;
        if (root2 <= 0.0)
            continue;
        const double root = std::sqrt(root2), t0 = std::max(0.0, -b - root), t1 = std::min(1.0, -b + root);
        if (t1 > t0)
            kept.push_back({corners[i] + t0 * step, corners[i] + t1 * step});
    }
    std::vector<glm::dvec3> points;
    const auto angleOf = [&](const glm::dvec2& p) { return std::atan2(p.y - disc.center.y, p.x - disc.center.x); };
    for (size_t i = 0; i < kept.size(); ++i) {
        const Side &side = kept[i], &next = kept[(i + 1) % kept.size()];
        const auto along = [&](double t) { return directionIn(x, y, glm::mix(side.from, side.to, t)); };
        follow(along, 0.0, along(0.0), 1.0, along(1.0), 0, points);
        if (glm::distance(side.to, next.from) < samePoint * disc.radius)
            continue;
        const double from = angleOf(side.to);
        double turn = angleOf(next.from) - from;
        turn += turn < 0.0 ? 2.0 * pi : 0.0;
        const auto onRim = [&](double t) {
            const double angle = from + t * turn;
            return directionIn(x, y, disc.center + disc.radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        };
        follow(onRim, 0.0, onRim(0.0), 1.0, onRim(1.0), 0, points);
    }
    return points;
}

std::vector<OutlinePiece> TexelOutlines::pieces(int x, int y, Rim rim) const
{
    std::vector<glm::dvec3> polygon;
    for (const glm::dvec3& d : boundary(x, y, rim))
        if (polygon.empty() || glm::distance(polygon.back(), d) > samePoint)
            polygon.push_back(d);
    while (polygon.size() > 1 && glm::distance(polygon.back(), polygon.front()) <= samePoint)
        polygon.pop_back();
    std::vector<OutlinePiece> out;
    split(std::move(polygon), 0, out);
    if (out.empty() && rim == Rim::Ends && endsAtRim(x, y)) // the disc only touches it: take it whole, as the map continues
        return pieces(x, y, Rim::Continues);
    return out;
}

/// Cuts by the planes from `plane` on, unless one chart holds the polygon.
void TexelOutlines::split(std::vector<glm::dvec3> polygon, size_t plane, std::vector<OutlinePiece>& out) const
{
    if (polygon.size() < 3)
        return;
    unsigned common = ~0u;
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& d : polygon) {
        common &= m_source.chartsOf(d);
        middle += d;
    }
    const std::span<const glm::dvec3> planes = m_source.planes();
    if (common != 0 || plane == planes.size()) {
        const unsigned inMiddle = m_source.chartsOf(middle);
        const unsigned chosen = (common & inMiddle) != 0 ? common & inMiddle : common != 0 ? common : inMiddle;
        layOut(polygon, std::countr_zero(chosen), out);
        return;
    }
    std::array<std::vector<glm::dvec3>, 2> parts;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        double da = glm::dot(a, planes[plane]), db = glm::dot(b, planes[plane]);
        da = std::abs(da) < samePoint ? 0.0 : da;
        db = std::abs(db) < samePoint ? 0.0 : db;
        if (da >= 0.0)
            parts[0].push_back(a);
        if (da <= 0.0)
            parts[1].push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
            // The same point from either side, for the texel on the other side of this edge.
            const glm::dvec3 cut = da > 0.0 ? glm::normalize(a * -db + b * da) : glm::normalize(b * da * -1.0 + a * db);
            const glm::dvec3 onPlane = cut - planes[plane] * (glm::dot(cut, planes[plane]) / glm::dot(planes[plane], planes[plane]));
            parts[0].push_back(onPlane);
            parts[1].push_back(onPlane);
        }
    }
    for (std::vector<glm::dvec3>& part : parts)
        split(std::move(part), plane + 1, out);
}

/// Appends the points of the rim between two halves after p0 up to and with p1.
void TexelOutlines::layOutRim(int chart, const glm::dvec3& d0, const glm::dvec2& p0, const glm::dvec3& d1, const glm::dvec2& p1, int depth,
                              std::vector<glm::dvec2>& out) const
{
    if (depth < mostHalvings) {
        const glm::dvec3 middle = glm::normalize(d0 + d1);
        const glm::dvec2 p = m_source.position(chart, middle, d0), off = 0.5 * (p0 + p1) - p;
        if (std::max(std::abs(off.x), std::abs(off.y)) > outlineTolerance) {
            layOutRim(chart, d0, p0, middle, p, depth + 1, out);
            layOutRim(chart, middle, p, d1, p1, depth + 1, out);
            return;
        }
    }
    out.push_back(p1);
}

void TexelOutlines::layOut(const std::vector<glm::dvec3>& polygon, int chart, std::vector<OutlinePiece>& out) const
{
    const size_t count = polygon.size();
    OutlinePiece piece;
    std::vector<glm::dvec2>& corners = piece.corners;
    const Charts charts = mapping(m_source.layout().kind).charts;
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % count];
        const glm::dvec2 pa = m_source.position(chart, a, b), pb = m_source.position(chart, b, a);
        if (m_source.isSingular(a)) {
            // The stretch of the image's edge that the point stands for, from where the outline came to where it goes on.
            const glm::dvec2 came = m_source.position(chart, a, polygon[(i + count - 1) % count]);
            corners.push_back(came);
            if (charts == Charts::Disc) {
                const glm::dvec2 center(0.5 * m_source.layout().size);
                const glm::dvec2 from = came - center, to = pa - center;
                const double radius = center.x, turn = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
                const int steps = 1 + static_cast<int>(std::abs(turn) * std::sqrt(radius / (8.0 * outlineTolerance)));
                const double start = std::atan2(from.y, from.x);
                for (int k = 1; k < steps; ++k)
                    corners.push_back(center + radius * glm::dvec2(std::cos(start + turn * k / steps), std::sin(start + turn * k / steps)));
            }
            corners.push_back(pa);
            corners.push_back(pb);
            continue;
        }
        if (corners.empty())
            corners.push_back(pa);
        if (charts == Charts::Halves && std::max(std::abs(a.z), std::abs(b.z)) < samePoint)
            layOutRim(chart, a, pa, b, pb, 0, corners);
        else // followed, or along a cut, which is a straight line in the image
            corners.push_back(pb);
    }
    const double area = twiceArea(corners);
    if (std::abs(area) < least)
        return;
    if (area < 0.0)
        std::reverse(corners.begin(), corners.end());
    out.push_back(std::move(piece));
}

} // namespace mirrorball
