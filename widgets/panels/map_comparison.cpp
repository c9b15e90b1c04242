#include "map_comparison.h"

#include "core/image/map_picture.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

MapLayout equalTexels(Parameterization kind, const MapLayout& other)
{
    const MapLayout unit{kind, 1, 0};
    const double texels = static_cast<double>(other.width()) * other.height() / (static_cast<double>(unit.width()) * unit.height());
    return {kind, std::max(1, static_cast<int>(std::lround(std::sqrt(texels)))), 0};
}

MapComparison compareLayouts(const std::shared_ptr<const EnvironmentMap>& map, const MapLayout& a, const MapLayout& b,
                             const JobControl& job)
{
    MapComparison c;
    const auto resampled = [&](const MapLayout& to) {
        return map->layout == to ? map : std::make_shared<const EnvironmentMap>(reproject(*map, {.target = to}, job));
    };
    c.a = resampled(a);
    c.b = resampled(b);
    c.difference = std::make_shared<const EnvironmentMap>(difference(*c.a, *c.b, job));
    EnvironmentMap looked = *c.a;
    for (size_t i = 0; i < looked.image.texels.size(); ++i)
        looked.image.texels[i] -= c.difference->image.texels[i];
    c.error = errorMetrics(looked, *c.a);
    c.range = signedRange(*c.difference);
    return c;
}

} // namespace mirrorball::studio
