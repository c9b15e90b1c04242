#include "importance.h"

#include "mip_blur.h"

#include "core/base/multiversion.h"
#include "core/image/mip_pyramid.h"
#include "core/image/spline_lookup.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace mirrorball {

namespace {

/// i times the golden ratio, without its whole part: the sequence in one dimension that leaves no gaps.
double goldenSequence(int i)
{
    constexpr double golden = 0.61803398874989484820;
    const double value = golden * i;
    return value - std::floor(value);
}

/// The radii at which the lobe holds (i + 1/2)/count of its integral, by Simpson's rule over panels that crowd at the axis.
std::vector<double> quantiles(const LobeShape& shape, int count)
{
    constexpr int panels = 8192;
    const auto angle = [](double u) { return 0.5 * pi * u * u * u; };
    const auto integrand = [&](double t) { return shape.relative(std::cos(t)) * std::sin(t); };
    std::vector<double> cumulated{0.0};
    for (int j = 0; j < panels; ++j) {
        const double a = angle(static_cast<double>(j) / panels), b = angle(static_cast<double>(j + 1) / panels);
        cumulated.push_back(cumulated.back() + (b - a) / 6.0 * (integrand(a) + 4.0 * integrand(0.5 * (a + b)) + integrand(b)));
    }
    std::vector<double> radii;
    size_t j = 0;
    for (int i = 0; i < count; ++i) {
        const double wanted = cumulated.back() * (i + 0.5) / count;
        while (j + 2 < cumulated.size() && cumulated[j + 1] < wanted)
            ++j;
        const double part = (wanted - cumulated[j]) / std::max(cumulated[j + 1] - cumulated[j], 1e-300);
        const double a = angle(static_cast<double>(j) / panels), b = angle(static_cast<double>(j + 1) / panels);
        radii.push_back(std::sqrt(a * a + std::clamp(part, 0.0, 1.0) * (b * b - a * a))); // even within a ring
    }
    return radii;
}

/// Samples in planes, so that the arithmetic on directions vectorises.
struct Planes {
    std::vector<float> x{}, y{}, z{}, fraction{};
    std::vector<int> level{};
};

constexpr int block = 64;

/// Variance of a sample's blur over that of its square cell. Less lets a sun show the samples one by one, more blurs the lobe: of 1, 2,
/// 4 and 8 this one has the least error on the test probes, from 64 to 4096 samples.
constexpr double overlap = 4.0;

/// atan for |a| <= 1, to 2e-8. Source: Abramowitz and Stegun 4.4.49.
inline float smallAtan(float a)
{
    const float s = a * a;
    return a *
           (1.0f +
            s * (-0.3333314528f +
                 s * (0.1999355085f +
                      s * (-0.1420889944f +
                           s * (0.1065626393f + s * (-0.0752896400f + s * (0.0429096138f + s * (-0.0161657367f + s * 0.0028662257f))))))));
}

/// atan2 without branches, so that the loop below vectorises.
inline float quickAtan2(float y, float x)
{
    const float ax = std::abs(x), ay = std::abs(y);
    const float low = std::min(ax, ay), high = std::max(std::max(ax, ay), 1e-30f);
    float angle = smallAtan(low / high);
    angle = ay > ax ? 1.57079633f - angle : angle;
    angle = x < 0.0f ? 3.14159265f - angle : angle;
    return y < 0.0f ? -angle : angle;
}

/// Image positions, as shares of the width and height, of a block of samples about r = axes[2].
MIRRORBALL_CLONES
void positions(const float* sx, const float* sy, const float* sz, const std::array<std::array<float, 3>, 3>& axes, float* u, float* v)
{
    constexpr float perTurn = 0.159154943f, perHalf = 0.318309886f;
    for (int i = 0; i < block; ++i) {
        const float x = sx[i] * axes[0][0] + sy[i] * axes[1][0] + sz[i] * axes[2][0];
        const float y = sx[i] * axes[0][1] + sy[i] * axes[1][1] + sz[i] * axes[2][1];
        const float z = sx[i] * axes[0][2] + sy[i] * axes[1][2] + sz[i] * axes[2][2];
        u[i] = 0.5f - perTurn * quickAtan2(x, z);
        v[i] = 0.5f - perHalf * quickAtan2(y, std::sqrt(x * x + z * z));
    }
}

typedef float Texel4 __attribute__((vector_size(16), aligned(4), may_alias));

inline Texel4 bilinear(const LookupPyramid::Level& level, float u, float v)
{
    const float px = u * static_cast<float>(level.width) - 0.5f, py = v * static_cast<float>(level.height) - 0.5f;
    const float x0 = std::floor(px), y0 = std::floor(py);
    const float fx = px - x0, fy = py - y0;
    // u and v may round to just outside [0, 1]
    const auto* top = reinterpret_cast<const Texel4*>(
        level.at(std::clamp(static_cast<int>(x0), -1, level.width - 1), std::clamp(static_cast<int>(y0), -1, level.height - 1)));
    const auto* bottom = top + level.width + 2;
    return (1.0f - fy) * ((1.0f - fx) * top[0] + fx * top[1]) + fy * ((1.0f - fx) * bottom[0] + fx * bottom[1]);
}

} // namespace

