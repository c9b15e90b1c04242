#pragma once

#include "color.h"

#include "../error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

/// What every reader of image files checks the same way.
namespace mirrorball {

/// The largest image that is opened: 16384 x 16384. A header that asks for more is damaged or not an environment map.
inline constexpr long long maxTexels = 1LL << 28;

/// @throws FileError for a size that no image has, before anything is allocated for it
inline void checkImageSize(const std::string& path, long long width, long long height)
{
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
    if (width < 1 || height < 1)
        throw FileError(path, "its header claims " + size + "; the file is damaged, export or download it again");
    if (width > maxTexels || height > maxTexels || width * height > maxTexels)
        throw FileError(path, "its header claims " + size + "; at most 2^28 are read, scale it down first");
}

/// The matrix from a file's primaries to Rec.709. Nothing for Rec.709 itself (to 1e-4: files round) and for all zeros, which some
/// writers leave where they mean "unknown".
/// @throws FileError for primaries that span no colour space
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

/// Text from a file or another library as the part of a one-line message: its first line without the full stop, readable characters.
inline std::string oneLine(const std::string& text)
{
    std::string line = text.substr(0, std::min(text.find('\n'), size_t{300}));
    while (!line.empty() && (line.back() == '.' || line.back() == ' ' || line.back() == '\r'))
        line.pop_back();
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return line;
}

} // namespace mirrorball
