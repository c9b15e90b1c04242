#include "hierarchical.h"

#include "promise.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace mirrorball {

namespace {

using Node = RadianceTree::Node;

/// The bounds are met by few nodes at once, and those of numerator and denominator cancel where the probe is calm: what comes out is
/// this much closer than what they promise (measured, see tests/core/filter/hierarchical_test.cpp).
constexpr double slack = 2.0;

/// Blocks that every sum starts from, at most.
constexpr int mostStartNodes = 64;

/// The lobe's shape with its first two derivatives in x = cos t, bounded over an interval.
class Curvature {
public:
    explicit Curvature(const Lobe& lobe) : m_lobe(lobe), m_shape(lobe)
    {
        if (lobe.kind == LobeKind::Tabulated) {
            const std::vector<double>& s = lobe.samples;
            const double peak = *std::max_element(s.begin(), s.end()), n = static_cast<double>(s.size() - 1);
            for (size_t i = 0; i + 1 < s.size(); ++i)
                m_steepest = std::max(m_steepest, std::abs(s[i + 1] - s[i]) / peak * n);
        }
    }

    struct Bounds {
        double value, slope, curvature; ///< largest |k|, |k'|, |k''|; curvature is negative where the lobe has a kink in the interval
    };

    /// Over [low, high], high > 0.
    Bounds over(double low, double high) const
    {
        high = std::min(high, 1.0);
        switch (m_lobe.kind) {
        case LobeKind::Diffuse:
            return {high, 1.0, low >= 0.0 ? 0.0 : -1.0};
        case LobeKind::Phong: {
            const double n = m_lobe.exponent, k = m_shape.relative(high);
            if (low <= 0.0) // the horizon: steep for n < 1, a kink for n < 2
                return {k, n < 1.0 ? HUGE_VAL : n * k / high, n < 2.0 ? -1.0 : n * (n - 1.0) * k / (high * high)};
            const double slopeAt = n < 1.0 ? low : high, curvatureAt = n < 2.0 ? low : high;
            const double kSlope = slopeAt == high ? k : m_shape.relative(slopeAt);
            const double kCurvature = curvatureAt == high ? k : m_shape.relative(curvatureAt);
            return {k, n * kSlope / slopeAt, std::abs(n * (n - 1.0)) * kCurvature / (curvatureAt * curvatureAt)};
        }
        case LobeKind::Ggx: { // k = c (a^2/(A - Bc))^2 and its derivatives all rise with c
            const double a2 = m_lobe.alpha * m_lobe.alpha, A = 0.5 * (1.0 + a2), B = 0.5 * (1.0 - a2);
            const double w = A - B * high, ratio2 = a2 * a2 / (w * w);
            return {high * ratio2, ratio2 * (A + B * high) / w, low >= 0.0 ? ratio2 * 2.0 * B * (2.0 * A + B * high) / (w * w) : -1.0};
        }
        case LobeKind::Tabulated:
            return {1.0, m_steepest, -1.0};
        }
        return {1.0, HUGE_VAL, -1.0};
    }

    double relative(double x) const { return m_shape.relative(x); }
    double integral() const { return m_shape.integral(); }

private:
    Lobe m_lobe;
    LobeShape m_shape;
    double m_steepest = 0.0;
};

/// A block's node from its up to four parts. Parts without brightness are centered where their area is.
Node merged(const std::vector<Node>& parts, const std::vector<glm::dmat3>& channels, glm::dmat3& channelSums)
{
    Node node;
    channelSums = glm::dmat3(0.0);
    glm::dvec3 byBrightness(0.0), byArea(0.0);
    for (size_t i = 0; i < parts.size(); ++i) {
        const Node& p = parts[i];
        node.flux += p.flux;
        node.brightness += p.brightness;
        node.solidAngle += p.solidAngle;
        byBrightness += p.brightness * p.fluxCenter;
        byArea += p.solidAngle * p.center;
        channelSums += channels[i];
    }
    node.center = byArea / node.solidAngle;
    node.fluxCenter = node.brightness > 0.0 ? byBrightness / node.brightness : node.center;
    for (const Node& p : parts) {
        const glm::dvec3 f = p.fluxCenter - node.fluxCenter, a = p.center - node.center;
        node.fluxSpread += p.brightness * (p.fluxSpread + glm::dot(f, f));
        node.spread += p.solidAngle * (p.spread + glm::dot(a, a));
        node.radius = std::max({node.radius, p.radius + glm::length(p.center - node.center),
                                p.radius + glm::length(p.center - node.fluxCenter), p.radius + glm::length(f)});
    }
    node.fluxSpread = node.brightness > 0.0 ? node.fluxSpread / node.brightness : node.spread;
    node.spread /= node.solidAngle;
    for (int c = 0; c < 3; ++c) // sum L_c w (d - fluxCenter): what a common center leaves out in first order
        node.shift = std::max(node.shift, glm::length(channelSums[c] - node.flux[c] * node.fluxCenter));
    return node;
}

} // namespace

