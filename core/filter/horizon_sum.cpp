#include "horizon_sum.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr int lanes = floatLanes;
using Lanes = FloatLanes;
using Wholes = IntLanes;
typedef double Wide __attribute__((vector_size(64), aligned(8), may_alias)); // eight, in two registers
using Sums = LaneSums;
using Tables = HorizonSum::Tables;

/// s becomes s^n, s in (0, 1], to some 1e-7 of it: log2 by the area tangent of (m - 1)/(m + 1), exp2 by its series.
[[gnu::always_inline]] inline void raise(Lanes& s, float n)
{
    const auto bits = __builtin_bit_cast(Wholes, s);
    const Wholes exponent = (bits - 0x3f3504f3) >> 23; // of s = m 2^exponent, m within [1/sqrt 2, sqrt 2)
    const auto m = __builtin_bit_cast(Lanes, bits - (exponent << 23));
    const Lanes t = (m - 1.0f) / (m + 1.0f), t2 = t * t;
    const Lanes log = __builtin_convertvector(exponent, Lanes) +
                      t * (2.8853901f + t2 * (0.9617967f + t2 * (0.5770780f + t2 * 0.4121986f))); // 2/ln 2 times 1, 1/3, 1/5, 1/7
    Lanes z = n * log;
    z = z < -120.0f ? Lanes{} - 120.0f : z;
    const Wholes whole = __builtin_convertvector(z - 0.5f, Wholes); // towards 0: z <= 0
    const Lanes f = (z - __builtin_convertvector(whole, Lanes)) * 0.69314718f;
    const Lanes e = 1.0f + f * (1.0f + f * (0.5f + f * (1.0f / 6 + f * (1.0f / 24 + f * (1.0f / 120 + f * (1.0f / 720))))));
    s = __builtin_bit_cast(Lanes, __builtin_bit_cast(Wholes, e) + (whole << 23));
}

/// What is the same for all texels of a row.
struct Row {
    double least = 0.0, ofCosine = 0.0, ofSine = 0.0; ///< x/width = least + ofCosine cos + ofSine sin of a column's azimuth
    std::ptrdiff_t start = 0;                         ///< of the row in its planes
    float weight = 0.0f;
};

/// Columns [x, x + count).
[[gnu::always_inline]] inline void addColumns(const Tables& t, const Row& row, float n, int x, int count, Sums& sums)
{
    const float *red = t.planes.channels[0].data() + row.start + x, *green = t.planes.channels[1].data() + row.start + x,
                *blue = t.planes.channels[2].data() + row.start + x;
    const double *cosine = t.cosine.data() + x, *sine = t.sine.data() + x;
    constexpr auto& a = HorizonSplit::nearSeries;
    constexpr float a0 = a[0], a1 = a[1], a2 = a[2], a3 = a[3], a4 = a[4];
    const Lanes none{};
    const Wholes lane{0, 1, 2, 3, 4, 5, 6, 7};
    Lanes r{}, g{}, b{}, one{};
    for (int i = 0; i < count; i += lanes) {
        const Wide wide =
            row.least + row.ofCosine * *reinterpret_cast<const Wide*>(cosine + i) + row.ofSine * *reinterpret_cast<const Wide*>(sine + i);
        const Lanes s = __builtin_convertvector(wide, Lanes);
        const Wholes counts = (s > 0.0f) & (s < 1.0f) & (lane < count - i);
        Lanes inside = counts ? s : none + 1.0f;
        const Lanes c = 2.0f * inside - 1.0f, c2 = c * c;
        const Lanes share = 0.5f - c * (a0 + c2 * (a1 + c2 * (a2 + c2 * (a3 + c2 * a4))));
        raise(inside, n);
        const Lanes k = counts ? inside * share : none;
        r += k * *reinterpret_cast<const Lanes*>(red + i);
        g += k * *reinterpret_cast<const Lanes*>(green + i);
        b += k * *reinterpret_cast<const Lanes*>(blue + i);
        one += k;
    }
    sums.red += row.weight * r;
    sums.green += row.weight * g;
    sums.blue += row.weight * b;
    sums.one += row.weight * one;
}

/// The angle whose cosine is x, clamped to [-1, 1]. Source: Abramowitz and Stegun 4.4.45, within 7e-5; and a float's cosine near 1 or -1
/// tells an angle to some 6e-4.
[[gnu::always_inline]] inline float roughArcCosine(float x)
{
    const float c = std::min(std::abs(x), 1.0f);
    const float angle = std::sqrt(1.0f - c) * (1.5707288f + c * (-0.2121144f + c * (0.0742610f - c * 0.0187293f)));
    return x < 0.0f ? 3.14159265f - angle : angle;
}
constexpr double arcCosineError = 8e-4;

