#include "hdr_format.h"

#include "hdr_header.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>

namespace mirrorball::hdr {
namespace {

/// The fewest bytes a scanline can take: one texel and, for the rest, repeat counts of 8 bits each.
std::uint64_t smallestScanline(int texels)
{
    std::uint64_t bytes = 4;
    for (int rest = texels - 1; rest > 0; rest >>= 8)
        bytes += 4;
    return bytes;
}

/// Decodes scanlines of any of the three codings into RGBE texels.
class ScanlineDecoder {
public:
    ScanlineDecoder(const std::filesystem::path& path, ByteSource& bytes, int texels)
        : m_path(path), m_bytes(bytes), m_texels(static_cast<size_t>(texels)), m_planes(4 * m_texels)
    {
    }

    void decode(Rgbe* texels)
    {
        const bool mayBeRle = m_texels >= smallestRleWidth && m_texels <= largestRleWidth;
        const std::uint8_t* start = m_bytes.take(4);
        if (!mayBeRle || start[0] != 2 || start[1] != 2 || (start[2] & 0x80) != 0) {
            m_bytes.putBack(4);
            decodeOld(texels);
            return;
        }
        if (m_texels != ((static_cast<size_t>(start[2]) << 8) | start[3]))
            damaged("a scanline has another length than the picture");
        for (size_t plane = 0; plane < 4; ++plane)
            decodePlane(m_planes.data() + plane * m_texels);
        for (size_t i = 0; i < m_texels; ++i)
            texels[i] = {m_planes[i], m_planes[m_texels + i], m_planes[2 * m_texels + i], m_planes[3 * m_texels + i]};
    }

private:
    /// One component of a scanline: runs (count + 128, value) and literals (count, values...).
    void decodePlane(std::uint8_t* plane)
    {
        for (size_t i = 0; i < m_texels;) {
            const size_t code = *m_bytes.take(1);
            const size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || count > m_texels - i)
                damaged("a run leaves its scanline");
            if (code > 128)
                std::memset(plane + i, *m_bytes.take(1), count);
            else
                std::memcpy(plane + i, m_bytes.take(count), count);
            i += count;
        }
    }

    /// Plain texels, among which (1, 1, 1, n) repeats the one before n times; repeats in a row are the digits, base 256, of one count.
    void decodeOld(Rgbe* texels)
    {
        size_t digit = 0;
        for (size_t i = 0; i < m_texels;) {
            const std::uint8_t* bytes = m_bytes.take(4);
            if (bytes[0] != 1 || bytes[1] != 1 || bytes[2] != 1) {
                texels[i++] = {bytes[0], bytes[1], bytes[2], bytes[3]};
                digit = 0;
                continue;
            }
            const std::uint64_t count = digit < 4 ? std::uint64_t{bytes[3]} << (8 * digit++) : std::numeric_limits<std::uint64_t>::max();
            if (i == 0 || count > m_texels - i)
                damaged("a run leaves its scanline");
            std::fill_n(texels + i, count, texels[i - 1]);
            i += count;
        }
    }

    [[noreturn]] void damaged(const std::string& how) const
    {
        throw FileError(m_path.string(), "the picture is damaged: " + how + "; copy or download it again");
    }

