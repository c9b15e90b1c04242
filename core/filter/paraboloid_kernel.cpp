#include "paraboloid_kernel.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

int roundedUpToEven(double size) { return 2 * std::max(1, static_cast<int>(std::ceil(0.5 * size - 1e-9))); }

int shrinkUntil(int size, int largest)
{
    int shrink = 1;
    while (static_cast<double>(size) / shrink > largest)
        shrink *= 2;
    return shrink;
}

/// Distances from the middle of a kernel to its end.
double middleRadius(double reach) { return std::tan(0.5 * reach); }
double rimRadius(double reach) { return 1.0 - std::tan(0.25 * pi - 0.5 * reach); }

} // namespace

KernelSizes kernelSizes(double reach, int half, int largestKernel)
{
    const int small = roundedUpToEven(half * middleRadius(reach)), large = roundedUpToEven(half * rimRadius(reach));
    return {small, large, shrinkUntil(small, largestKernel), shrinkUntil(large, largestKernel)};
}

SampledKernel sampleKernel(const Lobe& lobe, double reach, int half, int shrink, KernelPlace place)
{
    const LobeShape shape(lobe);
    const double texel = 2.0 * shrink / half; // in radii of the disc
    const double radius = place == KernelPlace::Middle ? middleRadius(reach) : rimRadius(reach);
    SampledKernel kernel{.reach = static_cast<int>(std::floor(radius / texel))};
    double sum = 0.0;
    for (int y = -kernel.reach; y <= kernel.reach; ++y)
        for (int x = -kernel.reach; x <= kernel.reach; ++x) {
            const double s = texel * std::hypot(x, y);
            const double t = place == KernelPlace::Middle ? 2.0 * std::atan(s) : 0.5 * pi - 2.0 * std::atan(1.0 - s);
            kernel.weights.push_back(s <= radius ? shape.relative(std::cos(t)) : 0.0);
            sum += kernel.weights.back();
        }
    if (sum <= 0.0) { // only a lobe that is dark along its own axis
        std::fill(kernel.weights.begin(), kernel.weights.end(), 1.0);
        sum = static_cast<double>(kernel.weights.size());
    }
    for (double& weight : kernel.weights)
        weight /= sum;
    return kernel;
}

int blendedHalfSide(const KernelSizes& sizes, const SampledKernel& large, int half, int border)
{
    const int needed = border > 0 ? border : (large.reach + 1) * sizes.largeShrink;
    const int unit = std::max(sizes.smallShrink, sizes.largeShrink);
    return 2 * ((half / 2 + needed + unit - 1) / unit) * unit;
}

double largeKernelShare(double d) { return std::min(1.0, d * d); }

double circleDistortion(double d, double r)
{
    const double nearer = std::atan(d) - std::atan(d - r), farther = std::atan(d + r) - std::atan(d);
    return nearer + farther > 0.0 ? std::abs(nearer - farther) / (nearer + farther) : 0.0;
}

CapCircle circleOfCap(const glm::dvec3& r, double t)
{
    const double scale = 1.0 / (r.z + std::cos(t));
    return {scale * glm::dvec2(r.x, r.y), scale * std::sin(t)};
}

double exactHalfRadius(double reach, int largestKernel) { return 0.5 * largestKernel / std::tan(0.5 * reach); }

std::array<double, 4> cubicWeights(double f)
{
    const double a = f + 1.0, b = f - 1.0, c = f - 2.0;
    return {-f * b * c / 6.0, a * b * c / 2.0, -a * f * c / 2.0, a * f * b / 6.0};
}

} // namespace mirrorball
