#pragma once

#include "core/spheremap/math/texel_rect.h"

#include "core/base/job.h"
#include "core/image/image.h"

#include <functional>

namespace mirrorball {

/// A layer that changes what lies below it as a whole picture (blur, twist, rotate), made ready. Pictures are RGBA, multiplied by their
/// opacity, and cover a rectangle of the map.
struct Warp {
    /// What it reads to make `wanted`.
    std::function<TexelRect(const TexelRect& wanted)> needs{};
    /// What it may change when `touched` changes below it.
    std::function<TexelRect(const TexelRect& touched)> reaches{};
    /// @param below  the picture over `given`, which holds needs(wanted)
    /// @return the picture over `wanted`
    std::function<Image(const Image& below, const TexelRect& given, const TexelRect& wanted, const JobControl& job)> apply{};
};

} // namespace mirrorball
