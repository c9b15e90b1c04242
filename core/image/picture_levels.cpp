#include "picture_levels.h"

#include <algorithm>

namespace mirrorball {

Image boxHalved(const Image& image, const JobControl& job)
{
    Image half(std::max(1, image.width / 2), std::max(1, image.height / 2), image.channels);
    const double scaleX = static_cast<double>(image.width) / half.width;
    const double scaleY = static_cast<double>(image.height) / half.height;
    const auto average = [&](int x, int y, int c) {
        double sum = 0.0;
        for (int sy = static_cast<int>(y * scaleY); sy < image.height && sy < (y + 1) * scaleY; ++sy)
            for (int sx = static_cast<int>(x * scaleX); sx < image.width && sx < (x + 1) * scaleX; ++sx) {
                const double coverY = std::min(sy + 1.0, (y + 1) * scaleY) - std::max<double>(sy, y * scaleY);
                const double coverX = std::min(sx + 1.0, (x + 1) * scaleX) - std::max<double>(sx, x * scaleX);
                sum += coverX * coverY * image.texel(sx, sy)[c];
            }
        return static_cast<float>(sum / (scaleX * scaleY));
    };
    parallelRows(half.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < half.width; ++x)
                for (int c = 0; c < image.channels; ++c)
                    half.texel(x, y)[c] = average(x, y, c);
    });
    return half;
}

std::vector<Image> pictureLevels(Image picture, const JobControl& job)
{
    std::vector<Image> levels;
    levels.push_back(std::move(picture));
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(boxHalved(levels.back(), job));
    return levels;
}

} // namespace mirrorball