RadianceTree::RadianceTree(const EnvironmentMap& latlong, const JobControl& job) : m_map(&latlong)
{
    const int width = latlong.image.width, height = latlong.image.height;
    for (int x = 0; x < width; ++x) {
        const double lon = pi - 2.0 * pi * (x + 0.5) / width;
        m_sinLon.push_back(std::sin(lon));
        m_cosLon.push_back(std::cos(lon));
    }
    for (int y = 0; y < height; ++y) {
        const double lat = pi / 2 - pi * (y + 0.5) / height;
        m_sinLat.push_back(std::sin(lat));
        m_cosLat.push_back(std::cos(lat));
        m_solidAngle.push_back(2.0 * pi / width * 2.0 * std::cos(lat) * std::sin(0.5 * pi / height));
    }

    const auto texelNode = [&](int x, int y) {
        const float* t = latlong.image.texel(x, y);
        const glm::dvec3 d = direction(x, y), flux = m_solidAngle[static_cast<size_t>(y)] * glm::dvec3(t[0], t[1], t[2]);
        return Node{.flux = flux,
                    .fluxCenter = d,
                    .center = d,
                    .brightness = (std::abs(flux.r) + std::abs(flux.g) + std::abs(flux.b)) / 3.0,
                    .solidAngle = m_solidAngle[static_cast<size_t>(y)]};
    };
    JobControl quiet = job;
    quiet.progress = nullptr;
    std::vector<glm::dmat3> finer; // sum L_c w d of the level below, a column a channel
    for (int fineWidth = width, fineHeight = height; fineWidth > 1 || fineHeight > 1;) {
        Level level{.width = (fineWidth + 1) / 2, .height = (fineHeight + 1) / 2};
        level.nodes.resize(static_cast<size_t>(level.width) * static_cast<size_t>(level.height));
        std::vector<glm::dmat3> sums(level.nodes.size());
        parallelRows(level.height, quiet, [&](int first, int last) {
            std::vector<Node> parts;
            std::vector<glm::dmat3> channels;
            for (int y = first; y < last; ++y)
                for (int x = 0; x < level.width; ++x) {
                    parts.clear();
                    channels.clear();
                    for (int fy = 2 * y; fy < std::min(2 * y + 2, fineHeight); ++fy)
                        for (int fx = 2 * x; fx < std::min(2 * x + 2, fineWidth); ++fx) {
                            const size_t i = static_cast<size_t>(fy) * static_cast<size_t>(fineWidth) + static_cast<size_t>(fx);
                            parts.push_back(m_levels.empty() ? texelNode(fx, fy) : m_levels.back().nodes[i]);
                            channels.push_back(m_levels.empty() ? glm::outerProduct(direction(fx, fy), parts.back().flux) : finer[i]);
                        }
                    const size_t i = static_cast<size_t>(y) * static_cast<size_t>(level.width) + static_cast<size_t>(x);
                    level.nodes[i] = merged(parts, channels, sums[i]);
                }
        });
        finer = std::move(sums);
        fineWidth = level.width;
        fineHeight = level.height;
        m_levels.push_back(std::move(level));
    }
    const Node whole = m_levels.empty() ? texelNode(0, 0) : m_levels.back().nodes.front();
    m_meanBrightness = whole.brightness / whole.solidAngle;
}

namespace {

/// One direction's sum.
class Descent {
public:
    Descent(const RadianceTree& tree, const Curvature& lobe, double allowed)
        : m_tree(tree), m_lobe(lobe), m_allowed(allowed), m_start(static_cast<int>(tree.levels().size()) - 1)
    {
        while (m_start > 0 && nodesAt(m_start - 1) <= mostStartNodes)
            --m_start;
    }

    glm::dvec3 sum(const glm::dvec3& r, double& terms)
    {
        m_r = r;
        m_sum = glm::dvec3(0.0);
        m_norm = 0.0;
        m_terms = 0;
        if (m_start < 0)
            texel(0, 0);
        else
            for (int y = 0; y < m_tree.levels()[static_cast<size_t>(m_start)].height; ++y)
                for (int x = 0; x < m_tree.levels()[static_cast<size_t>(m_start)].width; ++x)
                    node(m_start, x, y);
        terms += m_terms;
        return m_sum / m_norm;
    }

private:
    int nodesAt(int level) const
    {
        const auto& l = m_tree.levels()[static_cast<size_t>(level)];
        return l.width * l.height;
    }

