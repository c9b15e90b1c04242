#include "core/image/picture_levels.h"

#include <gtest/gtest.h>

#include <random>

namespace mirrorball {
namespace {

Image noise(int width, int height, int channels)
{
    Image image(width, height, channels);
    std::mt19937 random(5);
    for (float& value : image.texels)
        value = std::uniform_real_distribution<float>()(random);
    return image;
}

double mean(const Image& image, int channel)
{
    double sum = 0.0;
    for (size_t i = static_cast<size_t>(channel); i < image.texels.size(); i += static_cast<size_t>(image.channels))
        sum += static_cast<double>(image.texels[i]);
    return sum / image.width / image.height;
}

// OpenGL 4.5, section 8.14.3: max(1, floor(size / 2^i)) each way.
TEST(PictureLevels, HalveEachWayRoundedDownToOneTexel)
{
    const std::vector<Image> levels = pictureLevels(noise(13, 5, 3));
    const int sizes[][2] = {{13, 5}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(levels.size(), std::size(sizes));
    for (size_t i = 0; i < levels.size(); ++i) {
        EXPECT_EQ(levels[i].width, sizes[i][0]);
        EXPECT_EQ(levels[i].height, sizes[i][1]);
    }
}

// Every texel counts by its area alone, also where an odd size cuts some.
TEST(PictureLevels, KeepTheMean)
{
    for (const auto& [width, height] : {std::pair(16, 8), std::pair(17, 9), std::pair(1, 7), std::pair(31, 2)}) {
        const std::vector<Image> levels = pictureLevels(noise(width, height, 3));
        for (const Image& level : levels)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(mean(level, c), mean(levels.front(), c), 1e-6) << width << " x " << height << ", " << level.width;
    }
}

TEST(PictureLevels, OfWhiteAreWhite)
{
    for (const Image& level : pictureLevels(Image(13, 7, 1, 1.0f)))
        for (const float value : level.texels)
            EXPECT_EQ(value, 1.0f);
}

} // namespace
} // namespace mirrorball
