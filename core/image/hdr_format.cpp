#include "hdr_format.h"

#include "input_checks.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>

namespace mirrorball::hdr {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr int smallestRleWidth = 8; ///< narrower and wider scanlines have no per-component run-length form
constexpr int largestRleWidth = 32767;
constexpr size_t longestHeader = 1 << 20;

/// The bytes of a file, buffered, with an error that says the file ends early instead of a short count.
class ByteSource {
public:
    explicit ByteSource(const std::filesystem::path& path)
        : m_path(path), m_file(std::fopen(path.c_str(), "rb"), &std::fclose), m_buffer(size_t{1} << 18)
    {
        if (!m_file)
            throw FileError(path.string(), std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
    }

    /// The next `count` bytes, at most the buffer's size, in one piece.
    const std::uint8_t* take(size_t count)
    {
        if (m_end - m_next < count)
            refill(count);
        const std::uint8_t* bytes = m_buffer.data() + m_next;
        m_next += count;
        return bytes;
    }

    /// A line of the header without its end.
    std::string line()
    {
        std::string text;
        for (char c = static_cast<char>(*take(1)); c != '\n'; c = static_cast<char>(*take(1))) {
            text += c;
            if (++m_headerBytes > longestHeader)
                throw FileError(m_path.string(), "the header does not end; this is not a Radiance picture");
        }
        if (!text.empty() && text.back() == '\r')
            text.pop_back();
        return text;
    }

    /// Steps back over bytes just taken.
    void putBack(size_t count) { m_next -= count; }

private:
    void refill(size_t count)
    {
        const size_t kept = m_end - m_next;
        std::memmove(m_buffer.data(), m_buffer.data() + m_next, kept);
        m_next = 0;
        m_end = kept + std::fread(m_buffer.data() + kept, 1, m_buffer.size() - kept, m_file.get());
        if (m_end < count)
            throw FileError(m_path.string(), "the file ends early; copy or download it again");
    }

    std::filesystem::path m_path;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_file;
    std::vector<std::uint8_t> m_buffer;
    size_t m_next = 0;
    size_t m_end = 0;
    size_t m_headerBytes = 0;
};

/// CIE XYZ seen as primaries. Radiance takes the equal-energy white as neutral, so grey stays grey.
const Chromaticities cieXyz{{1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}, {1.0 / 3.0, 1.0 / 3.0}};

/// How scanlines lie in the picture: the first axis of the resolution line counts scanlines, the second the texels in one.
struct Order {
    bool transposed = false; ///< scanlines are columns
    bool upward = false;     ///< "+Y": the first row stored is the bottom one
    bool leftward = false;   ///< "-X"
};

struct Header {
    int width = 0;
    int height = 0;
    Order order{};
    glm::dvec3 gain{1.0}; ///< 1 / (EXPOSURE * COLORCORR), both multiplied up over their lines
    std::optional<glm::mat3> toRec709{};

