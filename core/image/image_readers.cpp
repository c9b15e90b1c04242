#include "image_readers.h"

#include "color_space.h"
#include "input_checks.h"
#include "ocio_space.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

namespace mirrorball {

namespace {

/// What the stored rows are to the upright picture, by Exif's numbers.
constexpr std::array<const char*, 9> orientationTexts{"",
                                                      "upright",
                                                      "mirrored left to right, which is undone",
                                                      "upside down, turned by 180 degrees",
                                                      "mirrored top to bottom, which is undone",
                                                      "transposed, which is undone",
                                                      "on its side, turned by 90 degrees clockwise",
                                                      "transposed and turned, which is undone",
                                                      "on its side, turned by 90 degrees counterclockwise"};

class UprightReader final : public ImageReader {
public:
    UprightReader(std::unique_ptr<ImageReader> stored, Channels channels)
        : m_stored(std::move(stored)), m_info(m_stored->info()), m_floats(static_cast<size_t>(texelFloats(channels)))
    {
        if (m_info.orientation >= 5)
            std::swap(m_info.width, m_info.height);
        assume(m_info.assumed, {"orientation", orientationTexts[static_cast<size_t>(m_info.orientation)], "the file's orientation tag"});
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        const auto width = static_cast<size_t>(m_info.width), count = static_cast<size_t>(rows);
        if (m_info.orientation == 2) {
            m_stored->readRows(firstRow, rows, texels);
            for (size_t y = 0; y < count; ++y)
                for (size_t x = 0; x < width / 2; ++x)
                    std::swap_ranges(texels + (y * width + x) * m_floats, texels + (y * width + x + 1) * m_floats,
                                     texels + (y * width + width - 1 - x) * m_floats);
            return;
        }
        if (m_held.empty())
            hold();
        for (size_t y = 0; y < count; ++y)
            for (size_t x = 0; x < width; ++x)
                std::copy_n(m_held.data() + storedIndex(x, static_cast<size_t>(firstRow) + y) * m_floats, m_floats,
                            texels + (y * width + x) * m_floats);
    }

private:
    void hold()
    {
        const ImageFileInfo& stored = m_stored->info();
        const size_t rowFloats = static_cast<size_t>(stored.width) * m_floats;
        constexpr int block = 64;
        for (int y = 0; y < stored.height; y += block) {
            const int rows = std::min(block, stored.height - y);
            m_held.resize(rowFloats * static_cast<size_t>(y + rows));
            m_stored->readRows(y, rows, m_held.data() + rowFloats * static_cast<size_t>(y));
        }
    }

    /// Where the texel of the upright picture stands in the file.
    size_t storedIndex(size_t x, size_t y) const
    {
        const auto w = static_cast<size_t>(m_info.width), h = static_cast<size_t>(m_info.height);
        switch (m_info.orientation) {
        case 3:
            return (h - 1 - y) * w + (w - 1 - x);
        case 4:
            return (h - 1 - y) * w + x;
        case 5:
            return x * h + y;
        case 6:
            return (w - 1 - x) * h + y;
        case 7:
            return (w - 1 - x) * h + (h - 1 - y);
        case 8:
            return x * h + (h - 1 - y);
        default:
            return y * w + x;
        }
    }

    std::unique_ptr<ImageReader> m_stored;
    ImageFileInfo m_info;
    size_t m_floats;
    std::vector<float> m_held{};
};

class ColorSpaceReader final : public ImageReader {
public:
    ColorSpaceReader(std::unique_ptr<ImageReader> stored, const std::string& name, Channels channels)
        : m_stored(std::move(stored)), m_info(m_stored->info()), m_floats(static_cast<size_t>(texelFloats(channels)))
    {
        if (const auto space = colorSpaceFromName(name)) {
            m_toLinear = [curve = *space, matrix = primariesToRec709(*space)](float* rgb) {
                glm::vec3 color(toLight(rgb[0], curve), toLight(rgb[1], curve), toLight(rgb[2], curve));
                if (matrix)
                    color = *matrix * color;
                std::copy_n(&color.x, 3, rgb);
            };
        } else {
            m_toLinear = ocioSpace(name);
        }
        assume(m_info.assumed, {"encoding", name, "asked for"});
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        m_stored->readRows(firstRow, rows, texels);
        const size_t count = static_cast<size_t>(m_info.width) * static_cast<size_t>(rows);
        for (size_t i = 0; i < count; ++i, texels += m_floats) {
            const float alpha = m_floats == 4 ? texels[3] : 1.0f;
            if (alpha <= 0.0f)
                continue;
            for (int c = 0; alpha != 1.0f && c < 3; ++c)
                texels[c] /= alpha;
            m_toLinear(texels);
            for (int c = 0; alpha != 1.0f && c < 3; ++c)
                texels[c] *= alpha;
        }
    }

private:
    std::unique_ptr<ImageReader> m_stored;
    ImageFileInfo m_info;
    size_t m_floats;
    std::function<void(float*)> m_toLinear{};
};

class OpaqueReader final : public ImageReader {
public:
    explicit OpaqueReader(std::unique_ptr<ImageReader> colors) : m_colors(std::move(colors)) {}
    const ImageFileInfo& info() const override { return m_colors->info(); }

    void readRows(int firstRow, int rows, float* texels) override
    {
        const size_t count = static_cast<size_t>(info().width) * static_cast<size_t>(rows);
        m_rgb.resize(3 * count);
        m_colors->readRows(firstRow, rows, m_rgb.data());
        for (size_t i = 0; i < count; ++i) {
            std::copy_n(m_rgb.data() + 3 * i, 3, texels + 4 * i);
            texels[4 * i + 3] = 1.0f;
        }
    }

private:
    std::unique_ptr<ImageReader> m_colors;
    std::vector<float> m_rgb{};
};

} // namespace

std::unique_ptr<ImageReader> upright(std::unique_ptr<ImageReader> reader, Channels channels)
{
    if (reader->info().orientation == 1)
        return reader;
    return std::make_unique<UprightReader>(std::move(reader), channels);
}

std::unique_ptr<ImageReader> inColorSpace(std::unique_ptr<ImageReader> reader, const std::string& space, Channels channels)
{
    return std::make_unique<ColorSpaceReader>(std::move(reader), space, channels);
}

int partNumber(const std::filesystem::path& path, const ProbeReading& reading)
{
    const std::string& part = reading.part;
    const bool isNumber = part.size() < 7 && std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c); });
    if (!isNumber)
        throw FileError(path.string(), "its format names no parts; give a number, from 0, instead of '" + oneLine(part) + "'");
    return part.empty() ? 0 : std::stoi(part);
}

void checkNoLayer(const std::filesystem::path& path, const ProbeReading& reading)
{
    if (!reading.layer.empty() && reading.layer != "default")
        throw FileError(path.string(), "its format has no layers; leave --layer out");
}

std::unique_ptr<ImageReader> withOpacity(std::unique_ptr<ImageReader> reader, Channels channels)
{
    if (channels == Channels::Color)
        return reader;
    return std::make_unique<OpaqueReader>(std::move(reader));
}

} // namespace mirrorball
