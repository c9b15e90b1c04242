#include "bright_sum.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <array>
#include <cmath>

// This file is compiled with the relaxed floating-point rules that let the compiler add in any order and call vectorised exp and log (see
// CMakeLists.txt): results stay within a few units in the last place of a double. Nothing here may produce or test for infinities or NaN.
namespace mirrorball {

namespace {

/// ln of the smallest ratio to the peak that still counts: beyond it exp() leaves the range of normal doubles.
constexpr double smallestLog = -700.0;

/// Texels whose weights are held at once.
constexpr size_t block = 64;

MIRRORBALL_CLONES void cosines(const BrightPlanes& p, size_t first, size_t count, double rx, double ry, double rz, double* c)
{
    for (size_t i = 0; i < count; ++i)
        c[i] = std::min(1.0, rx * p.x[first + i] + ry * p.y[first + i] + rz * p.z[first + i]);
}

MIRRORBALL_CLONES void phongWeights(double exponent, size_t count, double* c)
{
    for (size_t i = 0; i < count; ++i) {
        const double log = exponent * std::log(std::max(c[i], 1e-300));
        const double k = std::exp(std::max(log, smallestLog));
        c[i] = c[i] > 0.0 && log > smallestLog ? k : 0.0;
    }
}

/// Small whole exponents, by products.
MIRRORBALL_CLONES void wholePhongWeights(int exponent, size_t count, double* c)
{
    std::array<double, block> x;
    for (size_t i = 0; i < count; ++i)
        x[i] = c[i] = std::max(c[i], 0.0);
    for (int power = 1; power < exponent; ++power)
        for (size_t i = 0; i < count; ++i)
            c[i] *= x[i];
}

MIRRORBALL_CLONES void ggxWeights(double alpha, size_t count, double* c)
{
    const double a2 = alpha * alpha;
    for (size_t i = 0; i < count; ++i) {
        const double x = std::max(c[i], 0.0), ratio = a2 / (0.5 * (1.0 - x) + a2 * 0.5 * (1.0 + x));
        c[i] = x * ratio * ratio;
    }
}

struct Rgb {
    double red, green, blue;
};

MIRRORBALL_CLONES Rgb weighted(const BrightPlanes& p, size_t first, size_t count, const double* weights)
{
    double red = 0.0, green = 0.0, blue = 0.0;
    for (size_t i = 0; i < count; ++i) {
        red += weights[i] * p.red[first + i];
        green += weights[i] * p.green[first + i];
        blue += weights[i] * p.blue[first + i];
    }
    return {red, green, blue};
}

} // namespace

bool hasQuickPowers(const Lobe& lobe)
{
    return lobe.kind == LobeKind::Phong && lobe.exponent >= 1.0 && lobe.exponent <= 8.0 && lobe.exponent == std::floor(lobe.exponent);
}

glm::dvec3 brightSum(const BrightPlanes& planes, size_t first, size_t last, const Lobe& lobe, const LobeShape& shape, const glm::dvec3& r)
{
    std::array<double, block> c;
    glm::dvec3 sum(0.0);
    for (size_t from = first; from < last; from += block) {
        const size_t count = std::min(block, last - from);
        cosines(planes, from, count, r.x, r.y, r.z, c.data());
        switch (lobe.kind) {
        case LobeKind::Diffuse:
            for (size_t i = 0; i < count; ++i)
                c[i] = std::max(c[i], 0.0);
            break;
        case LobeKind::Ggx:
            ggxWeights(lobe.alpha, count, c.data());
            break;
        case LobeKind::Phong:
            if (hasQuickPowers(lobe))
                wholePhongWeights(static_cast<int>(lobe.exponent), count, c.data());
            else
                phongWeights(lobe.exponent, count, c.data());
            break;
        case LobeKind::Tabulated:
            for (size_t i = 0; i < count; ++i)
                c[i] = shape.relative(c[i]);
            break;
        }
        const Rgb part = weighted(planes, from, count, c.data());
        sum += glm::dvec3(part.red, part.green, part.blue);
    }
    return sum;
}

} // namespace mirrorball
