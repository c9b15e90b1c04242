#pragma once

#include "picture_fit.h"

#include <optional>

namespace mirrorball {

/// The outline of a mirror ball in a photograph: the circle along which brightness changes most, in the mean of the logarithm's slope
/// across it, each place counted no more than a good edge. Found coarsely in a small picture, then followed to a quarter of a texel. Empty
/// where no circle stands out: its slope is less than three times that of circles at large.
std::optional<Circle> findBall(const Image& picture);

} // namespace mirrorball
