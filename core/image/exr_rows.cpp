#include "exr_rows.h"

#include "core/base/error.h"

#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfRgbaFile.h>
#include <ImfTiledInputPart.h>

#include <algorithm>
#include <string>
#include <vector>

namespace mirrorball::exr {
namespace {

using Imath::Box2i;
using Imath::V2i;

int widthOf(const Box2i& window) { return window.max.x - window.min.x + 1; }

/// Interleaved floats whose first texel stands at `origin` of the file's coordinates. Channels that are not there are filled.
Imf::FrameBuffer frameBuffer(const ColorChannels& channels, int floats, float* texels, const V2i& origin, int width, int rows)
{
    Imf::FrameBuffer buffer;
    const size_t texel = static_cast<size_t>(floats) * sizeof(float);
    const auto add = [&](const std::string& name, int at, double fill) {
        Imf::Slice slice = Imf::Slice::Make(Imf::FLOAT, texels + at, origin, width, rows, texel, texel * static_cast<size_t>(width));
        slice.fillValue = fill;
        buffer.insert(name.empty() ? "mirrorball:absent" + std::to_string(at) : name, slice);
    };
    for (int c = 0; c < (channels.isGray() ? 1 : 3); ++c)
        add(channels.rgb[static_cast<size_t>(c)], c, 0.0);
    if (floats == 4)
        add(channels.alpha, 3, 1.0);
    return buffer;
}

void copyGray(const ColorChannels& channels, int floats, float* texels, size_t count)
{
    if (channels.isGray())
        for (size_t i = 0; i < count; ++i, texels += floats)
            texels[1] = texels[2] = texels[0];
}

class ScanlineRows final : public RowSource {
public:
    ScanlineRows(Imf::MultiPartInputFile& file, const Picture& picture, int floats)
        : m_part(file, picture.part), m_channels(picture.channels), m_floats(floats)
    {
    }

    Box2i window() const override { return m_part.header().dataWindow(); }

    void read(int firstRow, int rows, float* texels) override
    {
        const Box2i all = window();
        const int top = all.min.y + firstRow;
        m_part.setFrameBuffer(frameBuffer(m_channels, m_floats, texels, {all.min.x, top}, widthOf(all), rows));
        m_part.readPixels(top, top + rows - 1);
        copyGray(m_channels, m_floats, texels, static_cast<size_t>(widthOf(all)) * static_cast<size_t>(rows));
    }

private:
    Imf::InputPart m_part;
    ColorChannels m_channels;
    int m_floats;
};

/// Holds one row of tiles.
class TiledRows final : public RowSource {
public:
    TiledRows(Imf::MultiPartInputFile& file, const Picture& picture, int floats, int level)
        : m_part(file, picture.part), m_channels(picture.channels), m_floats(floats), m_level(level),
          m_window(m_part.dataWindowForLevel(level, level))
    {
    }

    Box2i window() const override { return m_window; }

    void read(int firstRow, int rows, float* texels) override
    {
        const int tileRows = static_cast<int>(m_part.tileYSize());
        const size_t rowFloats = static_cast<size_t>(m_floats) * static_cast<size_t>(widthOf(m_window));
        for (int y = firstRow; y < firstRow + rows; ++y, texels += rowFloats) {
            if (y / tileRows != m_heldTileRow)
                readTileRow(y / tileRows);
            std::copy_n(m_held.data() + static_cast<size_t>(y % tileRows) * rowFloats, rowFloats, texels);
        }
    }

private:
    void readTileRow(int tileRow)
    {
        const int width = widthOf(m_window);
        const int top = m_window.min.y + tileRow * static_cast<int>(m_part.tileYSize());
        const int rows = std::min(static_cast<int>(m_part.tileYSize()), m_window.max.y - top + 1);
        const size_t texels = static_cast<size_t>(width) * static_cast<size_t>(rows);
        m_heldTileRow = -1;
        m_held.resize(static_cast<size_t>(m_floats) * texels);
        m_part.setFrameBuffer(frameBuffer(m_channels, m_floats, m_held.data(), {m_window.min.x, top}, width, rows));
        m_part.readTiles(0, m_part.numXTiles(m_level) - 1, tileRow, tileRow, m_level, m_level);
        copyGray(m_channels, m_floats, m_held.data(), texels);
        m_heldTileRow = tileRow;
    }

    Imf::TiledInputPart m_part;
    ColorChannels m_channels;
    int m_floats;
    int m_level;
    Box2i m_window;
    int m_heldTileRow = -1;
    std::vector<float> m_held{};
};

/// Luminance with subsampled chroma, which OpenEXR's Rgba interface filters back to RGB in half precision.
class LuminanceChromaRows final : public RowSource {
public:
    LuminanceChromaRows(FileStream& stream, int floats) : m_file(stream), m_floats(floats) {}

    Box2i window() const override { return m_file.dataWindow(); }

    void read(int firstRow, int rows, float* texels) override
    {
        const Box2i all = m_file.dataWindow();
        std::vector<Imf::Rgba> row(static_cast<size_t>(widthOf(all)));
        for (int y = all.min.y + firstRow; y < all.min.y + firstRow + rows; ++y) {
            // A y stride of 0 leaves only the x origin to account for.
            m_file.setFrameBuffer(Imf::ComputeBasePointer(row.data(), V2i(all.min.x, 0), static_cast<int64_t>(row.size())), 1, 0);
            m_file.readPixels(y);
            for (const Imf::Rgba& texel : row) {
                texels[0] = texel.r;
                texels[1] = texel.g;
                texels[2] = texel.b;
                if (m_floats == 4)
                    texels[3] = texel.a;
                texels += m_floats;
            }
        }
    }

private:
    Imf::RgbaInputFile m_file;
    int m_floats;
};

} // namespace

OpenedRows openRows(FileStream& stream, Imf::MultiPartInputFile& file, const Picture& picture, Channels channels, int level)
{
    const int floats = texelFloats(channels);
    const bool tiled = file.header(picture.part).hasTileDescription();
    if (picture.channels.luminanceChroma && (picture.part != 0 || tiled))
        throw FileError(stream.file().path().string(), "luminance/chroma is read from scanlines of the first part only; export it as RGB");
    OpenedRows opened;
    if (tiled) {
        const Imf::TiledInputPart tiles(file, picture.part);
        opened.levels = std::min(tiles.numXLevels(), tiles.numYLevels());
    }
    if (level < 0 || level >= opened.levels)
        return opened;
    if (picture.channels.luminanceChroma) {
        stream.seekg(0); // a file of its own in the same bytes
        opened.rows = std::make_unique<LuminanceChromaRows>(stream, floats);
    } else if (tiled) {
        opened.rows = std::make_unique<TiledRows>(file, picture, floats, level);
    } else {
        opened.rows = std::make_unique<ScanlineRows>(file, picture, floats);
    }
    return opened;
}

} // namespace mirrorball::exr
