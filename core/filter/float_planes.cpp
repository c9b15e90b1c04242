#include "float_planes.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

FloatPlanes::FloatPlanes(const EnvironmentMap& latlong, std::span<const BrightTexels::Change> changes, const JobControl& job)
    : width(latlong.image.width), height(latlong.image.height), stride(latlong.image.width + floatLanes)
{
    const Image& image = latlong.image;
    float peak = 0.0f;
    for (const float value : image.texels)
        peak = std::max(peak, std::abs(value));
    scale = peak > 0.0f ? std::exp2(-static_cast<double>(std::ilogb(peak))) : 1.0;
    for (auto& plane : channels)
        plane.resize(static_cast<size_t>(stride) * static_cast<size_t>(height));
    parallelRows(height, {.stop = job.stop, .progress = {}, .threads = job.threads}, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const float* from = image.row(y);
            const std::ptrdiff_t start = y * stride;
            float *red = channels[0].data() + start, *green = channels[1].data() + start, *blue = channels[2].data() + start;
            const double s = scale;
            for (int x = 0; x < width; ++x, from += 3) {
                red[x] = static_cast<float>(s * from[0]);
                green[x] = static_cast<float>(s * from[1]);
                blue[x] = static_cast<float>(s * from[2]);
            }
        }
    });
    for (const BrightTexels::Change& change : changes)
        for (int c = 0; c < 3; ++c)
            channels[c][static_cast<size_t>(change.y * stride + change.x)] = static_cast<float>(scale * change.calm[c]);
    for (int y = 0; y < height; ++y)
        solidAngles.push_back(4.0 * pi / width * std::sin(pi * (y + 0.5) / height) * std::sin(0.5 * pi / height));
}

} // namespace mirrorball
