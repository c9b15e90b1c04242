#include "exr_attributes.h"

#include "input_checks.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace mirrorball::exr {
namespace {

constexpr std::uint32_t manyParts = 0x1000; ///< in the version field: headers until an empty one

/// What stands in a header, up to its end or to what makes no sense: then it is no longer good.
class HeaderBytes {
public:
    explicit HeaderBytes(OpenedFile& file) : m_file(file) { m_file.seek(0); }
    bool isGood() const { return m_isGood; }
    std::int64_t left() const { return static_cast<std::int64_t>(m_file.size()) - static_cast<std::int64_t>(m_file.position()); }
    void skip(std::int64_t bytes) { m_file.seek(m_file.position() + static_cast<std::uint64_t>(bytes)); }
    std::uint32_t number()
    {
        std::array<unsigned char, 4> bytes{};
        m_isGood = m_isGood && m_file.read(bytes.data(), bytes.size()) == bytes.size();
        return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
    }
    /// Up to its zero byte; longer ones than OpenEXR takes end the reading.
    std::string name()
    {
        constexpr size_t longest = 255;
        std::string text;
        for (char c = 0; m_isGood; text += c) {
            m_isGood = m_file.read(&c, 1) == 1 && text.size() <= longest;
            if (c == 0)
                break;
        }
        return text;
    }

private:
    OpenedFile& m_file;
    bool m_isGood = true;
};

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

/// Bytes that OpenEXR will still read of a value that the file stands before. What tells its own size is passed over, as OpenEXR does, up
/// to where it claims more than is left.
std::int64_t valueBytes(HeaderBytes& header, std::string_view type, std::uint32_t claimed)
{
    if (type == "chlist") { // up to a channel without a name
        constexpr int channelBytes = 16;
        while (header.isGood() && !header.name().empty())
            header.skip(channelBytes);
        return 0;
    }
    if (type == "stringvector") { // each text with a size of its own
        for (std::int64_t passed = 0; header.isGood() && passed < std::int64_t{claimed};) {
            const std::int64_t text = header.number();
            if (text > header.left())
                return text;
            header.skip(text);
            passed += 4 + text;
        }
        return 0;
    }
    if (type == "preview") {
        const std::int64_t width = header.number(), height = header.number();
        return height > 0 && width > std::numeric_limits<std::int64_t>::max() / 4 / height ? std::numeric_limits<std::int64_t>::max()
                                                                                           : 4 * width * height;
    }
    const auto fixed = std::find_if(sizes.begin(), sizes.end(), [type](const FixedSize& f) { return f.type == type; });
    return fixed == sizes.end() ? std::int64_t{claimed} : fixed->bytes;
}

} // namespace

std::span<const FixedSize> fixedSizes() { return sizes; }

void checkAttributes(OpenedFile& file)
{
    HeaderBytes header(file);
    header.number(); // the signature
    const bool hasManyParts = (header.number() & manyParts) != 0;
    for (bool isEmpty = true; header.isGood();) {
        const std::string attribute = header.name();
        if (!attribute.empty()) {
            isEmpty = false;
            const std::string type = header.name();
            const std::uint32_t size = header.number();
            const std::int64_t claimed = valueBytes(header, type, size), rest = header.left();
            if (header.isGood() && claimed > rest)
                throw FileError(file.path().string(), "the OpenEXR file is damaged (its attribute " + oneLine(attribute) + " claims " +
                                                          std::to_string(claimed) + " bytes, and " + std::to_string(rest) +
                                                          " are left); export or download it again");
            header.skip(std::max(std::int64_t{0}, claimed));
        } else if (hasManyParts && !isEmpty) {
            isEmpty = true; // of the next header
        } else {
            break;
        }
    }
}

} // namespace mirrorball::exr
