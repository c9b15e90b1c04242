#include "exr_attributes.h"

#include "input_checks.h"

#include "core/base/error.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

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

} // namespace

const std::filesystem::path& withPlausibleAttributes(const std::filesystem::path& path)
{
    std::error_code unknown;
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path, unknown));
    std::ifstream file(path, std::ios::binary);
    number(file); // the signature
    const bool hasManyParts = (number(file) & manyParts) != 0;
    for (bool isEmpty = true; !unknown && file;) {
        const std::string attribute = name(file);
        if (!attribute.empty()) {
            isEmpty = false;
            name(file); // its type
            const std::int64_t claimed = number(file), left = size - static_cast<std::int64_t>(file.tellg());
            if (file && claimed > left)
                throw FileError(path.string(), "the OpenEXR file is damaged (its attribute " + oneLine(attribute) + " claims " +
                                                   std::to_string(claimed) + " bytes, and " + std::to_string(left) +
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
