#include "mip_blur.h"

#include "core/sphere/cube_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mirrorball {

namespace {

constexpr double perHalving = 0.25; ///< 3/4 texel^2 a halving, summed over the levels below: (4^level - 1)/3 times it
constexpr double tent = 1.0 / 6.0;

/// What the sphere sees of a cube map's texels: their solid angle averaged over directions. Large texels cover more of them: with
/// w = 4/N^2 (1 + s^2 + t^2)^(-3/2), sum w^2 / sum w is 1.144 times the plain mean.
double meanSolidAngle(const MapLayout& cube)
{
    constexpr double uneven = 1.144;
    return uneven * 4.0 * pi / (6.0 * cube.size * static_cast<double>(cube.size));
}

double varianceAtWhole(double level, double h2) { return h2 * (std::exp2(2.0 * level) * (perHalving + tent) - perHalving); }

/// Bilinear within one face, its edge texels repeated outwards: GL_CLAMP_TO_EDGE.
glm::vec3 clampedLookup(const EnvironmentMap& map, const glm::dvec3& d)
{
    const int n = map.layout.size;
    const cube_map::FacePosition at = cube_map::facePosition(d);
    const double px = 0.5 * n * (at.s + 1.0) - 0.5, py = 0.5 * n * (at.t + 1.0) - 0.5;
    const double x0 = std::floor(px), y0 = std::floor(py);
    const auto fx = static_cast<float>(px - x0), fy = static_cast<float>(py - y0);
    const auto texel = [&](double x, double y) {
        const float* t =
            map.image.texel(std::clamp(static_cast<int>(x), 0, n - 1), at.face * n + std::clamp(static_cast<int>(y), 0, n - 1));
        return glm::vec3(t[0], t[1], t[2]);
    };
    return glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), fx), glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), fx), fy);
}

glm::vec3 clampedTrilinear(const MipPyramid& pyramid, const glm::dvec3& d, double level)
{
    const size_t fine = static_cast<size_t>(level);
    const auto fraction = static_cast<float>(level - static_cast<double>(fine));
    const glm::vec3 a = clampedLookup(pyramid.levels[fine], d);
    return fraction > 0.0f ? glm::mix(a, clampedLookup(pyramid.levels[fine + 1], d), fraction) : a;
}

/// -ln k_1, the variance per axis of the blur as wide as the lobe.
double lobeVariance(const Lobe& lobe) { return lobe.isMirror() ? 0.0 : -std::log(legendreCoefficients(lobe, 1)[1]); }

} // namespace

MapLayout environmentCube(int latlongWidth)
{
    return {Parameterization::Cube, static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(1, latlongWidth / 4)))), 0};
}

MipPyramid blurPyramid(const EnvironmentMap& cube, MipFiltering filtering, const JobControl& job)
{
    if (filtering == MipFiltering::AcrossSeams)
        return buildMipPyramid(cube, job);
    return buildFacePyramid(cube, job);
}

double blurVariance(double level, double h2)
{
    const double whole = std::floor(level), fraction = level - whole;
    return (1.0 - fraction) * varianceAtWhole(whole, h2) + fraction * varianceAtWhole(whole + 1.0, h2);
}

double levelForVariance(double variance, double h2)
{
    if (variance <= blurVariance(0.0, h2))
        return 0.0;
    // The whole level below, then linear within it.
    const double whole = std::floor(0.5 * std::log2((variance / h2 + perHalving) / (perHalving + tent)) + 1e-12);
    const double low = varianceAtWhole(whole, h2), high = varianceAtWhole(whole + 1.0, h2);
    return whole + std::clamp((variance - low) / (high - low), 0.0, 1.0);
}

double matchedLambda(const Lobe& lobe, const MapLayout& environment)
{
    return levelForVariance(lobeVariance(lobe), meanSolidAngle(environment));
}

double matchedExponent(double lambda, const MapLayout& environment)
{
    return std::max(0.0, 1.0 / std::expm1(blurVariance(std::max(0.0, lambda), meanSolidAngle(environment))) - 1.0);
}

EnvironmentMap mipBlur(const MipPyramid& pyramid, MipFiltering filtering, double lambda, const MapLayout& target, double yaw,
                       const JobControl& job)
{
    const double last = static_cast<double>(pyramid.levels.size()) - 1.0;
    const double h2 = meanSolidAngle(pyramid.levels.front().layout);
    EnvironmentMap map(target);
    parallelRows(map.image.height, job, [&](int first, int out) {
        for (int y = first; y < out; ++y)
            for (int x = 0; x < map.image.width; ++x) {
                const glm::dvec3 d = yawed(texelDirection(target, x, y), -yaw);
                const double own = density(target, {x + 0.5, y + 0.5});
                const double natural = own > h2 ? 0.5 * std::log2(own / h2) : 0.0;
                const double level = std::clamp(std::max(lambda, natural), 0.0, last);
                const glm::vec3 value =
                    filtering == MipFiltering::PerFace ? clampedTrilinear(pyramid, d, level) : radiance(pyramid, d, level);
                std::copy_n(&value.x, 3, map.image.texel(x, y));
            }
    });
    return map;
}

std::vector<TransferModel::Blur> mipBlurs(double lambda, const MapLayout& environment)
{
    const double h2 = meanSolidAngle(environment);
    const double level = std::min(std::max(0.0, lambda), std::log2(static_cast<double>(environment.size)));
    const double whole = std::floor(level), fraction = level - whole;
    return {{1.0 - fraction, varianceAtWhole(whole, h2)}, {fraction, varianceAtWhole(whole + 1.0, h2)}};
}

std::vector<double> mipTransfer(double lambda, const MapLayout& environment, int bandLimit)
{
    std::vector<double> transfer(static_cast<size_t>(bandLimit) + 1, 0.0);
    for (const TransferModel::Blur& blur : mipBlurs(lambda, environment))
        for (int l = 0; l <= bandLimit; ++l)
            transfer[static_cast<size_t>(l)] += blur.share * std::exp(-0.5 * l * (l + 1.0) * blur.variance);
    return transfer;
}

std::vector<double> mipScatter(double lambda, const MapLayout& environment, int bandLimit)
{
    const double h2 = meanSolidAngle(environment);
    const double level = std::min(std::max(0.0, lambda), std::log2(static_cast<double>(environment.size)));
    const double whole = std::floor(level), fraction = level - whole;
    constexpr double asSeen = 0.4; // of that sum on the test probes: a level's texels are smoothed by those that they were averaged from
    const auto atWhole = [&](double n, int l) {
        const double h = std::exp2(n) * std::sqrt(h2), k = std::sqrt(l * (l + 1.0));
        constexpr int headings = 8;
        double scatter = 0.0;
        for (int i = 0; i < headings; ++i) {
            const double heading = 0.5 * pi * (i + 0.5) / headings;
            double square = 1.0, mean = 1.0, box = 1.0;
            for (const double t : {k * h * std::cos(heading), k * h * std::sin(heading)}) {
                const double sinc = t > 1e-6 ? std::sin(0.5 * t) / (0.5 * t) : 1.0;
                square *= 1.0 - (1.0 - std::cos(t)) / 3.0;
                mean *= sinc * sinc;
                box *= sinc;
            }
            scatter += box * box * std::max(0.0, square - mean * mean) / headings;
        }
        return scatter;
    };
    std::vector<double> result;
    for (int l = 0; l <= bandLimit; ++l)
        result.push_back(asSeen *
                         ((1.0 - fraction) * (1.0 - fraction) * atWhole(whole, l) + fraction * fraction * atWhole(whole + 1.0, l)));
    return result;
}

} // namespace mirrorball
