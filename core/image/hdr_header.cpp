#include "hdr_header.h"

#include "input_checks.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <locale>
#include <sstream>

namespace mirrorball::hdr {

void ByteSource::restart()
{
    m_file.seek(0);
    m_next = m_end = m_headerBytes = 0;
}

std::string ByteSource::line()
{
    constexpr size_t longestHeader = 1 << 20;
    std::string text;
    for (char c = static_cast<char>(*take(1)); c != '\n'; c = static_cast<char>(*take(1))) {
        text += c;
        if (++m_headerBytes > longestHeader)
            throw FileError(m_file.path().string(), "the header does not end; this is not a Radiance picture");
    }
    if (!text.empty() && text.back() == '\r')
        text.pop_back();
    return text;
}

void ByteSource::refill(size_t count)
{
    const size_t kept = m_end - m_next;
    std::memmove(m_buffer.data(), m_buffer.data() + m_next, kept);
    m_next = 0;
    m_end = kept + m_file.read(m_buffer.data() + kept, m_buffer.size() - kept);
    if (m_end < count)
        throw FileError(m_file.path().string(), "the file ends early; copy or download it again");
}

namespace {

/// CIE XYZ seen as primaries. Radiance takes the equal-energy white as neutral, so gray stays gray.
const Chromaticities cieXyz{{1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}, {1.0 / 3.0, 1.0 / 3.0}};

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

/// A gain line; 1 and a note where it is no positive number.
glm::dvec3 parseGain(Header& header, const std::string& key, const std::string& text, size_t count)
{
    const std::vector<double> values = parseNumbers(text, count);
    if (values.empty() || *std::min_element(values.begin(), values.end()) <= 0.0) {
        header.notes.push_back("its header's " + key + "=" + oneLine(text.substr(0, 40)) + " is no positive number and not applied");
        return glm::dvec3(1.0);
    }
    return count == 3 ? glm::dvec3(values[0], values[1], values[2]) : glm::dvec3(values[0]);
}

void parsePrimaries(Header& header, const std::string& text, Chromaticities& primaries)
{
    const std::vector<double> v = parseNumbers(text, 8);
    if (v.empty())
        header.notes.push_back("its header's PRIMARIES are not eight numbers and not used");
    else
        primaries = {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}};
}

/// A row of 16384 texels of one color takes 1 kB. A header of 60 bytes that claims 2^28 texels costs memory before the rows are missed.
void checkLength(const OpenedFile& file, long long texels)
{
    const auto bytes = static_cast<long long>(file.size());
    if (texels > std::max(1LL << 24, 128 * bytes))
        throw FileError(file.path().string(), "the file is too short: its header claims " + std::to_string(texels) + " texels in " +
                                                  std::to_string(bytes) + " bytes; export or download it again");
}

void parseResolution(const OpenedFile& file, const std::string& line, Header& header)
{
    const std::string path = file.path().string();
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
    const bool streams = !header.order.transposed && !header.order.upward;
    checkImageSize(path, sizes[x], sizes[1 - x], streams ? maxStreamedTexels : maxTexels);
    checkLength(file, sizes[x] * sizes[1 - x]);
    header.width = static_cast<int>(sizes[x]);
    header.height = static_cast<int>(sizes[1 - x]);
}

} // namespace

Header readHeader(ByteSource& bytes)
{
    const std::string path = bytes.file().path().string();
    Header header;
    Chromaticities primaries;
    bool xyz = false;
    for (std::string line = bytes.line(); !line.empty(); line = bytes.line()) {
        const size_t equals = line.find('=');
        if (line[0] == '#' || equals == std::string::npos)
            continue; // the magic word (some writers repeat it), comments, the commands that made the picture
        std::string key = lowerCase(line.substr(0, equals));
        key.erase(0, key.find_first_not_of(" \t"));
        key.erase(key.find_last_not_of(" \t") + 1);
        const std::string value = line.substr(equals + 1);
        if (key == "format") {
            const std::string format = lowerCase(value);
            xyz = format.find("32-bit_rle_xyze") != std::string::npos;
            if (!xyz && format.find("32-bit_rle_rgbe") == std::string::npos)
                throw FileError(path, "its format \"" + oneLine(value.substr(0, 40)) + "\" is unknown; save it as 32-bit_rle_rgbe");
        } else if (key == "exposure") {
            header.gain /= parseGain(header, "EXPOSURE", value, 1);
        } else if (key == "colorcorr") {
            header.gain /= parseGain(header, "COLORCORR", value, 3);
        } else if (key == "primaries") {
            parsePrimaries(header, value, primaries);
        }
    }
    if (!(glm::all(glm::greaterThan(header.gain, glm::dvec3(1e-30))) && glm::all(glm::lessThan(header.gain, glm::dvec3(1e30))))) {
        header.notes.push_back("its header's EXPOSURE and COLORCORR lines multiply up beyond range and are not applied");
        header.gain = glm::dvec3(1.0);
    }
    parseResolution(bytes.file(), bytes.line(), header);
    try {
        header.toRec709 = conversionFrom(path, xyz ? cieXyz : primaries);
    } catch (const FileError&) {
        header.notes.push_back("its header's PRIMARIES span no color space and are not used");
    }
    header.encoding = xyz ? "linear, CIE XYZ" : header.toRec709 ? "linear, the header's PRIMARIES" : "linear, Rec.709 primaries";
    return header;
}

} // namespace mirrorball::hdr
