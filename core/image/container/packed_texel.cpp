#include "packed_texel.h"

#include <half.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mirrorball {

namespace {

/// NaN compares false and becomes 0.
float clamped(float value, float largest) { return value > 0.0f ? std::min(value, largest) : 0.0f; }
glm::vec3 clamped(const glm::vec3& rgb, float largest)
{
    return {clamped(rgb.r, largest), clamped(rgb.g, largest), clamped(rgb.b, largest)};
}

/// An unsigned float of 5 exponent bits, bias 15, and `mantissaBits`: a value at or above 2^-14 has the mantissa's leading 1 left out,
/// one below has the exponent 0. Rounded to the nearest, halves to even; rounding up into the next exponent comes out right, since that
/// follows the largest mantissa. By the bits of the float, as functions of the library for each texel would be most of an export's time.
std::uint32_t packSmallFloat(float value, int mantissaBits)
{
    const int dropped = 23 - mantissaBits;
    const float largest = std::bit_cast<float>(0x477fffffu >> dropped << dropped); // all of the mantissa's bits set, exponent 15
    const float v = clamped(value, largest);
    if (v < 0x1p-14f)
        return static_cast<std::uint32_t>(std::lrint(v * static_cast<float>(1 << (14 + mantissaBits))));
    const auto bits = std::bit_cast<std::uint32_t>(v);
    const std::uint32_t rounded = bits + (1u << (dropped - 1)) - 1u + (bits >> dropped & 1u);
    return (rounded >> dropped) - (112u << mantissaBits); // 127 - 15
}

float unpackSmallFloat(std::uint32_t bits, int mantissaBits)
{
    const std::uint32_t mantissa = bits & ((1u << mantissaBits) - 1u), exponent = bits >> mantissaBits & 31u;
    const float fraction = std::ldexp(static_cast<float>(mantissa), -mantissaBits);
    if (exponent == 31)
        return mantissa == 0 ? HUGE_VALF : NAN;
    return exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1.0f + fraction, static_cast<int>(exponent) - 15);
}

std::uint8_t byteOf(float value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f)); }
std::uint8_t roundedByte(float value) { return byteOf(value + 0.5f); }

Rgba8 packRgbe(const glm::vec3& rgb)
{
    const glm::vec3 v = clamped(rgb, 0x1.FEp126f);
    const float brightest = std::max({v.r, v.g, v.b});
    if (brightest < 0x1p-128f)
        return {};
    int exponent = 0;
    std::frexp(brightest, &exponent);
    float scale = std::ldexp(1.0f, 8 - exponent);
    if (brightest * scale >= 255.5f) {
        ++exponent;
        scale *= 0.5f;
    }
    return {roundedByte(v.r * scale), roundedByte(v.g * scale), roundedByte(v.b * scale), static_cast<std::uint8_t>(exponent + 128)};
}

/// roundedByte(255 v^(1/2.2)) of v in [0, 1], to the bit: the function goes up, so where each byte begins tells it. A power for each
/// channel of each texel would be most of what an environment costs to write.
class GammaBytes {
public:
    GammaBytes()
    {
        m_begins[0] = 0.0f;
        for (unsigned byte = 1; byte < m_begins.size() - 1; ++byte) { // bisected over the bits of floats
            std::uint32_t below = 0, at = std::bit_cast<std::uint32_t>(1.0f);
            while (at - below > 1) {
                const std::uint32_t middle = below + (at - below) / 2;
                (byPower(std::bit_cast<float>(middle)) < byte ? below : at) = middle;
            }
            m_begins[byte] = std::bit_cast<float>(at);
        }
        m_begins.back() = HUGE_VALF;
        for (std::uint32_t cell = 0; cell < m_first.size(); ++cell)
            m_first[cell] = byPower(std::bit_cast<float>(cell << cellBits));
    }
    std::uint8_t operator()(float v) const
    {
        std::uint8_t byte = m_first[std::bit_cast<std::uint32_t>(v) >> cellBits];
        while (v >= m_begins[byte + 1u])
            ++byte;
        return byte;
    }

private:
    static constexpr int cellBits = 16; ///< of the mantissa that a cell spans: at most two bytes begin within it
    static std::uint8_t byPower(float v) { return roundedByte(255.0f * std::pow(v, 1.0f / 2.2f)); }

    std::array<float, 257> m_begins{};                                 ///< the least v of each byte
    std::array<std::uint8_t, (0x3f800000u >> cellBits) + 1> m_first{}; ///< of the least v of each cell
};

/// Babylon's own encoder chooses the multiplier down to a whole number over 255, so that the brightest channel stays below 1.
Rgba8 packRgbd(const glm::vec3& rgb)
{
    static const GammaBytes gammaByte;
    const glm::vec3 v = clamped(rgb, 255.0f);
    const float brightest = std::max({v.r, v.g, v.b});
    const float d = brightest > 0.0f ? std::clamp(std::floor(255.0f / brightest), 1.0f, 255.0f) : 255.0f;
    Rgba8 texel{0, 0, 0, static_cast<std::uint8_t>(d)};
    for (int c = 0; c < 3; ++c)
        texel[static_cast<size_t>(c)] = gammaByte(std::min(v[c] * d / 255.0f, 1.0f));
    return texel;
}

