#include "paraboloid.h"

#include "../sphere/direction.h"

#include <algorithm>
#include <cmath>

/// The error of the paraboloid method for a single bright texel. For a lookup at r the method reads the texel's radiance with some weight
/// g(q) a steradian at the texel's place q, where the reference reads k(r.q). Averaged over all places of the texel, or of the lookup,
///   rel_rms^2 = integral (g - k)^2 d omega / integral k^2 d omega.
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
double stretch(double q2)
{
    return 4.0 / ((1.0 + q2) * (1.0 + q2));
}

/// cos of the angle between two places of the plane.
double cosBetween(const glm::dvec2& p, const glm::dvec2& q)
{
    const glm::dvec2 d = p - q;
    return 1.0 - 2.0 * glm::dot(d, d) / ((1.0 + glm::dot(p, p)) * (1.0 + glm::dot(q, q)));
}

/// In the middle of a half, where the texels are widest: k is read off its cubic interpolant. The lookup lies on a texel (offset 0) or
/// between four (offset 1/2).
double exactSquareError(const LobeShape& shape, double reach, int largestKernel, double offset)
{
    constexpr int steps = 4;
    const double texel = 1.0 / exactHalfRadius(reach, largestKernel), cosReach = std::cos(reach);
    const int m = largestKernel / 2 + 4, cells = 2 * m - 2, size = cells * steps;
    const auto lobeAt = [&](double x, double y, double least) {
        const double c = cosBetween({0.0, 0.0}, {x, y});
        return c >= least ? shape.relative(c) : 0.0;
    };
    // Along x first: rows of texels, columns of sub-samples.
    std::vector<double> rows(static_cast<size_t>(2 * m + 1) * static_cast<size_t>(size));
    for (int j = -m; j <= m; ++j)
        for (int cell = 0; cell < cells; ++cell)
            for (int s = 0; s < steps; ++s) {
                const std::array<double, 4> w = cubicWeights((s + 0.5) / steps);
                double sum = 0.0;
                for (int i = 0; i < 4; ++i)
                    sum += w[static_cast<size_t>(i)] * lobeAt((cell - m + i + offset) * texel, (j + offset) * texel, cosReach);
                rows[static_cast<size_t>(j + m) * static_cast<size_t>(size) + static_cast<size_t>(cell * steps + s)] = sum;
            }
    std::vector<double> interpolated, exact, area;
    double norm = 0.0, radius = 0.0;
    for (int cell = 0; cell < cells; ++cell)
        for (int s = 0; s < steps; ++s) {
            const std::array<double, 4> w = cubicWeights((s + 0.5) / steps);
            for (int x = 0; x < size; ++x) {
                double sum = 0.0;
                for (int j = 0; j < 4; ++j)
                    sum += w[static_cast<size_t>(j)] * rows[static_cast<size_t>(cell + j) * static_cast<size_t>(size) + static_cast<size_t>(x)];
                const double qx = (x / steps - m + 1 + (x % steps + 0.5) / steps + offset) * texel;
                const double qy = (cell - m + 1 + (s + 0.5) / steps + offset) * texel;
                interpolated.push_back(sum);
                exact.push_back(lobeAt(qx, qy, -1.0));
                area.push_back(stretch(qx * qx + qy * qy) * texel * texel / (steps * steps));
                norm += sum * area.back();
                radius = std::max(radius, std::abs(qx));
            }
        }
    double square = 0.0;
    for (size_t i = 0; i < area.size(); ++i)
        square += std::pow(interpolated[i] / norm - exact[i] / shape.integral(), 2) * area[i];
    return square;
}

double exactError(const Lobe& lobe, double reach, const ParaboloidKnobs& knobs)
{
    const LobeShape shape(lobe);
    const double power = integralBeyond(shape, 0.0, 2.0) / (shape.integral() * shape.integral());
    const double square = 0.5 * (exactSquareError(shape, reach, knobs.largestKernel, 0.0) +
                                 exactSquareError(shape, reach, knobs.largestKernel, 0.5));
    return std::sqrt(square / power);
}

/// The weights by which a lookup at p, in texels of the shrunk map from the middle of the half, reads that map: the kernel about each of the
/// four texels of the bilinear lookup.
struct ShrunkWeights {
    int left, top, side;
    double texel; // in radii of the disc
    std::vector<double> weights;

