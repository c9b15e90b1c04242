#pragma once

#include "brdf.h"

#include "core/image/image.h"

/// A BRDF as a disc, to look at and to lay over a reflection.
namespace mirrorball {

/// As a sphere map looked up by the normal, which reflects what lies in the mirror direction: f(r, v) at the normal (x, y, sqrt(1 - x^2 -
/// y^2)) of an orthographic eye along +Z. Of Cook and Torrance's model h is the normal, so that D is that of its peak and G = 1:
///   R = F D(1)/(pi (n.v)^2),
/// nearly black in front, and the color of F at grazing. Of a measurement the strongest value within 15 degrees of the mirror direction in
/// the plane of incidence, channel by channel. All of it is divided by the largest channel at 80 degrees of incidence, beyond which it
/// stays as it is there: the map is then a factor of at most about 1. Outside the disc 0. Source: 003 section 7.1.1, eqs. 6 to 8, and
/// section 8.3, "the strongest reflected energy"
/// @param size  texels of its edge, 1 to 4096. @throws InvalidArgument
Image mirrorReflectanceMap(const Brdf& brdf, int size);

/// What goes where: f for light at `incidence`, over the hemisphere of views seen from above, its directions projected on the plane of the
/// surface; the light comes from the left. Outside the disc 0. Source: 003 figure 25
/// @param incidence  radians in [0, pi/2)
Image hemisphereMap(const Brdf& brdf, double incidence, int size);

/// Numbers as colors, for a display: the mean of the channels from 0 to its 99.5th percentile by falseColor(), white outside the disc.
Image falseColored(const Image& disc);

} // namespace mirrorball
