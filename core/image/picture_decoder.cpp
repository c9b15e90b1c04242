#include "picture_decoder.h"

#include "icc_transform.h"
#include "input_checks.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mirrorball {

namespace {

std::string numberText(double value)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(4);
    text << value;
    return text.str();
}

/// Of ITU-T H.273, the code points that still pictures come with.
std::optional<ColorSpace> spaceOf(int primaries, int transfer)
{
    const char* known = primaries == 1 ? "linear" : primaries == 9 ? "rec2020" : primaries == 12 ? "linear-p3" : nullptr;
    if (!known)
        return std::nullopt;
    ColorSpace space = *colorSpaceFromName(known);
    if (transfer == 13 || transfer == 1 || transfer == 6 || transfer == 14 || transfer == 15)
        space.curve = TransferCurve::Srgb;
    else if (transfer == 4 || transfer == 5)
        space = {.curve = TransferCurve::Power, .exponent = transfer == 4 ? 2.2 : 2.8, .primaries = space.primaries};
    else if (transfer != 8)
        return std::nullopt;
    return space;
}

std::string describe(const ColorSpace& space, bool converts)
{
    std::string text = space.curve == TransferCurve::Linear ? "linear"
                       : space.curve == TransferCurve::Srgb ? "sRGB"
                                                            : "gamma " + numberText(space.exponent);
    return text + (converts ? ", brought to Rec.709 from the file's primaries" : ", Rec.709 primaries");
}

} // namespace

PictureDecoder::PictureDecoder(const StoredColors& said) : m_isBytes(said.isBytes)
{
    if (!(said.codePoints && takeCodePoints(said)) && !(!said.iccProfile.empty() && takeProfile(said))) {
        ColorSpace space;
        space.primaries = said.primaries.value_or(Chromaticities{});
        if (said.isSrgb) {
            space = *colorSpaceFromName("srgb");
            take(space, said.saysSo, Certainty::Certain);
        } else if (said.exponent) {
            space.curve = std::abs(*said.exponent - 1.0) < 1e-3 ? TransferCurve::Linear : TransferCurve::Power;
            space.exponent = *said.exponent;
            take(space, said.saysSo, Certainty::Certain);
        } else if (said.isLinear || !said.isInteger) {
            take(space, said.isLinear ? said.saysSo : "floats without a word about it",
                 said.isLinear ? Certainty::Certain : Certainty::Likely);
        } else {
            space.curve = TransferCurve::Srgb;
            take(space, "integers without a word about it come from displays and cameras", Certainty::Likely);
        }
    }
    for (size_t i = 0; i < m_lightOfByte.size(); ++i)
        m_lightOfByte[i] = toLight(static_cast<float>(i) / 255.0f, m_space);
}

PictureDecoder::~PictureDecoder() = default;

void PictureDecoder::take(ColorSpace space, std::string why, Certainty certainty)
{
    try {
        m_toRec709 = primariesToRec709(space);
    } catch (const InvalidArgument& error) {
        m_notes.push_back("its primaries are not used: " + oneLine(error.what()));
        space.primaries = {};
    }
    m_assumption = {"encoding", describe(space, m_toRec709.has_value()), std::move(why), certainty};
    m_space = std::move(space);
}

bool PictureDecoder::takeCodePoints(const StoredColors& said)
{
    const auto [primaries, transfer] = *said.codePoints;
    const auto space = spaceOf(primaries, transfer);
    if (space)
        take(*space, "the cICP chunk", Certainty::Certain);
    else
        m_notes.push_back("its cICP chunk names primaries " + std::to_string(primaries) + " and transfer " + std::to_string(transfer) +
                          ", which are not known here");
    return space.has_value();
}

bool PictureDecoder::takeProfile(const StoredColors& said)
{
    m_profile = IccTransform::open(said.iccProfile, said.channels);
    if (!m_profile) {
        m_notes.push_back("its ICC profile is damaged or not for its channels, and not used");
        return false;
    }
    m_assumption = {"encoding", "ICC profile " + oneLine(m_profile->name()) + ", brought to linear Rec.709", "the ICC profile in the file"};
    return true;
}

void PictureDecoder::toLinear(float* rgb, size_t texels) const
{
    if (m_profile) {
        m_profile->toLinear(rgb, texels);
        return;
    }
    if (m_space.curve != TransferCurve::Linear)
        for (size_t i = 0; i < 3 * texels; ++i)
            rgb[i] = m_isBytes ? m_lightOfByte[toByte(rgb[i])] : toLight(rgb[i], m_space);
    if (!m_toRec709)
        return;
    for (size_t i = 0; i < texels; ++i, rgb += 3) {
        const glm::vec3 color = *m_toRec709 * glm::vec3(rgb[0], rgb[1], rgb[2]);
        std::copy_n(&color.x, 3, rgb);
    }
}

} // namespace mirrorball