    void texel(int x, int y)
    {
        const double c = glm::dot(m_r, m_tree.direction(x, y));
        if (c <= 0.0)
            return;
        const double k = m_tree.solidAngle(y) * m_lobe.relative(c);
        const float* t = m_tree.map().image.texel(x, y);
        m_sum += k * glm::dvec3(t[0], t[1], t[2]);
        m_norm += k;
        ++m_terms;
    }

    void node(int levelIndex, int x, int y)
    {
        const RadianceTree::Level& level = m_tree.levels()[static_cast<size_t>(levelIndex)];
        const Node& n = level.nodes[static_cast<size_t>(y) * static_cast<size_t>(level.width) + static_cast<size_t>(x)];
        const double c = glm::dot(m_r, n.center), cf = glm::dot(m_r, n.fluxCenter);
        // d = center + e with |e| <= radius: r.e is at most sin t times the part across r, and radius^2 / 2 along it on the sphere.
        const double across = std::sqrt(std::max(0.0, 1.0 - c * c));
        const double reach = std::min(n.radius, n.radius * across + n.radius * n.radius);
        const double high = std::max(c, cf) + reach;
        if (high <= 0.0)
            return;
        const double low = std::min(c, cf) - reach;
        const Curvature::Bounds bounds = m_lobe.over(low, high);
        const double share = n.radius * n.radius + across * across; // of the spread that r sees
        const double energy = std::max(n.brightness, m_tree.meanBrightness() * n.solidAngle);
        double error;
        if (bounds.curvature >= 0.0)
            error = 0.5 * bounds.curvature * share * (n.brightness * n.fluxSpread + m_tree.meanBrightness() * n.solidAngle * n.spread);
        else
            error = energy * std::min(bounds.value, bounds.slope * std::sqrt(share * std::max(n.fluxSpread, n.spread)));
        error += std::min(bounds.slope * n.shift * std::sqrt(share), bounds.value * n.brightness);
        // Half of the error may go where the lobe is, half evenly over the hemisphere.
        const double allowed = m_allowed * n.solidAngle * (0.5 * bounds.value + 0.5 * m_lobe.integral() / (2.0 * pi));
        if (error <= allowed) {
            m_sum += m_lobe.relative(cf) * n.flux;
            m_norm += m_lobe.relative(c) * n.solidAngle;
            ++m_terms;
            return;
        }
        const bool leaves = levelIndex == 0;
        const int width = leaves ? m_tree.map().image.width : m_tree.levels()[static_cast<size_t>(levelIndex) - 1].width;
        const int height = leaves ? m_tree.map().image.height : m_tree.levels()[static_cast<size_t>(levelIndex) - 1].height;
        for (int fy = 2 * y; fy < std::min(2 * y + 2, height); ++fy)
            for (int fx = 2 * x; fx < std::min(2 * x + 2, width); ++fx) {
                if (leaves)
                    texel(fx, fy);
                else
                    node(levelIndex - 1, fx, fy);
            }
    }

    const RadianceTree& m_tree;
    const Curvature& m_lobe;
    double m_allowed; ///< error of the mean radiance under the lobe
    int m_start;
    glm::dvec3 m_r{};
    glm::dvec3 m_sum{};
    double m_norm = 0.0;
    int m_terms = 0;
};

/// Values of the filtered map, from a coarse sum in a few directions: what the tolerance is relative to.
ValueDistribution coarseValues(const RadianceTree& tree, const Curvature& lobe)
{
    ValueDistribution values;
    const MapLayout few{Parameterization::Cube, 8, 0};
    double terms = 0.0;
    Descent coarse(tree, lobe, 0.01 * slack * tree.meanBrightness());
    for (int y = 0; y < few.height(); ++y)
        for (int x = 0; x < few.width(); ++x)
            values.add(coarse.sum(texelDirection(few, x, y), terms), texelSolidAngle(few, x, y));
    return values;
}

} // namespace

HierarchicalSums hierarchicalSum(const RadianceTree& tree, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                 const HierarchicalOptions& options, const JobControl& job)
{
    if (lobe.isMirror())
        throw InvalidArgument("hierarchical: a mirror has no sum over texels; look the probe up instead");
    const Curvature curvature(lobe);
    const double allowed =
        std::max(coarseValues(tree, curvature).allowedLargest(errorLimits(options.tolerance)), std::numeric_limits<double>::min());
    HierarchicalSums sums{.values = std::vector<glm::dvec3>(directions.size())};
    std::mutex mutex;
    parallelRows(
        static_cast<int>(directions.size()), job,
        [&](int first, int last) {
            Descent descent(tree, curvature, slack * allowed);
            double terms = 0.0;
            for (int i = first; i < last; ++i)
                sums.values[static_cast<size_t>(i)] = descent.sum(directions[static_cast<size_t>(i)], terms);
            const std::lock_guard lock(mutex);
            sums.terms += terms; // whole numbers: the order does not matter
        },
        16);
    return sums;
}

} // namespace mirrorball
