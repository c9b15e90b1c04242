#pragma once

#include "brdf_stack.h"

#include <array>

namespace mirrorball {

/// View-dependent sphere maps: of what a BRDF reflects to any view only the maps of a few views are made; one for a view between three of
/// them is each of these warped as a mirror would have it - looked up where its own view mirrors the same direction r - and their mean by
/// nearness. What is lost is how the lobe about r changes from view to view.
/// Source: Cabral, Olano and Nemec, "Reflection Space Image Based Rendering", SIGGRAPH 99; 000 section 3.2.4, figure 11

/// The three source views, as they see a surface that mirrors the wanted view to r: their directions lie at `distance` from the wanted one,
/// a third of a turn apart about it, the first away from r in the plane of incidence. The wanted view is as far from each as it can be, so
/// each counts a third.
/// @param distance  radians, at least 0 and less than pi - 2 wanted.view, beyond which a source looks from where r goes
/// @throws InvalidArgument
std::array<SurfaceView, 3> warpSources(const SurfaceView& wanted, double distance);

/// The map of reflected radiance by that method, as filterBrdfStack() has it; the sources' maps are exact to the tolerance.
EnvironmentMap filterBrdfWarped(FilterSource& source, const Brdf& brdf, const SurfaceView& seen, double distance, const MapLayout& target,
                                double yaw, double tolerance, const JobControl& job = {});

} // namespace mirrorball
