#include "paraboloid.h"

#include "exact_paraboloid_sum.h"

#include "core/base/error.h"
#include "core/image/reproject.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 2> kernelWords{"blended", "exact"};

/// A disc of more texels takes half a gigabyte.
constexpr double largestRadius = 1024.0;
/// Texels around the exact variant's disc: a radiance at its rim is spread over two beyond it.
constexpr int spreadMargin = 2;

double reachOf(const Lobe& lobe, const ParaboloidKnobs& knobs) { return LobeShape(lobe).support(knobs.clamp); }

ParaboloidHalves layOutBlended(const EnvironmentMap& latlong, const Lobe& lobe, const ParaboloidKnobs& knobs, const JobControl& job)
{
    const double reach = reachOf(lobe, knobs);
    ParaboloidHalves halves{
        .kernel = knobs.kernel, .radius = 0.5 * knobs.half, .sizes = kernelSizes(reach, knobs.half, knobs.largestKernel)};
    halves.small = sampleKernel(lobe, reach, knobs.half, halves.sizes.smallShrink, KernelPlace::Middle);
    halves.large = sampleKernel(lobe, reach, knobs.half, halves.sizes.largeShrink, KernelPlace::Rim);
    halves.side = blendedHalfSide(halves.sizes, halves.large, knobs.half, knobs.border);
    const MapLayout layout{Parameterization::Paraboloid, halves.side, (halves.side - knobs.half) / 2};
    const EnvironmentMap map = reproject(latlong, {.target = layout}, job);
    halves.texels.resize(map.image.texels.size() / 3);
    for (size_t i = 0; i < halves.texels.size(); ++i)
        halves.texels[i] = {map.image.texels[3 * i], map.image.texels[3 * i + 1], map.image.texels[3 * i + 2], 1.0f};
    return halves;
}

/// One half: the sum over the probe's texels in its hemisphere. The two share nothing.
void spreadOver(ParaboloidHalves& halves, const EnvironmentMap& latlong, bool isBack, const JobControl& job)
{
    const int width = latlong.image.width, height = latlong.image.height, side = halves.side;
    std::vector<double> sinLon(static_cast<size_t>(width)), cosLon(static_cast<size_t>(width));
    for (int x = 0; x < width; ++x) {
        const double lon = pi - 2.0 * pi * (x + 0.5) / width;
        sinLon[static_cast<size_t>(x)] = std::sin(lon);
        cosLon[static_cast<size_t>(x)] = std::cos(lon);
    }
    std::vector<glm::dvec4> sums(static_cast<size_t>(side) * static_cast<size_t>(side), glm::dvec4(0.0));
    for (int y = 0; y < height; ++y) {
        job.checkStop();
        const double latitude = 0.5 * pi - pi * (y + 0.5) / height, sinLat = std::sin(latitude), cosLat = std::cos(latitude);
        const double solidAngle = texelSolidAngle(latlong.layout, 0, y);
        const float* row = latlong.image.row(y);
        for (int x = 0; x < width; ++x) {
            const double z = cosLon[static_cast<size_t>(x)] * cosLat;
            if ((z < 0.0) != isBack)
                continue;
            const double scale = halves.radius / (1.0 + std::abs(z));
            const double px = 0.5 * side + scale * sinLon[static_cast<size_t>(x)] * cosLat - 0.5, py = 0.5 * side - scale * sinLat - 0.5;
            const int ix = static_cast<int>(std::floor(px)), iy = static_cast<int>(std::floor(py));
            const std::array<double, 4> wx = cubicWeights(px - ix), wy = cubicWeights(py - iy);
            const glm::dvec4 value = solidAngle * glm::dvec4(row[3 * x], row[3 * x + 1], row[3 * x + 2], 1.0);
            for (int j = 0; j < 4; ++j) {
                glm::dvec4* out = &sums[static_cast<size_t>(iy - 1 + j) * static_cast<size_t>(side) + static_cast<size_t>(ix - 1)];
                const glm::dvec4 part = wy[static_cast<size_t>(j)] * value;
                for (int i = 0; i < 4; ++i)
                    out[i] += wx[static_cast<size_t>(i)] * part;
            }
        }
    }
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            halves.texels[static_cast<size_t>(2 * y + (isBack ? 1 : 0)) * static_cast<size_t>(side) + static_cast<size_t>(x)] =
                glm::vec4(sums[static_cast<size_t>(y) * static_cast<size_t>(side) + static_cast<size_t>(x)]);
}

