#pragma once

#include "color.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

/// What every reader of image files checks the same way.
namespace mirrorball {

/// The largest image that is held whole: 16384 x 16384.
inline constexpr long long maxTexels = 1LL << 28;
/// The largest image that is opened where rows can be read without holding the others: 32768 x 32768. A header that asks for more is
/// damaged or not an environment map.
inline constexpr long long maxStreamedTexels = 1LL << 30;

/// @param most  maxTexels or maxStreamedTexels
/// @throws FileError for a size that no image has, before anything is allocated for it
inline void checkImageSize(const std::string& path, long long width, long long height, long long most = maxTexels)
{
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
    if (width < 1 || height < 1)
        throw FileError(path, "its header claims " + size + "; the file is damaged, export or download it again");
    if (width > most || height > most || width * height > most)
        throw FileError(path, "its header claims " + size + "; at most " + (most == maxTexels ? "2^28" : "2^30") +
                                  " are read, scale it down first");
}

/// Refuses a picture that claims more texels than anybody lights with and than so many bytes can tell of: formats that compress well hold
/// gigabytes of blank texels in a file of a few hundred bytes.
/// @throws FileError
inline void checkTexelsHeld(const std::string& path, long long width, long long height, std::uintmax_t fileBytes, long long texelsPerByte)
{
    constexpr long long few = 1LL << 24;
    if (width * height > std::max(few, texelsPerByte * static_cast<long long>(fileBytes)))
        throw FileError(path, "its header claims " + std::to_string(width) + " x " + std::to_string(height) + " texels in a file of " +
                                  std::to_string(fileBytes) + " bytes; it is damaged or blank, scale it down or export it again");
}

/// The matrix from a file's primaries to Rec.709. Nothing for Rec.709 itself (to 1e-4: files round) and for all zeros, which some
/// writers leave where they mean "unknown".
/// @throws FileError for primaries that span no color space
inline std::optional<glm::mat3> conversionFrom(const std::string& path, const Chromaticities& c)
{
    const auto largestDifference = [&](const Chromaticities& d) {
        const glm::dvec2 difference = glm::max(glm::max(glm::abs(c.red - d.red), glm::abs(c.green - d.green)),
                                               glm::max(glm::abs(c.blue - d.blue), glm::abs(c.white - d.white)));
        return std::max(difference.x, difference.y);
    };
    if (largestDifference({}) < 1e-4 || largestDifference({{}, {}, {}, {}}) == 0.0)
        return std::nullopt;
    try {
        return glm::mat3(toRec709(c));
    } catch (const InvalidArgument& error) {
        throw FileError(path, error.what());
    }
}

/// Bytes of the UTF-8 character that begins at text[i]; 0 where none does. (Overlong forms and surrogates are let through: terminals
/// and JSON readers cope with those, but not with stray bytes.)
inline size_t utf8Length(const std::string& text, size_t i)
{
    const auto byte = [&](size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u; };
    const unsigned lead = byte(i);
    const size_t length = lead < 0x80 ? 1 : lead >> 5 == 0x6 ? 2 : lead >> 4 == 0xe ? 3 : lead >> 3 == 0x1e ? 4 : 0;
    for (size_t k = 1; k < length; ++k)
        if (byte(i + k) >> 6 != 0x2)
            return 0;
    return length;
}

/// Text from a file or another library as the part of a one-line message: its first line without the full stop, readable characters
/// only, in valid UTF-8.
inline std::string oneLine(const std::string& text)
{
    std::string line = text.substr(0, std::min(text.find('\n'), size_t{300}));
    while (!line.empty() && (line.back() == '.' || line.back() == ' ' || line.back() == '\r'))
        line.pop_back();
    for (size_t i = 0; i < line.size();) {
        const size_t length = utf8Length(line, i);
        if (length == 0 || static_cast<unsigned char>(line[i]) < 0x20 || line[i] == 0x7f)
            line[i] = '?';
        i += std::max<size_t>(length, 1);
    }
    return line;
}

} // namespace mirrorball