std::vector<LobeSample> lobeSamples(const Lobe& lobe, int count, int latlongHeight)
{
    const LobeShape shape(lobe);
    const double h2 = pi / latlongHeight * (pi / latlongHeight);
    const double last = std::bit_width(static_cast<unsigned>(latlongHeight)) - 1.0;
    const std::vector<double> radii = quantiles(shape, count);
    std::vector<LobeSample> samples;
    for (int i = 0; i < count; ++i) {
        const double t = radii[static_cast<size_t>(i)], phi = 2.0 * pi * goldenSequence(i);
        const double density = std::max(shape.relative(std::cos(t)), 1e-12) / shape.integral();
        const double cell = std::min(1.0 / (count * density), 4.0 * pi);
        // A square cell has a variance of its area over 12 per axis.
        const double level = std::min(levelForVariance(overlap * cell / 12.0, h2), last);
        samples.push_back({.x = std::sin(t) * std::cos(phi),
                           .y = std::sin(t) * std::sin(phi),
                           .z = std::cos(t),
                           .level = level,
                           .variance = blurVariance(level, h2),
                           .cell = cell});
    }
    return samples;
}

EnvironmentMap withInterpolatedEnergy(EnvironmentMap map)
{
    const int n = map.layout.size, last = n - 1, width = 3 * map.image.width;
    const double h = pi / n, half = std::sin(0.5 * h);
    double surplus = 1.0 - 2.0 / h * half; // of the tent that is folded back over the pole
    for (int y = 0; y + 1 <= last / 2; ++y) {
        const double across = std::sin(h * (y + 0.5)), own = y == 0 ? surplus : 0.0;
        const double interpolated = 2.0 * (1.0 - std::cos(h)) / h * across + own, area = 2.0 * half * across;
        surplus = interpolated + (y == 0 ? 0.0 : surplus) - area;
        const auto share = static_cast<float>(surplus / interpolated);
        for (const int row : {y, last - y}) {
            float* values = map.image.row(row);
            const float* inner = map.image.row(row == y ? y + 1 : row - 1);
            for (int i = 0; i < width; ++i)
                values[i] += share * (inner[i] - values[i]);
        }
    }
    return map;
}

LookupPyramid::LookupPyramid(const EnvironmentMap& latlong, const JobControl& job)
{
    for (EnvironmentMap& map : buildMipPyramid(latlong, job).levels) {
        const EnvironmentMap smooth = withInterpolatedEnergy(map.layout.size >= 4 ? smoothedPoles(std::move(map)) : std::move(map));
        Level level{.width = smooth.image.width, .height = smooth.image.height};
        level.texels.resize(4 * static_cast<size_t>(level.width + 2) * static_cast<size_t>(level.height + 2));
        for (int y = -1; y <= level.height; ++y)
            for (int x = -1; x <= level.width; ++x) {
                const Texel t = acrossSeam(smooth.layout, {0, 0}, x, y);
                std::copy_n(smooth.image.texel(t.x, t.y), 3, level.at(x, y));
            }
        m_levels.push_back(std::move(level));
    }
}

EnvironmentMap importanceSample(const LookupPyramid& pyramid, const Lobe& lobe, int samples, const MapLayout& target, double yaw,
                                const JobControl& job)
{
    Planes planes;
    for (const LobeSample& s : lobeSamples(lobe, samples, pyramid.levels().front().height)) {
        planes.x.push_back(static_cast<float>(s.x));
        planes.y.push_back(static_cast<float>(s.y));
        planes.z.push_back(static_cast<float>(s.z));
        planes.level.push_back(std::min(static_cast<int>(s.level), static_cast<int>(pyramid.levels().size()) - 1));
        planes.fraction.push_back(static_cast<float>(s.level - planes.level.back()));
    }
    const auto padded = static_cast<size_t>((samples + block - 1) / block * block);
    for (auto* plane : {&planes.x, &planes.y, &planes.z})
        plane->resize(padded, 1.0f);

    EnvironmentMap map(target);
    parallelRows(
        map.image.height, job,
        [&](int first, int last) {
            std::array<float, block> u, v;
            for (int row = first; row < last; ++row)
                for (int column = 0; column < map.image.width; ++column) {
                    const glm::dvec3 r = yawed(texelDirection(target, column, row), -yaw);
                    // A frame about r without a branch. Source: T. Duff et al., "Building an Orthonormal Basis, Revisited", 2017.
                    const double sign = std::copysign(1.0, r.z), a = -1.0 / (sign + r.z), b = r.x * r.y * a;
                    const auto single = [](double x, double y, double z) {
                        return std::array<float, 3>{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
                    };
                    const std::array<std::array<float, 3>, 3> axes{single(1.0 + sign * r.x * r.x * a, sign * b, -sign * r.x),
                                                                   single(b, sign + r.y * r.y * a, -r.y), single(r.x, r.y, r.z)};
                    glm::dvec3 sum(0.0);
                    for (int start = 0; start < samples; start += block) {
                        positions(planes.x.data() + start, planes.y.data() + start, planes.z.data() + start, axes, u.data(), v.data());
                        const int end = std::min(block, samples - start);
                        for (int i = 0; i < end; ++i) {
                            const auto s = static_cast<size_t>(start + i), k = static_cast<size_t>(i);
                            const auto level = static_cast<size_t>(planes.level[s]);
                            const float fraction = planes.fraction[s];
                            Texel4 value = bilinear(pyramid.levels()[level], u[k], v[k]);
                            if (fraction > 0.0f)
                                value = (1.0f - fraction) * value + fraction * bilinear(pyramid.levels()[level + 1], u[k], v[k]);
                            sum += glm::dvec3(value[0], value[1], value[2]);
                        }
                    }
                    const glm::vec3 mean(sum / static_cast<double>(samples));
                    std::copy_n(&mean.x, 3, map.image.texel(column, row));
                }
        },
        1);
    return map;
}

} // namespace mirrorball