[[gnu::always_inline]] inline glm::dvec4 sumAt(const Tables& t, double azimuth, double colatitude)
{
    const int width = t.planes.width;
    const double columnWidth = 2.0 * pi / width, turns = azimuth / (2.0 * pi), column = (turns - std::floor(turns)) * width - 0.5;
    const double sine = std::sin(colatitude), cosine = std::cos(colatitude), perWidth = 1.0 / t.width;
    const double across = std::cos(azimuth) * sine * perWidth, along = std::sin(azimuth) * sine * perWidth;
    const auto n = static_cast<float>(t.exponent);
    const double more = 0.01 + arcCosineError / columnWidth; // columns that are looked at beyond those told; x decides
    Sums sums;
    constexpr int some = 16; // angles of some rows at once: vectors of the compiler's
    std::array<float, some> ends, starts;
    for (int first = 0; first < t.planes.height; first += some) {
        const int rows = std::min(some, t.planes.height - first);
        for (int i = 0; i < rows; ++i) {
            const auto y = static_cast<size_t>(first + i);
            const auto b = static_cast<float>(cosine * t.rowCosine[y]), a = static_cast<float>(sine * t.rowSine[y]),
                       per = 1.0f / std::max(a, 1e-30f);
            ends[static_cast<size_t>(i)] = roughArcCosine(-b * per);                                  // x > 0 up to here
            starts[static_cast<size_t>(i)] = roughArcCosine((static_cast<float>(t.width) - b) * per); // x < width from here
        }
        for (int i = 0; i < rows; ++i) {
            const double start = static_cast<double>(starts[static_cast<size_t>(i)]) / columnWidth - more,
                         end = static_cast<double>(ends[static_cast<size_t>(i)]) / columnWidth + more;
            if (end <= start)
                continue;
            const auto y = static_cast<size_t>(first + i);
            const Row row{.least = cosine * t.rowCosine[y] * perWidth,
                          .ofCosine = across * t.rowSine[y],
                          .ofSine = along * t.rowSine[y],
                          .start = static_cast<std::ptrdiff_t>(y) * t.planes.stride,
                          .weight = static_cast<float>(t.planes.solidAngles[y])};
            // [from, to], from within [-width, 2 width). Inlined, so that it is built for the processor that its clone is for.
            const auto add = [&](int from, int to) __attribute__((always_inline))
            {
                const int count = std::min(to - from + 1, width);
                from += from < 0 ? width : from >= width ? -width : 0;
                const int here = std::min(count, width - from);
                addColumns(t, row, n, from, here, sums);
                if (here < count)
                    addColumns(t, row, n, 0, count - here, sums);
            };
            const int left = static_cast<int>(std::ceil(column - end)), leftEnd = static_cast<int>(std::floor(column - start)),
                      right = static_cast<int>(std::ceil(column + start)), rightEnd = static_cast<int>(std::floor(column + end));
            const bool meetsBefore = leftEnd >= right - 1, meetsBehind = rightEnd >= left + width - 1;
            if (meetsBefore && meetsBehind) {
                addColumns(t, row, n, 0, width, sums);
            } else if (meetsBefore) {
                if (rightEnd >= left)
                    add(left, rightEnd);
            } else if (meetsBehind) {
                add(right, leftEnd + width);
            } else {
                if (leftEnd >= left)
                    add(left, leftEnd);
                if (rightEnd >= right)
                    add(right, rightEnd);
            }
        }
    }
    return sums.total(t.planes.scale) * t.factor;
}

} // namespace

MIRRORBALL_CLONES // hot: some thousand texels for each place
    void
    horizonSums(const Tables& tables, const SpherePoint* places, size_t count, double yaw, glm::dvec4* sums)
{
    for (size_t i = 0; i < count; ++i)
        sums[i] = sumAt(tables, places[i].azimuth + yaw, places[i].colatitude);
}

HorizonSum::HorizonSum(const EnvironmentMap& latlong, std::span<const BrightTexels::Change> changes, const HorizonSplit& split,
                       const JobControl& job)
{
    Tables& t = m_tables;
    t.planes = FloatPlanes(latlong, changes, job);
    for (int x = 0; x < t.planes.width + lanes; ++x) {
        const double azimuth = 2.0 * pi * (x + 0.5) / t.planes.width;
        t.cosine.push_back(std::cos(azimuth));
        t.sine.push_back(std::sin(azimuth));
    }
    for (int y = 0; y < t.planes.height; ++y) {
        const double colatitude = pi * (y + 0.5) / t.planes.height;
        t.rowCosine.push_back(std::cos(colatitude));
        t.rowSine.push_back(std::sin(colatitude));
    }
    t.exponent = split.lobe().exponent;
    t.width = split.width();
    t.factor = (t.exponent + 1.0) / (2.0 * pi) * std::pow(t.width, t.exponent);
}

void HorizonSum::at(std::span<const SpherePoint> places, double yaw, glm::dvec4* sums) const
{
    horizonSums(m_tables, places.data(), places.size(), yaw, sums);
}

double HorizonSum::texels(double width, int latlongWidth)
{
    // width/2 of the sphere; rows near the poles are denser, and are met as often
    return 0.5 * width * latlongWidth * (latlongWidth / 2.0) * (pi / 2);
}

} // namespace mirrorball