/// Multiplier up to 8 over square roots: `scale` of an alpha that is never too small for the brightest channel.
Rgba8 packRoots(const glm::vec3& roots, float scale, std::uint8_t alpha)
{
    Rgba8 texel{0, 0, 0, alpha};
    for (int c = 0; c < 3; ++c)
        texel[static_cast<size_t>(c)] = scale > 0.0f ? roundedByte(255.0f * roots[c] / scale) : std::uint8_t{0};
    return texel;
}

} // namespace

std::uint16_t packHalf(float value)
{
    if (std::isnan(value))
        return 0;
    return Imath::half(std::clamp(value, -65504.0f, 65504.0f)).bits();
}

float unpackHalf(std::uint16_t bits)
{
    Imath::half value;
    value.setBits(bits);
    return value;
}

std::uint32_t packR11G11B10(const glm::vec3& rgb)
{
    return packSmallFloat(rgb.r, 6) | packSmallFloat(rgb.g, 6) << 11 | packSmallFloat(rgb.b, 5) << 22;
}

glm::vec3 unpackR11G11B10(std::uint32_t bits)
{
    return {unpackSmallFloat(bits & 0x7ffu, 6), unpackSmallFloat(bits >> 11 & 0x7ffu, 6), unpackSmallFloat(bits >> 22, 5)};
}

std::uint32_t packE5B9G9R9(const glm::vec3& rgb)
{
    const glm::vec3 v = clamped(rgb, 65408.0f); // 511/512 2^16
    const float brightest = std::max({v.r, v.g, v.b});
    int exponent = 0;
    std::frexp(brightest, &exponent); // brightest < 2^exponent
    exponent = std::max(exponent, -15);
    if (std::lrint(std::ldexp(brightest, 9 - exponent)) == 512)
        ++exponent;
    const auto mantissa = [&](float value) { return static_cast<std::uint32_t>(std::lrint(std::ldexp(value, 9 - exponent))); };
    return mantissa(v.r) | mantissa(v.g) << 9 | mantissa(v.b) << 18 | static_cast<std::uint32_t>(exponent + 15) << 27;
}

glm::vec3 unpackE5B9G9R9(std::uint32_t bits)
{
    const float scale = std::ldexp(1.0f, static_cast<int>(bits >> 27) - 24);
    return scale * glm::vec3(static_cast<float>(bits & 511u), static_cast<float>(bits >> 9 & 511u), static_cast<float>(bits >> 18 & 511u));
}

float largestValue(PackedColor form)
{
    switch (form) {
    case PackedColor::Rgbe:
        return 0x1.FEp126f;
    case PackedColor::Rgbd:
        return 255.0f;
    default:
        return 64.0f;
    }
}

std::span<const std::string_view> words(PackedColor)
{
    static constexpr std::array<std::string_view, 4> all{"rgbe", "rgbm", "rgbd", "rgbp"};
    return all;
}

Rgba8 packColor(PackedColor form, const glm::vec3& rgb)
{
    if (form == PackedColor::Rgbe)
        return packRgbe(rgb);
    if (form == PackedColor::Rgbd)
        return packRgbd(rgb);
    const glm::vec3 roots = glm::sqrt(clamped(rgb, 64.0f));
    const float brightest = std::max({roots.r, roots.g, roots.b});
    if (form == PackedColor::Rgbm) {
        const std::uint8_t alpha = byteOf(std::ceil(255.0f * brightest / 8.0f));
        return packRoots(roots, 8.0f * static_cast<float>(alpha) / 255.0f, alpha);
    }
    // The multiplier lies in [1, 8]; rounding its byte up would make it smaller than the brightest root asks for.
    const std::uint8_t alpha = byteOf(std::floor(255.0f * (1.0f - (std::max(brightest, 1.0f) - 1.0f) / 7.0f)));
    return packRoots(roots, 8.0f - 7.0f * static_cast<float>(alpha) / 255.0f, alpha);
}

glm::vec3 unpackColor(PackedColor form, const Rgba8& texel)
{
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> powers{};
        for (size_t byte = 0; byte < powers.size(); ++byte)
            powers[byte] = std::pow(static_cast<float>(byte) / 255.0f, 2.2f);
        return powers;
    }();
    const glm::vec3 rgb(texel[0], texel[1], texel[2]);
    const float alpha = static_cast<float>(texel[3]) / 255.0f;
    switch (form) {
    case PackedColor::Rgbe:
        return texel[3] == 0 ? glm::vec3(0.0f) : rgb * std::ldexp(1.0f, texel[3] - 136);
    case PackedColor::Rgbd:
        return glm::vec3(linear[texel[0]], linear[texel[1]], linear[texel[2]]) / std::max(alpha, 1.0f / 255.0f);
    case PackedColor::Rgbm:
        return glm::pow(rgb / 255.0f * 8.0f * alpha, glm::vec3(2.0f));
    default:
        return glm::pow(rgb / 255.0f * (8.0f - 7.0f * alpha), glm::vec3(2.0f));
    }
}

} // namespace mirrorball