ParaboloidHalves layOutExact(const EnvironmentMap& latlong, const Lobe& lobe, const ParaboloidKnobs& knobs, const JobControl& job)
{
    const double reach = reachOf(lobe, knobs), radius = exactHalfRadius(reach, knobs.largestKernel);
    ParaboloidHalves halves{.kernel = knobs.kernel,
                            .side = 2 * (static_cast<int>(std::ceil(radius)) + spreadMargin + 1),
                            .radius = radius,
                            .lobe = lobe,
                            .reach = reach};
    // Texels that hold anything lie no farther out than this; a lobe ends `reach` from its axis.
    const double outermost = 2.0 * std::atan(1.0 + 1.5 * spreadMargin / radius) - 0.5 * pi + reach;
    if (outermost < 0.5 * pi)
        halves.leastAlongAxis = -std::sin(outermost);
    halves.texels.resize(2 * static_cast<size_t>(halves.side) * static_cast<size_t>(halves.side));
    const JobControl quiet{.stop = job.stop, .progress = {}, .threads = job.threads};
    parallelRows(
        2, quiet,
        [&](int first, int last) {
            for (int half = first; half < last; ++half)
                spreadOver(halves, latlong, half == 1, quiet);
        },
        1);
    return halves;
}

/// A map of vec4 in double, as the steps of the blended variant pass it on.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<glm::dvec4> texels{};

    Plane(int width_, int height_) : width(width_), height(height_), texels(static_cast<size_t>(width) * static_cast<size_t>(height)) {}
    glm::dvec4& at(int x, int y) { return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)]; }
    const glm::dvec4& at(int x, int y) const
    {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

/// Steps 6 to 9 of 000: shrinks the map by boxes and convolves it. Taps beyond the half's border are left out and the others make up for
/// them, where OpenGL's convolution left dark borders.
Plane shrunkAndFiltered(const ParaboloidHalves& halves, int shrink, const SampledKernel& kernel)
{
    const int side = halves.side / shrink;
    Plane shrunk(2 * side, side), filtered(2 * side, side);
    for (int y = 0; y < halves.side; ++y)
        for (int x = 0; x < 2 * halves.side; ++x)
            shrunk.at(x / shrink, y / shrink) +=
                glm::dvec4(halves.texels[static_cast<size_t>(y) * static_cast<size_t>(2 * halves.side) + static_cast<size_t>(x)]);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < 2 * side; ++x) {
            const int left = x / side * side;
            glm::dvec4 sum(0.0);
            for (int j = -kernel.reach; j <= kernel.reach; ++j)
                for (int i = -kernel.reach; i <= kernel.reach; ++i)
                    if (x + i >= left && x + i < left + side && y + j >= 0 && y + j < side)
                        sum += kernel.weights[static_cast<size_t>((j + kernel.reach) * kernel.side() + i + kernel.reach)] *
                               shrunk.at(x + i, y + j);
            filtered.at(x, y) = sum / sum.w;
        }
    return filtered;
}