    int scanlines() const { return order.transposed ? width : height; }
    int scanlineTexels() const { return order.transposed ? height : width; }
};

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// `count` numbers separated by blanks; empty when the text holds anything else.
std::vector<double> parseNumbers(const std::string& text, size_t count)
{
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    std::vector<double> values(count);
    for (double& value : values)
        if (!(stream >> value) || !std::isfinite(value))
            return {};
    return values;
}

glm::dvec3 parseGain(const std::string& path, const std::string& key, const std::string& text, size_t count)
{
    const std::vector<double> values = parseNumbers(text, count);
    if (values.empty() || *std::min_element(values.begin(), values.end()) <= 0.0)
        throw FileError(path, "the header's " + key + "=" + oneLine(text.substr(0, 40)) +
                                  " is not a positive number; correct or remove that line");
    return count == 3 ? glm::dvec3(values[0], values[1], values[2]) : glm::dvec3(values[0]);
}

/// A row of 16384 texels of one colour takes 1 kB. A header of 60 bytes that claims 2^28 texels costs memory before the rows are missed.
void checkLength(const std::string& path, long long texels)
{
    std::error_code unknown;
    const auto bytes = static_cast<long long>(std::filesystem::file_size(path, unknown));
    if (!unknown && texels > std::max(1LL << 24, 128 * bytes))
        throw FileError(path, "the file is too short: its header claims " + std::to_string(texels) + " texels in " + std::to_string(bytes) +
                                  " bytes; export or download it again");
}

void parseResolution(const std::string& path, const std::string& line, Header& header)
{
    std::array<char, 2> signs{};
    std::array<char, 2> axes{};
    std::array<long long, 2> sizes{};
    const int read = std::sscanf(line.c_str(), " %c%c %lld %c%c %lld", &signs[0], &axes[0], &sizes[0], &signs[1], &axes[1], &sizes[1]);
    const auto isSign = [](char c) { return c == '+' || c == '-'; };
    const bool named = (axes[0] == 'Y' && axes[1] == 'X') || (axes[0] == 'X' && axes[1] == 'Y');
    if (read != 6 || !isSign(signs[0]) || !isSign(signs[1]) || !named)
        throw FileError(path, "the header holds no resolution line such as \"-Y 512 +X 1024\"; it is damaged or not a Radiance picture");
    header.order.transposed = axes[0] == 'X';
    const size_t x = header.order.transposed ? 0 : 1;
    header.order.leftward = signs[x] == '-';
    header.order.upward = signs[1 - x] == '+';
    checkImageSize(path, sizes[x], sizes[1 - x]);
    checkLength(path, sizes[x] * sizes[1 - x]);
    header.width = static_cast<int>(sizes[x]);
    header.height = static_cast<int>(sizes[1 - x]);
}

Header readHeader(const std::filesystem::path& file, ByteSource& bytes)
{
    const std::string path = file.string();
    Header header;
    Chromaticities primaries;
    bool xyz = false;
    for (std::string line = bytes.line(); !line.empty(); line = bytes.line()) {
        const size_t equals = line.find('=');
        if (line[0] == '#' || equals == std::string::npos)
            continue; // the magic word (some writers repeat it), comments, the commands that made the picture
        const std::string key = lowerCase(line.substr(0, equals));
        const std::string value = line.substr(equals + 1);
        if (key == "format") {
            const std::string format = lowerCase(value);
            xyz = format.find("32-bit_rle_xyze") != std::string::npos;
            if (!xyz && format.find("32-bit_rle_rgbe") == std::string::npos)
                throw FileError(path, "its format \"" + oneLine(value.substr(0, 40)) + "\" is unknown; save it as 32-bit_rle_rgbe");
        } else if (key == "exposure") {
            header.gain /= parseGain(path, "EXPOSURE", value, 1);
        } else if (key == "colorcorr") {
            header.gain /= parseGain(path, "COLORCORR", value, 3);
        } else if (key == "primaries") {
            const std::vector<double> v = parseNumbers(value, 8);
            if (v.empty())
                throw FileError(path, "the header's PRIMARIES are not eight numbers; correct or remove that line");
            primaries = {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}};
        }
    }
    if (!(glm::all(glm::greaterThan(header.gain, glm::dvec3(1e-30))) && glm::all(glm::lessThan(header.gain, glm::dvec3(1e30)))))
        throw FileError(path, "the header's EXPOSURE and COLORCORR lines multiply up beyond range; correct or remove them");
    parseResolution(path, bytes.line(), header);
    header.toRec709 = conversionFrom(path, xyz ? cieXyz : primaries);
    return header;
}

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
    explicit HdrReader(const std::filesystem::path& path)
        : m_bytes(path), m_header(readHeader(path, m_bytes)), m_decoder(path, m_bytes, m_header.scanlineTexels()),
          m_scanline(static_cast<size_t>(m_header.scanlineTexels()))
    {
        const std::uint64_t needed = static_cast<std::uint64_t>(m_header.scanlines()) * smallestScanline(m_header.scanlineTexels());
        if (std::filesystem::file_size(path) < needed)
            throw FileError(path.string(), "the file is too short for " + std::to_string(m_header.width) + " x " +
                                               std::to_string(m_header.height) + " texels; copy or download it again");
        m_info.path = path;
        m_info.format = "hdr";
        m_info.width = m_header.width;
        m_info.height = m_header.height;
        m_info.channels = 3;
        m_info.sampleType = "rgbe";
        m_info.compression = "rle";
    }

    const ImageFileInfo& info() const override { return m_info; }

