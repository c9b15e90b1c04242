#pragma once

#include "error_metrics.h"

#include "core/base/job.h"
#include "core/filter/filter_source.h"
#include "core/filter/lobe.h"

#include <glm/glm.hpp>

#include <span>
#include <string>
#include <vector>

namespace mirrorball {

/// Directions that lie evenly on the sphere, each for the same solid angle: the Fibonacci lattice. Source: R. Swinbank and R. Purser,
/// Fibonacci grids, Q. J. R. Meteorol. Soc. 132 (2006), eq. 1.
std::vector<glm::dvec3> evenDirections(int count);

/// The reference sum (reference.h); of a lobe that is unresolved by the probe (lobe.h), or of a mirror, the bilinear lookup. @throws
/// Cancelled
std::vector<glm::dvec3> referenceAt(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                    const JobControl& job = {});

/// The reference at some texels of a map, for the error of maps whose whole reference sum would take minutes.
struct ReferenceSamples {
    std::vector<Texel> texels{};
    std::vector<glm::dvec3> values{};
    /// Steradians that each stands for. 0: only the largest error looks at it (around the brightest direction, at poles and corners)
    std::vector<double> weights{};
    bool complete = false; ///< every texel of the map
    double seconds = 0.0;  ///< what the sum took

    int weighted() const; ///< texels with a weight
};

/// referenceAt() those texels of `target` that hold `count` even directions, each once, or at all of them when there are no more.
/// @throws InvalidArgument for a streamed probe; Cancelled
ReferenceSamples referenceSamples(const FilterSource& source, const Lobe& lobe, const MapLayout& target, int count, const JobControl& job);

/// Error of a map of that layout at the samples. maxAbs counts the unweighted ones too.
ErrorMetrics errorAt(const ReferenceSamples& reference, const EnvironmentMap& map);

/// A map that stands in for the reference where all of its texels are looked at.
struct ExactMap {
    EnvironmentMap map{};
    std::string how{}; ///< "spectral at tolerance 1e-6"
};

/// What the spectral method makes of the probe at the tightest tolerance from 1e-6 that it can promise, by tens.
/// @throws InvalidArgument where that is none up to 1e-3; Cancelled
ExactMap mostExactMap(FilterSource& source, const Lobe& lobe, const MapLayout& target, const JobControl& job = {});

} // namespace mirrorball
