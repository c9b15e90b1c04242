#include "icc_transform.h"

#include <lcms2.h>

#include <algorithm>
#include <array>

namespace mirrorball {

namespace {

struct Closing {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, Closing>;

Profile linearRec709()
{
    const cmsCIExyY white{0.3127, 0.3290, 1.0};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
    cmsToneCurve* const linear = cmsBuildGamma(nullptr, 1.0);
    cmsToneCurve* curves[3]{linear, linear, linear};
    Profile profile(cmsCreateRGBProfile(&white, &primaries, curves));
    cmsFreeToneCurve(linear);
    return profile;
}

std::string descriptionOf(void* profile)
{
    std::array<char, 128> text{};
    cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", text.data(), static_cast<cmsUInt32Number>(text.size() - 1));
    return text.data();
}

} // namespace

std::unique_ptr<IccTransform> IccTransform::open(const std::vector<unsigned char>& bytes, int channels)
{
    cmsSetLogErrorHandler(nullptr); // says nothing
    const Profile profile(cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
    const cmsColorSpaceSignature wanted = channels == 1 ? cmsSigGrayData : cmsSigRgbData;
    if (!profile || cmsGetColorSpace(profile.get()) != wanted)
        return nullptr;
    const Profile target = linearRec709();
    void* const transform = cmsCreateTransform(profile.get(), channels == 1 ? TYPE_GRAY_FLT : TYPE_RGB_FLT, target.get(), TYPE_RGB_FLT,
                                               INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE);
    if (!transform)
        return nullptr;
    return std::unique_ptr<IccTransform>(new IccTransform(transform, channels, descriptionOf(profile.get())));
}

IccTransform::~IccTransform() { cmsDeleteTransform(m_transform); }

void IccTransform::toLinear(float* rgb, size_t texels) const
{
    constexpr size_t block = 4096;
    std::array<float, 3 * block> in{};
    for (size_t done = 0; done < texels; done += block) {
        const size_t count = std::min(block, texels - done);
        float* const out = rgb + 3 * done;
        if (m_channels == 1)
            for (size_t i = 0; i < count; ++i)
                in[i] = out[3 * i];
        else
            std::copy_n(out, 3 * count, in.data());
        cmsDoTransform(m_transform, in.data(), out, static_cast<cmsUInt32Number>(count));
    }
}

} // namespace mirrorball
