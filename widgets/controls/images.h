#pragma once

#include "core/image/image.h"

#include <QImage>

namespace mirrorball::studio {

/// A display picture of core (RGB or RGBA in [0, 1], sRGB) as Qt paints it.
QImage toQImage(const Image& picture);

} // namespace mirrorball::studio
