#include "png_colors.h"

#include <array>
#include <fstream>
#include <string>

namespace mirrorball {

void readPngColors(const std::filesystem::path& path, StoredColors& colors)
{
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(8);
    std::array<unsigned char, 32> bytes{};
    const auto number = [&](size_t at) {
        return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
    };
    const auto read = [&](size_t count) {
        return bool(stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count)));
    };
    double gamma = 0.0;
    bool isSrgb = false;
    while (read(8)) {
        const std::uint32_t length = number(0);
        const std::string type(reinterpret_cast<const char*>(bytes.data()) + 4, 4);
        if (type == "IDAT" || type == "IEND")
            break;
        const std::streamoff next = std::streamoff{stream.tellg()} + length + 4;
        if (type == "gAMA" && length == 4 && read(4)) {
            gamma = number(0) * 1e-5;
        } else if (type == "sRGB" && length == 1) {
            isSrgb = true;
        } else if (type == "cHRM" && length == 32 && read(32)) {
            const auto point = [&](size_t i) { return glm::dvec2(number(8 * i), number(8 * i + 4)) * 1e-5; };
            colors.primaries = {point(1), point(2), point(3), point(0)};
        } else if (type == "cICP" && length == 4 && read(4)) {
            colors.codePoints = {bytes[0], bytes[1]};
        }
        stream.seekg(next);
    }
    colors.isSrgb = isSrgb;
    colors.isLinear = false;
    colors.exponent.reset();
    if (isSrgb) {
        colors.saysSo = "the sRGB chunk";
    } else if (gamma >= 0.05 && gamma <= 20.0) { // others are garbage
        colors.exponent = 1.0 / gamma;
        colors.saysSo = colors.primaries ? "the gAMA and cHRM chunks" : "the gAMA chunk";
    }
}

} // namespace mirrorball
