#pragma once

#include "core/base/job.h"
#include "core/image/image.h"

namespace mirrorball {

/// How far one display picture is from another: what people see on a screen, not radiance.
struct PictureError {
    double relRms = 0.0; ///< rms(E - R) / rms(R) over red, green and blue together; 0 where both are 0
    double psnr = 0.0;   ///< dB: 10 log10(1 / mean((E - R)^2)) over the same; infinite for equal pictures
    /// Mean structural similarity of the luma, at most 1 and 1 for equal pictures only:
    ///   (2 m_E m_R + C1) (2 s_ER + C2) / ((m_E^2 + m_R^2 + C1) (s_E^2 + s_R^2 + C2)), C1 = 0.01^2, C2 = 0.03^2
    /// with means, variances and covariance under a Gaussian window of 11 x 11 pixels and sigma 1.5, the mean taken over all windows that
    /// lie inside of the picture.
    double ssim = 1.0;
    bool operator==(const PictureError&) const = default;
};

inline constexpr int ssimWindow = 11; ///< pixels

/// @param picture, reference  display values: sRGB-encoded, data range [0, 1]; of four channels the opacity is not looked at
/// @throws InvalidArgument for two sizes, for less than three channels, for an edge below ssimWindow; Cancelled
/// Source: Wang, Bovik, Sheikh and Simoncelli, Image Quality Assessment, IEEE TIP 13(4), 2004, eq. 13; luma: ITU-R BT.709-6, item 3.2
PictureError pictureError(const Image& picture, const Image& reference, const JobControl& job = {});

} // namespace mirrorball
