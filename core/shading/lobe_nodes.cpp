#include "reflection_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorball {

namespace {

constexpr int order = 16;

/// Newton's iteration on P_16 from Tricomi's estimate of its zeros.
GaussLegendre makeGaussLegendre()
{
    GaussLegendre rule;
    for (int i = 0; i < order; ++i) {
        double x = -std::cos(pi * (i + 0.75) / (order + 0.5)), slope = 1.0;
        for (int step = 0; step < 50; ++step) {
            double previous = 1.0, p = x;
            for (int l = 1; l < order; ++l) {
                const double next = ((2.0 * l + 1.0) * x * p - l * previous) / (l + 1.0);
                previous = p;
                p = next;
            }
            slope = order * (x * p - previous) / (x * x - 1.0);
            const double change = p / slope;
            x -= change;
            if (std::abs(change) < 1e-16)
                break;
        }
        rule.nodes.push_back(x);
        rule.weights.push_back(2.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

/// Panels from 0 that grow by `growth` from `first` up to `widest`, then break at each of `breaks`, ascending; the last is the end.
std::vector<double> panels(double first, double growth, double widest, const std::vector<double>& breaks)
{
    std::vector<double> ends{0.0};
    double width = first;
    for (const double end : breaks) {
        while (ends.back() < end - 1e-12) {
            const double rest = end - ends.back();
            const double step = rest < 1.5 * width ? rest : width;
            ends.push_back(rest == step ? end : ends.back() + step);
            width = std::min(width * growth, widest);
        }
    }
    return ends;
}

} // namespace

const GaussLegendre& gaussLegendre16()
{
    static const GaussLegendre rule = makeGaussLegendre();
    return rule;
}

LobeNodes lobeNodes(double view, int degree)
{
    const GaussLegendre& rule = gaussLegendre16();
    LobeNodes nodes;
    // Above pi/2 - t the horizon cuts; above pi/2 + t nothing is left.
    const std::vector<double> gammas = panels(1e-3, 1.6, std::min(0.1, 20.0 / std::max(degree, 1)), {0.5 * pi - view, 0.5 * pi + view});
    const double cosT = std::cos(view), sinT = std::sin(view);
    for (size_t p = 0; p + 1 < gammas.size(); ++p)
        for (int i = 0; i < order; ++i) {
            const auto k = static_cast<size_t>(i);
            const double half = 0.5 * (gammas[p + 1] - gammas[p]), gamma = gammas[p] + half * (1.0 + rule.nodes[k]);
            const double c = std::cos(gamma), s = std::sin(gamma);
            // c cosT + s sinT cos(chi) > 0
            const double limit = sinT > 0.0 ? -c * cosT / (s * sinT) : (c > 0.0 ? -2.0 : 2.0);
            if (limit >= 1.0)
                continue;
            const double chiEnd = limit <= -1.0 ? pi : std::acos(limit);
            nodes.rings.push_back({gamma, half * rule.weights[k] * s, nodes.chi.size()});
            // A lobe seen at a flat angle is narrow across the plane of incidence: fine beside chi = 0 and, where it is above, chi = pi.
            const auto towards = panels(std::min(0.02, 0.25 * chiEnd), 1.8, 0.35, {0.5 * chiEnd});
            std::vector<double> ends = towards;
            for (size_t e = towards.size() - 1; e-- > 0;)
                ends.push_back(chiEnd - towards[e]);
            for (size_t q = 0; q + 1 < ends.size(); ++q)
                for (size_t j = 0; j < static_cast<size_t>(order); j += 1) {
                    const double halfChi = 0.5 * (ends[q + 1] - ends[q]), chi = ends[q] + halfChi * (1.0 + rule.nodes[j]);
                    nodes.chi.push_back(chi);
                    nodes.chiWeight.push_back(2.0 * halfChi * rule.weights[j]);
                    const double x = s * std::cos(chi);
                    nodes.nl.push_back(c * cosT + x * sinT);
                    nodes.lv.push_back(c * std::cos(2.0 * view) + x * std::sin(2.0 * view));
                }
        }
    return nodes;
}

glm::dvec3 directionalAlbedo(const Brdf& brdf, double view)
{
    const ReflectionKernel kernel(brdf, view);
    const LobeNodes nodes = lobeNodes(view);
    const auto values = kernelAtNodes(kernel, nodes);
    glm::dvec3 sum(0.0);
    for (size_t r = 0; r < nodes.rings.size(); ++r)
        for (size_t c = 0; c < kernel.channels(); ++c) {
            double ring = 0.0;
            for (size_t i = nodes.rings[r].first; i < nodes.end(r); ++i)
                ring += nodes.chiWeight[i] * values[c][i];
            sum[static_cast<int>(c)] += nodes.rings[r].weight * ring;
        }
    return kernel.isGray() ? glm::dvec3(sum.x) : sum;
}

} // namespace mirrorball
