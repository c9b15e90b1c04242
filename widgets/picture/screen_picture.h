#pragma once

#include "core/base/job.h"
#include "core/image/image.h"
#include "core/spheremap/math/texel_rect.h"

#include <QImage>

#include <vector>

namespace mirrorball::studio {

/// A sphere map, RGBA multiplied by its opacity, as the screen shows it (sRGB, Format_ARGB32_Premultiplied).
QImage onScreen(const Image& map, const JobControl& job = {});

/// A sphere map for the screen with its halvings, so that drawing it small neither aliases nor reads all of it.
class ScreenPicture {
public:
    bool isNull() const { return m_levels.empty(); }
    int size() const { return m_levels.empty() ? 0 : m_levels.front().width(); }
    /// Puts a part of a map of size x size where it belongs.
    void put(const QImage& part, const TexelRect& at, int size);
    /// What to draw at so many device pixels across: never less, where there is more.
    const QImage& forPixels(double pixels) const;

private:
    std::vector<QImage> m_levels{}; ///< largest first
};

} // namespace mirrorball::studio