    std::filesystem::path m_path;
    ByteSource& m_bytes;
    size_t m_texels;
    std::vector<std::uint8_t> m_planes;
};

/// Scale of an exponent byte: 2^(e - 136), exact in float down to e = 1. Exponent 0 means black whatever the mantissas say.
std::array<float, 256> exponentScales()
{
    std::array<float, 256> scales{};
    for (int e = 1; e < 256; ++e)
        scales[static_cast<size_t>(e)] = std::ldexp(1.0f, e - 136);
    return scales;
}

class HdrReader final : public ImageReader {
public:
    HdrReader(OpenedFile file, const ProbeReading& reading, Channels channels)
        : m_bytes(std::move(file)), m_header(readHeader(m_bytes)), m_decoder(m_bytes.file().path(), m_bytes, m_header.scanlineTexels()),
          m_scanline(static_cast<size_t>(m_header.scanlineTexels())), m_floats(static_cast<size_t>(texelFloats(channels)))
    {
        const std::uint64_t needed = static_cast<std::uint64_t>(m_header.scanlines()) * smallestScanline(m_header.scanlineTexels());
        const std::filesystem::path& path = m_bytes.file().path();
        if (m_bytes.file().size() < needed)
            throw FileError(path.string(), "the file is too short for " + std::to_string(m_header.width) + " x " +
                                               std::to_string(m_header.height) + " texels; copy or download it again");
        m_info.path = path;
        m_info.format = "hdr";
        m_info.width = m_header.width;
        m_info.height = m_header.height;
        m_info.channels = 3;
        m_info.sampleType = "rgbe";
        m_info.compression = "rle";
        m_info.notes = m_header.notes;
        if (!reading.colorSpace.empty())
            m_header.toRec709.reset();
        const bool upright = !m_header.order.transposed && !m_header.order.upward && !m_header.order.leftward;
        assume(m_info.assumed, {"encoding", m_header.encoding, "the format is linear"});
        assume(m_info.assumed, {"orientation", upright ? "upright" : "as the header says, set upright", "the header's resolution line"});
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* texels) override
    {
        const bool streams = !m_header.order.transposed && !m_header.order.upward;
        if (!streams && m_texels.empty())
            decodeAll();
        const auto width = static_cast<size_t>(m_header.width);
        for (int y = firstRow; y < firstRow + rows; ++y, texels += m_floats * width)
            convert(streams ? decodeRow(y) : m_texels.data() + static_cast<size_t>(y) * width, texels);
    }

private:
    const Rgbe* decodeRow(int y)
    {
        if (y < m_nextScanline) { // asked for again: decode from the start
            m_bytes.restart();
            readHeader(m_bytes);
            m_nextScanline = 0;
        }
        for (; m_nextScanline <= y; ++m_nextScanline)
            m_decoder.decode(m_scanline.data());
        if (m_header.order.leftward)
            std::reverse(m_scanline.begin(), m_scanline.end());
        return m_scanline.data();
    }

    /// The whole picture, top to bottom and left to right. Memory grows with what the file really holds, not with what it claims.
    void decodeAll()
    {
        const size_t lines = static_cast<size_t>(m_header.scanlines());
        const size_t length = m_scanline.size();
        std::vector<Rgbe> stored;
        stored.reserve(lines * length);
        for (size_t line = 0; line < lines; ++line) {
            m_decoder.decode(m_scanline.data());
            stored.insert(stored.end(), m_scanline.begin(), m_scanline.end());
        }
        const auto width = static_cast<size_t>(m_header.width);
        const auto height = static_cast<size_t>(m_header.height);
        m_texels.resize(stored.size());
        for (size_t y = 0; y < height; ++y)
            for (size_t x = 0; x < width; ++x) {
                const size_t fromTop = m_header.order.upward ? height - 1 - y : y;
                const size_t fromLeft = m_header.order.leftward ? width - 1 - x : x;
                m_texels[y * width + x] = stored[m_header.order.transposed ? fromLeft * length + fromTop : fromTop * length + fromLeft];
            }
    }

    void convert(const Rgbe* stored, float* texels) const
    {
        static const std::array<float, 256> scales = exponentScales();
        const bool isPlain = m_header.gain == glm::dvec3(1.0) && !m_header.toRec709;
        const glm::mat3 matrix = m_header.toRec709.value_or(glm::mat3(1.0f));
        for (int x = 0; x < m_header.width; ++x, ++stored, texels += m_floats) {
            const float scale = scales[(*stored)[3]];
            for (size_t c = 0; c < 3; ++c)
                texels[c] = static_cast<float>((*stored)[c]) * scale;
            if (m_floats == 4)
                texels[3] = 1.0f;
            if (isPlain)
                continue;
            const glm::vec3 color = matrix * glm::vec3(glm::dvec3(texels[0], texels[1], texels[2]) * m_header.gain);
            std::copy_n(&color.x, 3, texels);
        }
    }

    ByteSource m_bytes;
    Header m_header;
    ScanlineDecoder m_decoder;
    std::vector<Rgbe> m_scanline;
    size_t m_floats; ///< a texel
    int m_nextScanline = 0;
    std::vector<Rgbe> m_texels{}; ///< the whole picture, only when it is not stored top to bottom
    ImageFileInfo m_info{};
};

} // namespace

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with("#?"); }

std::unique_ptr<ImageReader> open(OpenedFile file, const ProbeReading& reading, Channels channels)
{
    return std::make_unique<HdrReader>(std::move(file), reading, channels);
}

} // namespace mirrorball::hdr
