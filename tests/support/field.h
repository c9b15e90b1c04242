#pragma once

#include "core/image/environment_map.h"

#include <algorithm>

/// A probe that is known in every direction, so that any reading of any file of it can be checked texel by texel.
namespace mirrorball::test {

/// radiance(d) = 0.5 + 0.4 d, with red, green, blue for x, y, z.
inline glm::dvec3 fieldAt(const glm::dvec3& d) { return 0.5 + 0.4 * d; }

inline EnvironmentMap fieldMap(const MapLayout& layout)
{
    EnvironmentMap map(layout);
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x) {
            const glm::vec3 value(fieldAt(texelDirection(layout, x, y)));
            std::copy_n(&value.x, 3, map.image.texel(x, y));
        }
    return map;
}

/// A latlong that need not be 2:1, spanning these angles about +Z.
inline Image fieldPicture(int width, int height, double horizontalDeg = 360.0, double verticalDeg = 180.0)
{
    Image picture(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double lon = (0.5 - (x + 0.5) / width) * horizontalDeg * pi / 180.0;
            const double lat = (0.5 - (y + 0.5) / height) * verticalDeg * pi / 180.0;
            const glm::vec3 value(fieldAt(directionFromLonLat(lon, lat)));
            std::copy_n(&value.x, 3, picture.texel(x, y));
        }
    return picture;
}

/// The largest difference of any value from the field.
inline double distanceFromField(const EnvironmentMap& map)
{
    double largest = 0.0;
    for (int y = 0; y < map.image.height; ++y)
        for (int x = 0; x < map.image.width; ++x)
            if (isInside(map.layout, x, y))
                for (int c = 0; c < 3; ++c)
                    largest = std::max(largest, std::abs(map.image.texel(x, y)[c] - fieldAt(texelDirection(map.layout, x, y))[c]));
    return largest;
}

} // namespace mirrorball::test
