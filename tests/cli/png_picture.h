#pragma once

#include <gtest/gtest.h>

#include <png.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace mirrorball::test {

/// A PNG as any program reads it: red, green, blue, opacity in bytes, colors not multiplied.
struct PngPicture {
    int width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels{};

    explicit PngPicture(const std::filesystem::path& path)
    {
        png_image file{};
        file.version = PNG_IMAGE_VERSION;
        EXPECT_TRUE(png_image_begin_read_from_file(&file, path.c_str())) << path;
        file.format = PNG_FORMAT_RGBA;
        width = static_cast<int>(file.width);
        height = static_cast<int>(file.height);
        pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
        EXPECT_TRUE(png_image_finish_read(&file, nullptr, pixels.data(), 0, nullptr)) << path;
    }
    const std::array<std::uint8_t, 4>& at(int x, int y) const
    {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

} // namespace mirrorball::test
