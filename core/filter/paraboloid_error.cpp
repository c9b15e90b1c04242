#include "bright_texels.h"
#include "paraboloid_lattice.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

/// The error of the paraboloid method for a single bright texel at q. A lookup at r reads it with some weight g(r) a steradian, where the
/// reference reads it with k(r.q), so that over all lookups
///   rel_rms^2 = integral (g - k)^2 d omega_r / integral k^2 d omega.
namespace mirrorball {

namespace {

/// Integral of relative()^power beyond an angle, by the midpoint rule.
double integralBeyond(const LobeShape& shape, double from, double power)
{
    const double to = shape.support(1e-9);
    constexpr int steps = 2048;
    double sum = 0.0;
    for (int i = 0; i < steps && to > from; ++i) {
        const double t = from + (to - from) * (i + 0.5) / steps;
        sum += std::pow(shape.relative(std::cos(t)), power) * std::sin(t);
    }
    return 2.0 * pi * sum * std::max(0.0, to - from) / steps;
}

/// d omega / dA of the plane.
double stretch(double q2) { return 4.0 / ((1.0 + q2) * (1.0 + q2)); }

/// Direction of a place in the plane of the front half.
glm::dvec3 lift(const glm::dvec2& q) { return glm::dvec3(2.0 * q, 1.0 - glm::dot(q, q)) / (1.0 + glm::dot(q, q)); }

/// Integral of f(r) over the directions within an angle of q, by the midpoint rule in polar coordinates.
/// @param turn  of the azimuth: 2 pi, or less where f repeats itself
template <typename Function>
double integralAround(const glm::dvec3& q, double angle, double turn, int rings, int spokes, Function&& f)
{
    const glm::dvec3 u = glm::normalize(std::abs(q.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) - q.x * q : glm::dvec3(0.0, 1.0, 0.0) - q.y * q);
    const glm::dvec3 v = glm::cross(q, u);
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double t = angle * (i + 0.5) / rings;
        for (int j = 0; j < spokes; ++j) {
            const double phi = turn * (j + 0.5) / spokes;
            sum += std::sin(t) * f(std::cos(t) * q + std::sin(t) * (std::cos(phi) * u + std::sin(phi) * v));
        }
    }
    return sum * 2.0 * pi * angle / (rings * spokes);
}

/// In the middle of a half, where the texels are widest: the lobe is read at the sixteen texels that the radiance was spread over.
/// @param f  place of the source between texels: 0 on one, where nothing is interpolated, 1/2 between four, where most is
double exactSquareError(const LobeShape& shape, double reach, int largestKernel, double f)
{
    const double texel = 1.0 / exactHalfRadius(reach, largestKernel), leastCos = std::cos(reach);
    const double clamped = shape.integral() - integralBeyond(shape, reach, 1.0);
    const std::array<double, 4> w = cubicWeights(f);
    const double angle = std::min(pi, reach + 2.0 * std::atan(3.0 * texel));
    const double inside = integralAround({0.0, 0.0, 1.0}, angle, 0.25 * pi, 192, 8, [&](const glm::dvec3& r) {
        double g = 0.0;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const double c = glm::dot(r, lift(texel * glm::dvec2(i - 1 - f, j - 1 - f)));
                g += c >= leastCos ? w[static_cast<size_t>(i)] * w[static_cast<size_t>(j)] * shape.relative(c) : 0.0;
            }
        const double difference = g / clamped - shape.relative(r.z) / shape.integral();
        return difference * difference;
    });
    return inside + integralBeyond(shape, angle, 2.0) / (shape.integral() * shape.integral());
}

/// One of the two filtered maps: what a lookup at p reads of a texel at q, both in the plane, a unit of its area. The lookup is bilinear
/// between four texels, about each of which the kernel lies.
struct FilteredMap {
    SampledKernel kernel;
    double texel; // in radii of the disc

