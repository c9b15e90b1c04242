#pragma once

#include "brdf_lookups.h"
#include "lookup_choice.h"

#include "core/base/job.h"
#include "core/image/image.h"

namespace mirrorball {

/// A material's lookups as a float texture: what an engine reads in place of the split sum's (A, B).
///
/// N columns, n.v = (i + 1/2)/N; two rows a lookup, 2 K in all:
///   row 2k      R the offset in radians (brdf_lookups.h), G alpha, B the turn out of the plane of incidence in radians
///   row 2k + 1  RGB the weight
/// Between columns all of it is linear; the weights of a column add up to the directional albedo there. Neighboring columns are fitted one
/// from the other, so that an entry keeps its part of the lobe. Shader twin: resources/shaders/lib/brdf_lookups.glsl.
/// Of what an engine does (engine_lookups.h) K is 1, for three 2, and nothing is fitted.
/// @param size  N; 0: 32
/// @throws InvalidArgument; Cancelled
Image makeLookupTable(const Brdf& brdf, const LookupChoice& choice, int size, const JobControl& job = {});

/// The lookups of one view. @throws InvalidArgument for LookupKind::Exact
LookupFit lookupsFor(const Brdf& brdf, double view, const LookupChoice& choice);

/// The table read at a view, as the shader reads it. @param view  radians in [0, pi/2)
LookupFit lookupsAt(const Image& table, double view);

} // namespace mirrorball
