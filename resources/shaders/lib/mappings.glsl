#pragma once
// Every mapping. Each has these, named after its row in core/sphere/mapping.h, here for the latlong:
//   vec3 latlongCoordinate(vec3 d, float size, float border)    xy: image position in its chart, texels; z: the chart
//   float latlongTexelAngle(vec3 d, float size, float border)   angle that a texel there spans
//   Seam latlongSeam(vec3 d)                                    the nearest seam
// d is a unit vector. The cube has no Coordinate: its faces are the hardware's.
#include "lib/seams.glsl"
#include "lib/angular_map.glsl"
#include "lib/cube_map.glsl"
#include "lib/dual_paraboloid.glsl"
#include "lib/latlong.glsl"
#include "lib/octahedral.glsl"
#include "lib/sphere_map.glsl"
