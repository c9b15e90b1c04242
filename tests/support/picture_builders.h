#pragma once

#include "core/image/image.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// PNG files and ICC profiles byte by byte, as other programs write them: they owe nothing to the code under test.
namespace mirrorball::test {

inline std::string bigEndian(std::uint32_t value, int bytes = 4)
{
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
}

inline std::string pngChunk(const std::string& type, const std::string& content)
{
    std::uint32_t crc = ~0u;
    for (const char c : type + content) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return bigEndian(static_cast<std::uint32_t>(content.size())) + type + content + bigEndian(~crc);
}

/// A zlib stream of stored blocks.
inline std::string zlibStored(const std::string& bytes)
{
    std::string out = "\x78\x01";
    for (size_t at = 0; at < bytes.size() || at == 0; at += 65535) {
        const auto count = static_cast<std::uint32_t>(std::min<size_t>(65535, bytes.size() - at));
        out += static_cast<char>(at + count >= bytes.size() ? 1 : 0);
        for (const std::uint32_t n : {count, ~count & 0xffffu})
            out += {static_cast<char>(n & 0xff), static_cast<char>(n >> 8)};
        out += bytes.substr(at, count);
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    return out + bigEndian(b << 16 | a);
}

/// Writes stored values in [0, 1], 3 or 4 channels, with `bits` 8 or 16, and chunks before the picture.
inline void writePng(const std::filesystem::path& path, const Image& stored, int bits, const std::string& chunks = {})
{
    std::string rows;
    for (int y = 0; y < stored.height; ++y) {
        rows += '\0';
        for (int x = 0; x < stored.width; ++x)
            for (int c = 0; c < stored.channels; ++c)
                rows +=
                    bigEndian(static_cast<std::uint32_t>(std::lround(stored.texel(x, y)[c] * (bits == 8 ? 255.0f : 65535.0f))), bits / 8);
    }
    const std::string header = bigEndian(static_cast<std::uint32_t>(stored.width)) + bigEndian(static_cast<std::uint32_t>(stored.height)) +
                               static_cast<char>(bits) + (stored.channels == 4 ? '\6' : '\2') + std::string(3, '\0');
    std::ofstream(path, std::ios::binary) << "\x89PNG\r\n\x1a\n"
                                          << pngChunk("IHDR", header) << chunks << pngChunk("IDAT", zlibStored(rows))
                                          << pngChunk("IEND", "");
}

inline std::string gammaChunk(double gamma) { return pngChunk("gAMA", bigEndian(static_cast<std::uint32_t>(std::lround(gamma * 1e5)))); }

/// White, red, green, blue.
inline std::string chromaticityChunk(const std::array<double, 8>& xy)
{
    std::string content;
    for (const double v : xy)
        content += bigEndian(static_cast<std::uint32_t>(std::lround(v * 1e5)));
    return pngChunk("cHRM", content);
}

/// An ICC profile, version 2, of Rec.709's primaries under D50 and one power as its curves. Source: ICC.1:2001-04
inline std::string iccProfile(double exponent)
{
    const auto fixed = [](double v) { return bigEndian(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(v * 65536.0)))); };
    const auto xyz = [&](double x, double y, double z) { return "XYZ " + std::string(4, '\0') + fixed(x) + fixed(y) + fixed(z); };
    const std::string curve = "curv" + std::string(4, '\0') + bigEndian(1) +
                              bigEndian(static_cast<std::uint32_t>(std::lround(exponent * 256)), 2) + std::string(2, '\0');
    const std::string text = "test profile";
    const std::string description = "desc" + std::string(4, '\0') + bigEndian(static_cast<std::uint32_t>(text.size() + 1)) + text +
                                    std::string(1 + 4 + 4 + 2 + 1 + 67 + 1, '\0');
    const std::vector<std::pair<std::string, std::string>> tags{{"desc", description},
                                                                {"wtpt", xyz(0.9642, 1.0, 0.8249)},
                                                                {"rXYZ", xyz(0.4360, 0.2225, 0.0139)},
                                                                {"gXYZ", xyz(0.3851, 0.7169, 0.0971)},
                                                                {"bXYZ", xyz(0.1431, 0.0606, 0.7139)},
                                                                {"rTRC", curve},
                                                                {"gTRC", curve},
                                                                {"bTRC", curve}};
    std::string table = bigEndian(static_cast<std::uint32_t>(tags.size())), content;
    const size_t start = 128 + 4 + 12 * tags.size();
    for (const auto& [name, bytes] : tags) {
        table += name + bigEndian(static_cast<std::uint32_t>(start + content.size())) + bigEndian(static_cast<std::uint32_t>(bytes.size()));
        content += bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
    }
    std::string header = bigEndian(static_cast<std::uint32_t>(start + content.size())) + std::string(4, '\0') + bigEndian(0x02400000) +
                         "mntrRGB XYZ " + std::string(12, '\0') + "acsp" + std::string(28, '\0') + fixed(0.9642) + fixed(1.0) +
                         fixed(0.8249);
    header += std::string(128 - header.size(), '\0');
    return header + table + content;
}

inline std::string iccChunk(const std::string& profile) { return pngChunk("iCCP", std::string("p\0\0", 3) + zlibStored(profile)); }

} // namespace mirrorball::test