/// Bilinear within one half.
glm::dvec4 magnified(const Plane& plane, int half, const glm::dvec2& p)
{
    const int side = plane.height;
    const glm::dvec2 corner = glm::floor(p - 0.5), f = p - 0.5 - corner;
    const auto texel = [&](int dx, int dy) {
        return plane.at(half * side + std::clamp(static_cast<int>(corner.x) + dx, 0, side - 1),
                        std::clamp(static_cast<int>(corner.y) + dy, 0, side - 1));
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

std::vector<glm::dvec3> sumBlended(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job)
{
    const Plane small = shrunkAndFiltered(halves, halves.sizes.smallShrink, halves.small);
    const Plane large = shrunkAndFiltered(halves, halves.sizes.largeShrink, halves.large);
    std::vector<glm::dvec3> result(directions.size());
    parallelRows(
        static_cast<int>(directions.size()), job,
        [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                const glm::dvec3 r = directions[static_cast<size_t>(i)];
                const glm::dvec2 q = glm::dvec2(r.x, r.y) / (1.0 + std::abs(r.z));
                const glm::dvec2 p(0.5 * halves.side + halves.radius * q.x, 0.5 * halves.side - halves.radius * q.y);
                const int half = r.z < 0.0 ? 1 : 0;
                result[static_cast<size_t>(i)] =
                    glm::mix(glm::dvec3(magnified(small, half, p / double(halves.sizes.smallShrink))),
                             glm::dvec3(magnified(large, half, p / double(halves.sizes.largeShrink))), largeKernelShare(glm::length(q)));
            }
        },
        256);
    return result;
}

} // namespace

std::span<const std::string_view> words(ParaboloidKernel) { return kernelWords; }

ParaboloidKnobs resolved(ParaboloidKnobs knobs, int probeHeight)
{
    const bool blended = knobs.kernel == ParaboloidKernel::Blended;
    if (knobs.clamp == 0.0)
        knobs.clamp = blended ? 0.1 : 1e-3;
    if (knobs.largestKernel == 0)
        knobs.largestKernel = blended ? 7 : 17;
    if (knobs.half == 0)
        knobs.half = std::clamp(probeHeight, 16, 4096);
    knobs.half += knobs.half % 2; // the disc's middle lies between texels
    return knobs;
}

std::string paraboloidRefusal(const Lobe& lobe, const ParaboloidKnobs& knobs)
{
    if (knobs.largestKernel < 3)
        return "paraboloid_kernel: a kernel needs at least 3 texels";
    if (lobe.isMirror())
        return "paraboloid: a mirror has no kernel; look the probe up instead";
    const double reach = reachOf(lobe, knobs);
    if (knobs.kernel == ParaboloidKernel::Exact) {
        const double radius = exactHalfRadius(reach, knobs.largestKernel);
        if (radius > largestRadius)
            return "paraboloid: the lobe is so narrow that a kernel of " + std::to_string(knobs.largestKernel) +
                   " texels needs halves of " + std::to_string(2 * static_cast<std::int64_t>(std::min(radius, 1e12))) + ", and " +
                   std::to_string(2 * static_cast<int>(largestRadius)) + " is the most; use direct";
        return {};
    }
    if (const KernelSizes sizes = kernelSizes(reach, knobs.half, knobs.largestKernel); sizes.small < 4)
        return "paraboloid: the lobe is only " + std::to_string(sizes.small) + " texels wide in a half of " + std::to_string(knobs.half) +
               "; give paraboloid_half more texels, or use direct";
    return {};
}

ParaboloidHalves layOutHalves(const EnvironmentMap& latlong, const Lobe& lobe, const ParaboloidKnobs& knobs, const JobControl& job)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("paraboloid: the probe must be a latlong map; reproject it first");
    if (const std::string why = paraboloidRefusal(lobe, knobs); !why.empty())
        throw InvalidArgument(why);
    return knobs.kernel == ParaboloidKernel::Blended ? layOutBlended(latlong, lobe, knobs, job) : layOutExact(latlong, lobe, knobs, job);
}

std::vector<glm::dvec3> paraboloidSum(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const JobControl& job)
{
    return halves.kernel == ParaboloidKernel::Blended ? sumBlended(halves, directions, job) : exactParaboloidSum(halves, directions, job);
}

} // namespace mirrorball