    FilteredMap(const Lobe& lobe, double reach, int half, int shrink, KernelPlace place)
        : kernel(sampleKernel(lobe, reach, half, shrink, place)), texel(2.0 * shrink / half)
    {
    }
    double weight(const glm::dvec2& p, const glm::dvec2& q) const
    {
        const glm::dvec2 corner = glm::floor(p / texel - 0.5), f = p / texel - 0.5 - corner, offset = glm::floor(q / texel) - corner;
        double sum = 0.0;
        for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx) {
                const int x = static_cast<int>(offset.x) - dx + kernel.reach, y = static_cast<int>(offset.y) - dy + kernel.reach;
                if (x >= 0 && y >= 0 && x < kernel.side() && y < kernel.side())
                    sum += (dx ? f.x : 1.0 - f.x) * (dy ? f.y : 1.0 - f.y) * kernel.weights[static_cast<size_t>(y * kernel.side() + x)];
            }
        return sum / (texel * texel);
    }
};

/// The largest over places from the middle of a half to its rim, in several directions: a texel of the most shrunk map is so large that it
/// matters where on it the source lies.
double blendedSquareError(const LobeShape& shape, const Lobe& lobe, double reach, const ParaboloidKnobs& knobs)
{
    const KernelSizes sizes = kernelSizes(reach, knobs.half, knobs.largestKernel);
    const FilteredMap small(lobe, reach, knobs.half, sizes.smallShrink, KernelPlace::Middle);
    const FilteredMap large(lobe, reach, knobs.half, sizes.largeShrink, KernelPlace::Rim);
    // How far either kernel goes, in the middle, where it goes farthest; the lobe itself goes beyond its clamp.
    const double farthest = std::max((small.kernel.reach + 2) * small.texel, (large.kernel.reach + 2) * large.texel);
    const double angle = std::min(pi, std::max(2.0 * std::atan(farthest), 1.5 * reach));
    constexpr std::array places{0.95, 0.5, 0.2, 0.02}; // z
    constexpr size_t turns = 5;
    double worst = 0.0;
    for (size_t i = 0; i < places.size() * turns; ++i) {
        const double z = places[i / turns], s = std::sqrt(1.0 - z * z), turn = 0.1 + 0.7 * static_cast<double>(i % turns) / turns;
        const glm::dvec3 source(s * std::cos(turn), s * std::sin(turn), z);
        const double square = integralAround(source, angle, 2.0 * pi, 64, 32, [&](const glm::dvec3& r) {
            const double c = glm::dot(r, source), side = r.z < 0.0 ? -1.0 : 1.0;
            const glm::dvec2 p = glm::dvec2(r.x, r.y) / (1.0 + side * r.z);
            const glm::dvec2 q = glm::dvec2(source.x, source.y) / std::max(1e-9, 1.0 + side * source.z);
            const double share = largeKernelShare(glm::length(p));
            const double g = ((1.0 - share) * small.weight(p, q) + share * large.weight(p, q)) / stretch(glm::dot(q, q));
            const double difference = g - shape.relative(c) / shape.integral();
            return difference * difference;
        });
        worst = std::max(worst, square);
    }
    return worst + integralBeyond(shape, angle, 2.0) / (shape.integral() * shape.integral());
}

} // namespace

double paraboloidError(const Lobe& lobe, const ParaboloidKnobs& knobs)
{
    const LobeShape shape(lobe);
    const double reach = shape.support(knobs.clamp);
    const double power = integralBeyond(shape, 0.0, 2.0) / (shape.integral() * shape.integral());
    const double square = knobs.kernel == ParaboloidKernel::Blended ? blendedSquareError(shape, lobe, reach, knobs)
                                                                    : std::max(exactSquareError(shape, reach, knobs.largestKernel, 0.0),
                                                                               exactSquareError(shape, reach, knobs.largestKernel, 0.5));
    return std::sqrt(square / power);
}

namespace {

/// Coefficients of the lobe's share within its reach, normalized to 1, less its own: by the midpoint rule.
std::vector<double> clampBias(const LobeShape& shape, double reach, int bandLimit)
{
    const double inside = shape.integral() - integralBeyond(shape, reach, 1.0), farthest = shape.support(1e-12);
    std::vector<double> bias(static_cast<size_t>(bandLimit) + 1, 0.0);
    const int steps = 8 * (bandLimit + 64);
    for (const auto& [from, to, scale] : {std::tuple{0.0, reach, 1.0 / inside - 1.0 / shape.integral()},
                                          std::tuple{reach, std::max(reach, farthest), -1.0 / shape.integral()}})
        for (int i = 0; i < steps; ++i) {
            const double t = from + (to - from) * (i + 0.5) / steps, x = std::cos(t);
            const double weight = 2.0 * pi * scale * shape.relative(x) * std::sin(t) * (to - from) / steps;
            double previous = 0.0, p = 1.0;
            for (size_t l = 0; l < bias.size(); ++l) {
                bias[l] += weight * p;
                const double d = static_cast<double>(l), next = ((2.0 * d + 1.0) * x * p - d * previous) / (d + 1.0);
                previous = p;
                p = next;
            }
        }
    bias[0] = 0.0; // both integrate to 1
    return bias;
}

} // namespace

