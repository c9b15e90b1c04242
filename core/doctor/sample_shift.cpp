#include "sample_shift.h"

#include "core/image/color.h"

#include <array>
#include <cmath>
#include <vector>

namespace mirrorball {

namespace {

constexpr size_t unknowns = 5;
using Row = std::array<double, unknowns>;

/// Solves A x = b of a symmetric positive matrix by elimination; false where it is singular.
bool solve(std::array<Row, unknowns>& a, Row& b)
{
    for (size_t i = 0; i < unknowns; ++i) {
        if (!(a[i][i] > 0.0))
            return false;
        for (size_t j = i + 1; j < unknowns; ++j) {
            const double factor = a[j][i] / a[i][i];
            for (size_t k = i; k < unknowns; ++k)
                a[j][k] -= factor * a[i][k];
            b[j] -= factor * b[i];
        }
    }
    for (size_t i = unknowns; i-- > 0;) {
        for (size_t k = i + 1; k < unknowns; ++k)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    return true;
}

} // namespace

SampleShift sampleShift(const Image& map, const Image& truth, int pictures)
{
    SampleShift shift;
    const int width = truth.width, height = truth.height / pictures;
    if (width < 8 || height < 8)
        return shift;
    const auto at = [&](const Image& image, int x, int y) {
        const float* t = image.texel(x, y);
        return luminance({t[0], t[1], t[2]});
    };
    double mean = 0.0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < width; ++x)
            mean += at(truth, x, y);
    mean /= static_cast<double>(width) * truth.height;
    if (!(mean > 0.0))
        return shift;

    std::array<Row, unknowns> normal{};
    Row right{};
    double variation = 0.0;
    for (int picture = 0; picture < pictures; ++picture)
        for (int row = 1; row + 1 < height; ++row)
            for (int x = 1; x + 1 < width; ++x) {
                const int y = picture * height + row;
                const double t = at(truth, x, y), l = at(truth, x - 1, y), r = at(truth, x + 1, y), u = at(truth, x, y - 1),
                             d = at(truth, x, y + 1);
                const double dx = 0.5 * (r - l), dy = 0.5 * (d - u);
                const double px = (2.0 * x + 1.0) / width - 1.0, py = (2.0 * row + 1.0) / height - 1.0;
                const double weight = 1.0 / ((t + 0.1 * mean) * (t + 0.1 * mean) + dx * dx + dy * dy);
                const Row columns{-dx, -dy, -(px * dx + py * dy), l + r + u + d - 4.0 * t, t};
                const double difference = at(map, x, y) - t;
                for (size_t i = 0; i < unknowns; ++i) {
                    right[i] += weight * columns[i] * difference;
                    for (size_t j = 0; j < unknowns; ++j)
                        normal[i][j] += weight * columns[i] * columns[j];
                }
                variation += weight * (dx * dx + dy * dy);
            }
    if (variation < 1e-8 * width * truth.height || !solve(normal, right))
        return shift;
    return {.right = right[0], .down = right[1], .spread = right[2], .known = true};
}

} // namespace mirrorball
