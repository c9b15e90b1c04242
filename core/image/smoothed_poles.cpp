#include "smoothed_poles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirrorball {

namespace {

/// A row turned into its circular running mean of a real width: whole texels, and a part of the two at the ends.
void blurRow(float* row, int texels, double width)
{
    const double reach = 0.5 * (std::min(width, static_cast<double>(texels)) - 1.0);
    const int whole = static_cast<int>(std::floor(reach));
    const double part = reach - whole;
    const double scale = 1.0 / (1.0 + 2.0 * reach);
    for (int c = 0; c < 3; ++c) {
        // prefix[i] = sum of the first i texels of the row repeated three times around
        std::vector<double> prefix(static_cast<size_t>(3 * texels) + 1, 0.0);
        for (int i = 0; i < 3 * texels; ++i)
            prefix[static_cast<size_t>(i) + 1] = prefix[static_cast<size_t>(i)] + row[3 * (i % texels) + c];
        const auto value = [&](int i) { return prefix[static_cast<size_t>(i) + 1] - prefix[static_cast<size_t>(i)]; };
        for (int x = 0; x < texels; ++x) {
            const int at = texels + x;
            const double sum = prefix[static_cast<size_t>(at + whole + 1)] - prefix[static_cast<size_t>(at - whole)] +
                               part * (value(at - whole - 1) + value(at + whole + 1));
            row[3 * x + c] = static_cast<float>(sum * scale);
        }
    }
}

} // namespace

EnvironmentMap smoothedPoles(EnvironmentMap map)
{
    if (map.layout.kind != Parameterization::Latlong)
        return map;
    const int n = map.layout.size, width = 2 * n;
    for (int y = 0; y < n; ++y) {
        const double texels = 1.0 / std::sin(pi / n * (y + 0.5));
        if (y == 0 || y == n - 1)
            blurRow(map.image.row(y), width, width); // around a pole itself nothing may depend on the longitude
        else if (texels > 1.0 + 1e-3)
            for (int pass = 0; pass < 3; ++pass) // three times: as smooth as a quadratic spline
                blurRow(map.image.row(y), width, texels);
    }
    return map;
}

} // namespace mirrorball