TransferModel paraboloidModel(const Lobe& lobe, const ParaboloidKnobs& knobs, int bandLimit)
{
    const LobeShape shape(lobe);
    TransferModel model{.k = legendreCoefficients(lobe, bandLimit), .bias = clampBias(shape, shape.support(knobs.clamp), bandLimit)};
    double total = 0.0, clamped = 0.0; // over a flat spectrum
    for (size_t l = 0; l < model.k.size(); ++l) {
        const double coefficients = 2.0 * static_cast<double>(l) + 1.0;
        total += coefficients * model.k[l] * model.k[l];
        clamped += coefficients * model.bias[l] * model.bias[l];
    }
    const bool exact = knobs.kernel == ParaboloidKernel::Exact;
    const double power = exact ? 8.0 : 4.0, shrinking = splitsBrightTexels(lobe) ? 5.0 : power; // less of a kink
    // From the worst place to the mean square over all: texels are (1+z)/2 as wide away from the middle of a half, integral over z of
    // ((1+z)/2)^n = 2/(n+1); and interpolation errs half way between texels, and not on them.
    const double anywhere = 0.5 * 2.0 / (shrinking + 1.0);
    const double white = paraboloidError(lobe, knobs), rest = anywhere * std::max(0.0, white * white * total - clamped);
    const auto scatter = [&](size_t l, double l0) {
        return model.k[l] * model.k[l] * std::min(1.0, std::pow(static_cast<double>(l) / l0, power));
    };
    const auto lost = [&](double l0) {
        double sum = 0.0;
        for (size_t l = 0; l < model.k.size(); ++l)
            sum += (2.0 * static_cast<double>(l) + 1.0) * scatter(l, l0);
        return sum;
    };
    double low = 1.0, high = 1e6; // of l_0: what is lost falls with it
    for (int i = 0; i < 50; ++i) {
        const double middle = std::sqrt(low * high);
        (lost(middle) > rest ? low : high) = middle;
    }
    for (size_t l = 0; l < model.k.size(); ++l) {
        model.scatter.push_back(scatter(l, high));
        model.felt.push_back(std::sqrt(model.scatter.back())); // where the lobe bends most: at a kink
    }
    return model;
}

double paraboloidSeconds(const Lobe& lobe, const ParaboloidKnobs& knobs, int probeWidth, int directions)
{
    const double reach = LobeShape(lobe).support(knobs.clamp);
    if (knobs.kernel == ParaboloidKernel::Exact) {
        // Kernels are larger towards the rim: twice as many texels on average over the sphere.
        const double radius = exactHalfRadius(reach, knobs.largestKernel), side = 2.0 * radius + 6.0;
        const double taps = std::min(2.0 * knobs.largestKernel * knobs.largestKernel, 2.0 * side * side);
        const int perTexel = latticeDensity(lobe, reach, radius, directions);
        const double sums = perTexel > 0 ? latticePoints(radius, perTexel) : directions;
        return 6e-8 * probeWidth * probeWidth / 2 + 1e-7 * side * side + 1.3e-8 * taps * sums + (perTexel > 0 ? 1e-7 * directions : 0.0);
    }
    const KernelSizes sizes = kernelSizes(reach, knobs.half, knobs.largestKernel);
    const SampledKernel large = sampleKernel(lobe, reach, knobs.half, sizes.largeShrink, KernelPlace::Rim);
    const double side = blendedHalfSide(sizes, large, knobs.half, knobs.border);
    return 2e-7 * 2.0 * side * side + 1e-7 * directions;
}

} // namespace mirrorball
