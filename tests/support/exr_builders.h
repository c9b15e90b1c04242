#pragma once

#include "core/image/image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// OpenEXR files as other programs write them, made with OpenEXR directly so that they owe nothing to the code under test.
namespace mirrorball::test {

/// One channel: its name and its samples, row by row, full resolution.
struct ExrChannel {
    std::string name;
    std::vector<float> samples;
};

/// Channels R, G and B of an image.
inline std::vector<ExrChannel> exrChannels(const Image& image)
{
    std::vector<ExrChannel> channels{{"R", {}}, {"G", {}}, {"B", {}}};
    for (size_t i = 0; i < image.texels.size(); ++i)
        channels[i % 3].samples.push_back(image.texels[i]);
    return channels;
}

inline Imf::Header exrHeader(int width, int height, const std::vector<ExrChannel>& channels, Imf::PixelType type,
                             Imf::Compression compression = Imf::ZIP_COMPRESSION)
{
    Imf::Header header(width, height);
    header.compression() = compression;
    for (const ExrChannel& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(type));
    return header;
}

/// A frame buffer over float or half copies; it must not outlive `storage`.
inline Imf::FrameBuffer exrFrameBuffer(const Imf::Header& header, const std::vector<ExrChannel>& channels,
                                       std::vector<std::vector<char>>& storage)
{
    const Imath::Box2i window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    Imf::FrameBuffer buffer;
    for (const ExrChannel& channel : channels) {
        const Imf::PixelType type = header.channels()[channel.name].type;
        const size_t size = type == Imf::HALF ? 2 : 4;
        std::vector<char>& bytes = storage.emplace_back(channel.samples.size() * size);
        for (size_t i = 0; i < channel.samples.size(); ++i) {
            if (type == Imf::HALF)
                reinterpret_cast<half*>(bytes.data())[i] = channel.samples[i];
            else if (type == Imf::FLOAT)
                reinterpret_cast<float*>(bytes.data())[i] = channel.samples[i];
            else
                reinterpret_cast<unsigned*>(bytes.data())[i] = static_cast<unsigned>(channel.samples[i]);
        }
        buffer.insert(channel.name,
                      Imf::Slice::Make(type, bytes.data(), window.min, width, height, size, size * static_cast<size_t>(width)));
    }
    return buffer;
}

inline void writeScanlineExr(const std::filesystem::path& path, const Imf::Header& header, const std::vector<ExrChannel>& channels)
{
    std::vector<std::vector<char>> storage;
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(exrFrameBuffer(header, channels, storage));
    file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
}

/// One level of tiles of any size.
inline void writeTiledExr(const std::filesystem::path& path, Imf::Header header, const std::vector<ExrChannel>& channels,
                          unsigned tileWidth, unsigned tileHeight)
{
    std::vector<std::vector<char>> storage;
    header.setTileDescription(Imf::TileDescription(tileWidth, tileHeight, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(exrFrameBuffer(header, channels, storage));
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

/// Values with few mantissa bits, so that half and RGBE hold them exactly: integers of up to 7 bits times a power of two per texel.
inline Image smallIntegerImage(int width, int height, unsigned seed = 1)
{
    std::mt19937 random(seed);
    Image image(width, height);
    for (size_t i = 0; i < image.texels.size(); i += 3) {
        const float scale = std::ldexp(1.0f, static_cast<int>(random() % 9) - 6);
        for (size_t c = 0; c < 3; ++c)
            image.texels[i + c] = static_cast<float>(random() % 128) * scale;
        image.texels[i + random() % 3] = static_cast<float>(128 + random() % 128) * scale; // one full mantissa fixes RGBE's exponent
    }
    return image;
}

/// Values that use all of a float: any sign, tiny to huge.
inline Image wildImage(int width, int height, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> mantissa(-1.0f, 1.0f);
    Image image(width, height);
    for (float& value : image.texels)
        value = std::ldexp(mantissa(random), static_cast<int>(random() % 200) - 100);
    return image;
}

} // namespace mirrorball::test
