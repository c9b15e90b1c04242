#pragma once

#include "core/image/image.h"
#include "core/shading/measured_brdf.h"

namespace mirrorball {

/// Where a BRDF was measured for light of one direction: the views as dots on the half of the hemisphere that they lie in, seen from aside,
/// bright where much is reflected (logarithmic, over four decades), the light's ray and the mirror direction. What is measured on one side
/// of the plane of incidence stands for the other. Source: 003 figure 24
/// @param incidence  radians in [0, pi/2): the nearest of the measurement's own is shown, and named in the picture
/// @param size       of the edge, 200 to 4096
/// @return RGB as displayed. @throws InvalidArgument for a size out of range, and for a measurement of a grid, which has no gaps to show
Image measuredDomainPicture(const MeasuredBrdf& brdf, double incidence, int size);

} // namespace mirrorball
