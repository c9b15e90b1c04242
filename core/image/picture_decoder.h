#pragma once

#include "color_space.h"
#include "probe_reading.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// From what integer formats store to linear light. Compiled into the module that reads foreign formats, since ICC profiles come from
/// there.
namespace mirrorball {

/// What a file says of its colors. What it does not say is empty.
struct StoredColors {
    std::string format{};                           ///< "png", "jpeg", ...
    bool isInteger = true;                          ///< samples are 0 to 1
    bool isBytes = false;                           ///< of 256 levels
    bool isSrgb = false;                            ///< it says so
    bool isLinear = false;                          ///< it says so
    std::string saysSo{};                           ///< what does: "the sRGB chunk", "Exif"
    std::optional<double> exponent{};               ///< light = stored^exponent; PNG: 1/gAMA
    std::optional<Chromaticities> primaries{};      ///< PNG: cHRM
    std::optional<std::array<int, 2>> codePoints{}; ///< PNG: cICP's primaries and transfer, as in ITU-T H.273
    std::vector<unsigned char> iccProfile{};
    int channels = 3; ///< color channels: 1 or 3
};

class IccTransform;

/// Turns stored colors into linear Rec.709. In this order: cICP, the ICC profile, sRGB, gAMA and cHRM, Exif; else sRGB for integers and
/// linear for floats. What cannot be used is a note, and the next is taken. Source: PNG, third edition, section 4.3, for the order.
class PictureDecoder {
public:
    explicit PictureDecoder(const StoredColors& said);
    ~PictureDecoder();
    PictureDecoder(const PictureDecoder&) = delete;
    PictureDecoder& operator=(const PictureDecoder&) = delete;

    /// In place, three floats a texel.
    void toLinear(float* rgb, size_t texels) const;
    const Assumption& assumption() const { return m_assumption; }
    const std::vector<std::string>& notes() const { return m_notes; }

private:
    bool takeCodePoints(const StoredColors& said);
    bool takeProfile(const StoredColors& said);
    void take(ColorSpace space, std::string why, Certainty certainty);

    ColorSpace m_space{};
    std::optional<glm::mat3> m_toRec709{};
    bool m_isBytes = false;
    std::array<float, 256> m_lightOfByte{};
    std::unique_ptr<IccTransform> m_profile{};
    Assumption m_assumption{};
    std::vector<std::string> m_notes{};
};

} // namespace mirrorball
