#include "latlong_positions.h"

#include "core/base/multiversion.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// Four numbers side by side.
typedef double Lanes __attribute__((vector_size(32), aligned(8), may_alias));
typedef int Wholes __attribute__((vector_size(16)));

/// atan2 of four at once, as precise as the library's to 2e-16.
/// Source of the rational function: S. Moshier, Cephes, atan.c.
[[gnu::always_inline]] inline void atan2Of(const Lanes& y, const Lanes& x, Lanes& angle)
{
    const Lanes none{};
    const Lanes ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y;
    const Lanes low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
    const auto large = low > 0.66 * high;
    const Lanes over = large ? low - high : low, sum = large ? low + high : high, under = sum > 0.0 ? sum : none + 1.0;
    const Lanes t = over / under, u = t * t;
    const Lanes p =
        ((((-8.750608600031904122785e-1 * u - 1.615753718733365076637e1) * u - 7.500855792314704667340e1) * u - 1.228866684490136173410e2) *
             u -
         6.485021904942025371773e1);
    const Lanes q = (((((u + 2.485846490142306297962e1) * u + 1.650270098316988542046e2) * u + 4.328810604912902668951e2) * u +
                      4.853903996359136964868e2) *
                         u +
                     1.945506571482613964425e2);
    angle = t + t * u * (p / q) + (large ? none + 0.25 * pi : none);
    angle = ax < ay ? 0.5 * pi - angle : angle;
    angle = x < 0.0 ? pi - angle : angle;
    angle = y < 0.0 ? -angle : angle;
}

/// Positions of four directions; `middle` only where inside a row the share counts.
template <bool share>
[[gnu::always_inline]] inline void fourPositions(int n, double middle, const double* x, const double* y, const double* z, double* px,
                                                 double* py)
{
    const double scale = n / pi, whole = 2.0 * n;
    const Lanes dx = *reinterpret_cast<const Lanes*>(x), dy = *reinterpret_cast<const Lanes*>(y), dz = *reinterpret_cast<const Lanes*>(z);
    Lanes longitude, latitude, sine;
    atan2Of(dx, dz, longitude);
    const Lanes square = dx * dx + dz * dz;
    for (int i = 0; i < 4; ++i)
        sine[i] = std::sqrt(square[i]);
    atan2Of(dy, sine, latitude);
    Lanes column = (pi - longitude) * scale, row = (0.5 * pi - latitude) * scale;
    if constexpr (share) {
        column = column - middle > n ? column - whole : column;
        column = column - middle < -n ? column + whole : column;
        const Lanes part = row - __builtin_convertvector(__builtin_convertvector(row, Wholes), Lanes);
        row -= part * (1.0 - part) * 0.5 * dy / (sine * scale);
    }
    *reinterpret_cast<Lanes*>(px) = column;
    *reinterpret_cast<Lanes*>(py) = row;
}

template <bool share>
[[gnu::always_inline]] inline void positions(int n, double middle, size_t count, const double* x, const double* y, const double* z,
                                             double* px, double* py)
{
    size_t i = 0;
    for (; i + 4 <= count; i += 4)
        fourPositions<share>(n, middle, x + i, y + i, z + i, px + i, py + i);
    if (i == count)
        return;
    double d[3][4], p[2][4]; // the last few, filled up by the last one
    for (size_t k = 0; k < 4; ++k) {
        const size_t from = std::min(i + k, count - 1);
        d[0][k] = x[from];
        d[1][k] = y[from];
        d[2][k] = z[from];
    }
    fourPositions<share>(n, middle, d[0], d[1], d[2], p[0], p[1]);
    std::copy_n(p[0], count - i, px + i);
    std::copy_n(p[1], count - i, py + i);
}

} // namespace

MIRRORBALL_CLONES
void latlongCoordinates(int n, size_t count, const double* x, const double* y, const double* z, double* px, double* py)
{
    positions<false>(n, 0.0, count, x, y, z, px, py);
}

MIRRORBALL_CLONES
void latlongSharePositions(int n, double middle, size_t count, const double* x, const double* y, const double* z, double* px, double* py)
{
    positions<true>(n, middle, count, x, y, z, px, py);
}

} // namespace mirrorball
