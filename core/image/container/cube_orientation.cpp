#include "cube_orientation.h"

#include "core/sphere/cube_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorball {

namespace {

enum class Way { ToStored, FromStored };

/// A texel of our cube, as whole numbers.
struct Place {
    int x = 0, y = 0; ///< y counts through the stacked faces
};

/// Where the texel of the stored cube comes from. Centers of texels go to centers, which are half a texel from where rounding could hurt.
Place source(int n, const CubeOrientation& orientation, int face, int x, int y)
{
    const double s = (2.0 * x + 1.0) / n - 1.0, t = (2.0 * y + 1.0) / n - 1.0;
    const glm::dvec3 e = cube_map::facePoint(face, s, orientation.bottomUp ? -t : t);
    const glm::dvec2 p = cube_map::coordinate(n, orientation.axes * e);
    return {static_cast<int>(p.x), static_cast<int>(p.y)};
}

Image moved(const Image& image, const CubeOrientation& orientation, Way way)
{
    assert(image.height == 6 * image.width && image.channels == 3);
    const int n = image.width;
    Image result(n, 6 * n, 3);
    for (int face = 0; face < 6; ++face) {
        // Three corners tell the rest: a face goes to a face, turned or mirrored.
        const Place origin = source(n, orientation, face, 0, 0);
        const Place right = source(n, orientation, face, n - 1, 0), down = source(n, orientation, face, 0, n - 1);
        const int steps = std::max(1, n - 1);
        const Place alongX{(right.x - origin.x) / steps, (right.y - origin.y) / steps};
        const Place alongY{(down.x - origin.x) / steps, (down.y - origin.y) / steps};
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const Place ours{origin.x + x * alongX.x + y * alongY.x, origin.y + x * alongX.y + y * alongY.y};
                const int row = face * n + y;
                if (way == Way::ToStored)
                    std::copy_n(image.texel(ours.x, ours.y), 3, result.texel(x, row));
                else
                    std::copy_n(image.texel(x, row), 3, result.texel(ours.x, ours.y));
            }
    }
    return result;
}

} // namespace

Image toStored(const Image& ours, const CubeOrientation& orientation) { return moved(ours, orientation, Way::ToStored); }

Image fromStored(const Image& stored, const CubeOrientation& orientation) { return moved(stored, orientation, Way::FromStored); }

} // namespace mirrorball