    void readRows(int firstRow, int rows, float* rgb) override
    {
        const bool streams = !m_header.order.transposed && !m_header.order.upward;
        if (!streams && m_texels.empty())
            decodeAll();
        const auto width = static_cast<size_t>(m_header.width);
        for (int y = firstRow; y < firstRow + rows; ++y, rgb += 3 * width)
            convert(streams ? decodeRow(y) : m_texels.data() + static_cast<size_t>(y) * width, rgb);
    }

private:
    const Rgbe* decodeRow(int y)
    {
        if (y < m_nextScanline) { // asked for again: decode from the start
            m_bytes = ByteSource(m_info.path);
            readHeader(m_info.path, m_bytes);
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

    void convert(const Rgbe* texels, float* rgb) const
    {
        static const std::array<float, 256> scales = exponentScales();
        const auto width = static_cast<size_t>(m_header.width);
        for (size_t i = 0; i < width; ++i) {
            const float scale = scales[texels[i][3]];
            for (size_t c = 0; c < 3; ++c)
                rgb[3 * i + c] = static_cast<float>(texels[i][c]) * scale;
        }
        if (m_header.gain == glm::dvec3(1.0) && !m_header.toRec709)
            return;
        const glm::mat3 matrix = m_header.toRec709.value_or(glm::mat3(1.0f));
        for (size_t i = 0; i < width; ++i) {
            const glm::vec3 colour = matrix * glm::vec3(glm::dvec3(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) * m_header.gain);
            std::copy_n(&colour.x, 3, rgb + 3 * i);
        }
    }

    ByteSource m_bytes;
    Header m_header;
    ScanlineDecoder m_decoder;
    std::vector<Rgbe> m_scanline;
    int m_nextScanline = 0;
    std::vector<Rgbe> m_texels{}; ///< the whole picture, only when it is not stored top to bottom
    ImageFileInfo m_info{};
};

/// Nearest RGBE: the exponent is the brightest channel's, mantissas are rounded, and a mantissa that rounds up to 256 moves it up.
Rgbe encode(const float* texel, int channels)
{
    constexpr float largest = 0x1.FEp126f; // 255 * 2^(255 - 136)
    std::array<float, 3> rgb{};
    for (size_t c = 0; c < 3; ++c) {
        const float value = texel[channels < 3 ? 0 : c];
        rgb[c] = value > 0.0f ? std::min(value, largest) : 0.0f; // NaN compares false
    }
    const float brightest = std::max({rgb[0], rgb[1], rgb[2]});
    if (brightest < 0x1p-128f)
        return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(brightest, &exponent);
    float scale = std::ldexp(1.0f, 8 - exponent);
    if (brightest * scale >= 255.5f) {
        ++exponent;
        scale *= 0.5f;
    }
    Rgbe result{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
    for (size_t c = 0; c < 3; ++c)
        result[c] = static_cast<std::uint8_t>(rgb[c] * scale + 0.5f);
    return result;
}

/// One component of a scanline as runs of 4 to 127 equal values and literals of up to 128 others.
void appendRuns(const std::uint8_t* values, size_t count, std::vector<std::uint8_t>& bytes)
{
    const auto runAt = [&](size_t start) {
        size_t length = 1;
        while (start + length < count && length < 127 && values[start + length] == values[start])
            ++length;
        return length;
    };
    for (size_t i = 0; i < count;) {
        size_t run = runAt(i);
        if (run >= 4) {
            bytes.push_back(static_cast<std::uint8_t>(128 + run));
            bytes.push_back(values[i]);
            i += run;
            continue;
        }
        const size_t start = i;
        do {
            i += run;
            run = i < count ? runAt(i) : 4;
        } while (run < 4 && i + run - start <= 128);
        bytes.push_back(static_cast<std::uint8_t>(i - start));
        bytes.insert(bytes.end(), values + start, values + i);
    }
}

} // namespace

bool hasSignature(std::string_view firstBytes) { return firstBytes.starts_with("#?"); }

std::unique_ptr<ImageReader> open(const std::filesystem::path& path) { return std::make_unique<HdrReader>(path); }

void write(AtomicFile& file, const Image& image)
{
    const std::string header =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " + std::to_string(image.width) + "\n";
    file.write(header.data(), header.size());
    const auto width = static_cast<size_t>(image.width);
    const bool runs = image.width >= smallestRleWidth && image.width <= largestRleWidth;
    std::vector<std::uint8_t> planes(4 * width);
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < image.height; ++y) {
        bytes.clear();
        for (size_t x = 0; x < width; ++x) {
            const Rgbe texel = encode(image.row(y) + x * static_cast<size_t>(image.channels), image.channels);
            for (size_t c = 0; c < 4; ++c)
                planes[runs ? c * width + x : 4 * x + c] = texel[c];
        }
        if (runs) {
            bytes = {2, 2, static_cast<std::uint8_t>(width >> 8), static_cast<std::uint8_t>(width & 0xff)};
            for (size_t c = 0; c < 4; ++c)
                appendRuns(planes.data() + c * width, width, bytes);
        }
        const std::vector<std::uint8_t>& stored = runs ? bytes : planes;
        file.write(stored.data(), stored.size());
    }
}

} // namespace mirrorball::hdr
