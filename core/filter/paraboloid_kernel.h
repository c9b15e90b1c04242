#pragma once

#include "lobe.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

/// Arithmetic of the paraboloid method: how large a kernel is in a half of a dual paraboloid map, how far the map shrinks until it fits,
/// what its taps weigh, how the two filtered maps are blended, and what the approximation distorts. Source: 000 section 3.2.5.
///
/// Lengths are in radii of a half's disc unless they say texels. A half is a stereographic projection: an angle t from its axis lies at
/// the distance tan(t/2) from its middle, 90 degrees at 1.
namespace mirrorball {

/// Kernels of one lobe in a half of so many texels across, and the power of two by which the map shrinks until each fits.
struct KernelSizes {
    int small = 0; ///< texels across in the middle of the half, unshrunk, rounded up to even
    int large = 0; ///< the same at its rim
    int smallShrink = 1;
    int largeShrink = 1;
    bool operator==(const KernelSizes&) const = default;
};

/// With t the angle at which the lobe is clamped and N the texels across:
///   small = N tan(t/2),   large = N (1 - tan(45 degrees - t/2)),
/// the latter towards the middle of the half. The shrink factor doubles while the kernel is larger than `largestKernel`.
/// @param reach  t in (0, pi/2]
KernelSizes kernelSizes(double reach, int half, int largestKernel);

/// A square of taps for a shrunk map; they add up to 1.
struct SampledKernel {
    int reach = 0;                 ///< taps on each side of the middle one
    std::vector<double> weights{}; ///< (2 reach + 1)^2, row by row
    int side() const { return 2 * reach + 1; }
};

/// Where in a half a kernel is exact.
enum class KernelPlace { Middle, Rim };

/// The lobe sampled at the texels of the shrunk map, 0 beyond the clamp. A tap at the distance s stands for the angle 2 atan(s) in the
/// middle of the half and for 90 degrees - 2 atan(1 - s) at the rim.
SampledKernel sampleKernel(const Lobe& lobe, double reach, int half, int shrink, KernelPlace place);

/// Side of a half with its border, in texels: whole texels of the most shrunk map on each side of the middle.
/// @param border  at least so many texels around the disc; 0: as far as the large kernel and the bilinear lookup after it reach
int blendedHalfSide(const KernelSizes& sizes, const SampledKernel& large, int half, int border);

/// Share of the map filtered with the large kernel at the distance d from the middle: d^2, at most 1.
double largeKernelShare(double d);

/// Distortion of a circle of radius r about a point at the distance d when it is brought back to the sphere, as in figure 12. It stays a
/// circle; what suffers is its middle: with a the angle from the projected center to the nearer and b to the farther side,
///   a = 2 (atan d - atan(d - r)),   b = 2 (atan(d + r) - atan d),   distortion = |a - b| / (a + b),
/// the angle between the two centers over the radius. 0 in the middle of a half, 0.24 at the rim for a radius of 1/2.
double circleDistortion(double d, double r);

/// The circle in the plane of the front half that a cap of the sphere becomes: exactly a circle, its center displaced from the projection
/// of the cap's own center, which is r.xy/(1 + r.z).
struct CapCircle {
    glm::dvec2 center{0.0};
    double radius = 0.0;
};
/// center = r.xy / (r.z + cos t), radius = sin t / (r.z + cos t): the circle through the stereographic images of the cap's nearest and
/// farthest points on the meridian of r.
/// @param r  unit; r.z > -cos t, so that the cap does not hold the point of projection
/// @param t  the cap's angle
CapCircle circleOfCap(const glm::dvec3& r, double t);

/// Radius in texels of a disc in whose middle a kernel of this reach is `largestKernel` texels across.
double exactHalfRadius(double reach, int largestKernel);

/// Weights of cubic Lagrange interpolation at f in [0, 1] between texels 0 and 1, for texels -1, 0, 1 and 2.
std::array<double, 4> cubicWeights(double f);

} // namespace mirrorball
