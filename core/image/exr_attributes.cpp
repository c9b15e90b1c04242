#include "exr_attributes.h"

#include "input_checks.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace mirrorball::exr {
namespace {

constexpr std::uint32_t manyParts = 0x1000; ///< in the version field: headers until an empty one

std::uint32_t number(std::istream& file)
{
    std::array<unsigned char, 4> bytes{};
    file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
}

/// A name up to its zero byte; longer ones than OpenEXR takes end the reading.
std::string name(std::istream& file)
{
    constexpr size_t longest = 255;
    std::string text;
    for (int c = file.get(); c > 0; c = file.get()) {
        text += static_cast<char>(c);
        if (text.size() > longest)
            file.setstate(std::ios::failbit);
    }
    return text;
}

constexpr std::array sizes{FixedSize{"box2f", 16},
                           FixedSize{"box2i", 16},
                           FixedSize{"chromaticities", 32},
                           FixedSize{"compression", 1},
                           FixedSize{"deepImageState", 1},
                           FixedSize{"double", 8},
                           FixedSize{"envmap", 1},
                           FixedSize{"float", 4},
                           FixedSize{"int", 4},
                           FixedSize{"keycode", 28},
                           FixedSize{"lineOrder", 1},
                           FixedSize{"m33d", 72},
                           FixedSize{"m33f", 36},
                           FixedSize{"m44d", 128},
                           FixedSize{"m44f", 64},
                           FixedSize{"rational", 8},
                           FixedSize{"tiledesc", 9},
                           FixedSize{"timecode", 8},
                           FixedSize{"v2d", 16},
                           FixedSize{"v2f", 8},
                           FixedSize{"v2i", 8},
                           FixedSize{"v3d", 24},
                           FixedSize{"v3f", 12},
                           FixedSize{"v3i", 12}};

std::int64_t left(std::istream& file, std::int64_t fileSize) { return fileSize - static_cast<std::int64_t>(file.tellg()); }

/// Bytes that OpenEXR will still read of a value that the file stands before. What tells its own size is passed over, as OpenEXR does, up
/// to where it claims more than is left.
std::int64_t valueBytes(std::istream& file, std::int64_t fileSize, std::string_view type, std::uint32_t claimed)
{
    if (type == "chlist") { // up to a channel without a name
        constexpr int channelBytes = 16;
        while (file && !name(file).empty())
            file.seekg(channelBytes, std::ios::cur);
        return 0;
    }
    if (type == "stringvector") { // each text with a size of its own
        for (std::int64_t passed = 0; file && passed < std::int64_t{claimed};) {
            const std::int64_t text = number(file);
            if (text > left(file, fileSize))
                return text;
            file.seekg(text, std::ios::cur);
            passed += 4 + text;
        }
        return 0;
    }
    if (type == "preview") {
        const std::int64_t width = number(file), height = number(file);
        return height > 0 && width > std::numeric_limits<std::int64_t>::max() / 4 / height ? std::numeric_limits<std::int64_t>::max()
                                                                                           : 4 * width * height;
    }
    const auto fixed = std::find_if(sizes.begin(), sizes.end(), [type](const FixedSize& f) { return f.type == type; });
    return fixed == sizes.end() ? std::int64_t{claimed} : fixed->bytes;
}

} // namespace

std::span<const FixedSize> fixedSizes() { return sizes; }

const std::filesystem::path& withPlausibleAttributes(const std::filesystem::path& path)
{
    std::error_code unknown;
    const auto fileSize = static_cast<std::int64_t>(std::filesystem::file_size(path, unknown));
    std::ifstream file(path, std::ios::binary);
    number(file); // the signature
    const bool hasManyParts = (number(file) & manyParts) != 0;
    for (bool isEmpty = true; !unknown && file;) {
        const std::string attribute = name(file);
        if (!attribute.empty()) {
            isEmpty = false;
            const std::string type = name(file);
            const std::uint32_t size = number(file);
            const std::int64_t claimed = valueBytes(file, fileSize, type, size), rest = left(file, fileSize);
            if (file && claimed > rest)
                throw FileError(path.string(), "the OpenEXR file is damaged (its attribute " + oneLine(attribute) + " claims " +
                                                   std::to_string(claimed) + " bytes, and " + std::to_string(rest) +
                                                   " are left); export or download it again");
            file.seekg(claimed, std::ios::cur);
        } else if (hasManyParts && !isEmpty) {
            isEmpty = true; // of the next header
        } else {
            break;
        }
    }
    return path;
}

} // namespace mirrorball::exr
