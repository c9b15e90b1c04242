#include "resized_rows.h"

#include "core/base/error.h"

#include <cmath>

namespace mirrorball {

namespace {

/// The two texels around a position along an axis of so many, in its texels, and the share of the second. The first may be -1, the second
/// `count`: beyond an edge.
struct Between {
    int first;
    float share;
};
Between between(int texel, int texels, int count)
{
    const double at = (texel + 0.5) * count / texels - 0.5, floor = std::floor(at);
    return {static_cast<int>(floor), static_cast<float>(at - floor)};
}

} // namespace

std::vector<float> resizedRows(const EnvironmentMap& probe, int width, int firstRow, int rows, const JobControl& job)
{
    if (probe.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("probe: must be a latlong map; reproject it first");
    const int columns = probe.image.width, lines = probe.image.height;
    std::vector<Between> across;
    for (int x = 0; x < width; ++x)
        across.push_back(between(x, width, columns));
    std::vector<float> rgb(static_cast<size_t>(rows) * static_cast<size_t>(width) * 3);
    parallelRows(
        rows, {.stop = job.stop, .threads = job.threads},
        [&](int first, int last) {
            std::vector<float> line(3 * static_cast<size_t>(columns + 2)); // a column on either side of it
            for (int y = first; y < last; ++y) {
                const Between down = between(firstRow + y, width / 2, lines);
                // Over a pole a row goes on on the other side of it.
                const auto texel = [&](int row, int x) {
                    const bool beyond = row < 0 || row >= lines;
                    const int turned = beyond ? x + columns / 2 : x;
                    return probe.image.texel((turned + 2 * columns) % columns, beyond ? (row < 0 ? 0 : lines - 1) : row);
                };
                for (int x = -1; x <= columns; ++x)
                    for (int c = 0; c < 3; ++c)
                        line[static_cast<size_t>(3 * (x + 1) + c)] =
                            (1.0f - down.share) * texel(down.first, x)[c] + down.share * texel(down.first + 1, x)[c];
                float* out = &rgb[static_cast<size_t>(y) * static_cast<size_t>(width) * 3];
                for (const Between& at : across)
                    for (int c = 0; c < 3; ++c) {
                        const float* left = &line[static_cast<size_t>(3 * (at.first + 1) + c)];
                        *out++ = (1.0f - at.share) * left[0] + at.share * left[3];
                    }
            }
        },
        1);
    return rgb;
}

} // namespace mirrorball