    ShrunkWeights(const SampledKernel& kernel, int shrink, double radius, const glm::dvec2& q)
        : side(kernel.side() + 1), texel(shrink / radius), weights(static_cast<size_t>(side) * static_cast<size_t>(side), 0.0)
    {
        const glm::dvec2 p = q / texel - 0.5, corner = glm::floor(p), f = p - corner;
        left = static_cast<int>(corner.x) - kernel.reach;
        top = static_cast<int>(corner.y) - kernel.reach;
        for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx)
                for (int j = 0; j < kernel.side(); ++j)
                    for (int i = 0; i < kernel.side(); ++i)
                        weights[static_cast<size_t>(j + dy) * static_cast<size_t>(side) + static_cast<size_t>(i + dx)] +=
                            (dx ? f.x : 1.0 - f.x) * (dy ? f.y : 1.0 - f.y) *
                            kernel.weights[static_cast<size_t>(j * kernel.side() + i)];
    }
    /// Weight per area of the plane.
    double density(const glm::dvec2& q) const
    {
        const int x = static_cast<int>(std::floor(q.x / texel)) - left, y = static_cast<int>(std::floor(q.y / texel)) - top;
        return x < 0 || y < 0 || x >= side || y >= side ? 0.0
                                                        : weights[static_cast<size_t>(y * side + x)] / (texel * texel);
    }
    double reach() const { return 0.5 * side * texel; }
};

double blendedError(const Lobe& lobe, double reach, const ParaboloidKnobs& knobs)
{
    const LobeShape shape(lobe);
    const KernelSizes sizes = kernelSizes(reach, knobs.half, knobs.largestKernel);
    const SampledKernel small = sampleKernel(lobe, reach, knobs.half, sizes.smallShrink, KernelPlace::Middle);
    const SampledKernel large = sampleKernel(lobe, reach, knobs.half, sizes.largeShrink, KernelPlace::Rim);
    const double power = integralBeyond(shape, 0.0, 2.0) / (shape.integral() * shape.integral());
    constexpr int places = 8; // of equal solid angle, each in another direction from the middle
    double square = 0.0;
    for (int i = 0; i < places; ++i) {
        const double z = (i + 0.5) / places, d = std::sqrt((1.0 - z) / (1.0 + z)), turn = 0.4 + 2.399963 * i;
        const glm::dvec2 p = d * glm::dvec2(std::cos(turn), std::sin(turn));
        const ShrunkWeights s(small, sizes.smallShrink, 0.5 * knobs.half, p), l(large, sizes.largeShrink, 0.5 * knobs.half, p);
        const double share = largeKernelShare(d);
        // As far as either kernel goes, or the lobe itself down to a thousandth.
        const double lobeReach = shape.support(1e-3);
        const double around = std::max({s.reach(), l.reach(), (1.0 + d * d) * std::tan(0.5 * lobeReach)});
        const double step = std::max(s.texel / 3.0, around / 48.0);
        const int n = static_cast<int>(std::ceil(around / step));
        double part = 0.0;
        for (int y = -n; y < n; ++y)
            for (int x = -n; x < n; ++x) {
                const glm::dvec2 q = p + step * glm::dvec2(x + 0.5, y + 0.5);
                const double jacobian = stretch(glm::dot(q, q));
                const double g = ((1.0 - share) * s.density(q) + share * l.density(q)) / jacobian;
                part += std::pow(g - shape.relative(cosBetween(p, q)) / shape.integral(), 2) * jacobian;
            }
        square += part * step * step / places;
    }
    return std::sqrt(square / power);
}

} // namespace

double paraboloidError(const Lobe& lobe, const ParaboloidKnobs& knobs)
{
    const double reach = LobeShape(lobe).support(knobs.clamp);
    return knobs.kernel == ParaboloidKernel::Blended ? blendedError(lobe, reach, knobs) : exactError(lobe, reach, knobs);
}

double paraboloidSeconds(const Lobe& lobe, const ParaboloidKnobs& knobs, int probeWidth, int directions)
{
    const double reach = LobeShape(lobe).support(knobs.clamp);
    if (knobs.kernel == ParaboloidKernel::Exact) {
        // Kernels are larger towards the rim: twice as many texels on average over the sphere.
        const double side = 2.0 * exactHalfRadius(reach, knobs.largestKernel) + 6.0;
        const double taps = std::min(2.0 * knobs.largestKernel * knobs.largestKernel, 2.0 * side * side);
        return 1e-7 * probeWidth * probeWidth / 2 + 1e-7 * side * side + 1e-8 * taps * directions;
    }
    const KernelSizes sizes = kernelSizes(reach, knobs.half, knobs.largestKernel);
    const SampledKernel large = sampleKernel(lobe, reach, knobs.half, sizes.largeShrink, KernelPlace::Rim);
    const double side = blendedHalfSide(sizes, large, knobs.half, knobs.border);
    return 2e-7 * 2.0 * side * side + 1e-7 * directions;
}

} // namespace mirrorball
