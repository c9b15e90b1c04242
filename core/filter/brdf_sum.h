#pragma once

#include "reflection_frame.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"
#include "core/shading/reflection_kernel.h"

#include <span>
#include <vector>

namespace mirrorball {

/// The reflected radiance by brute force, the truth for every other method: over all texels d_j of a latlong probe with their exact solid
/// angles w_j,
///   L_o = albedo sum_j w_j L_j K(d_j) / sum_j w_j K(d_j),   K = f (n.l),
/// per channel, in double precision: normalized like the reference sum of a lobe (reference.h), so that a constant probe gives the albedo
/// exactly. Texels below the horizon, and those so far from a narrow lobe's peak that K is under 1e-13 of it, are passed over.
class BrdfSum {
public:
    /// @throws InvalidArgument unless the probe is a latlong map
    BrdfSum(const EnvironmentMap& latlong, const Brdf& brdf, double view);

    /// One value a normal. @param normals  unit; the mirror directions stand at `mirrored`, at the angle of view from their normals
    std::vector<glm::dvec3> at(std::span<const glm::dvec3> normals, std::span<const glm::dvec3> mirrored, const JobControl& job = {}) const;

    glm::dvec3 albedo() const { return m_albedo; }

private:
    struct Scratch;
    glm::dvec3 sum(const glm::dvec3& n, const glm::dvec3& r, Scratch& scratch) const;

    ReflectionKernel m_kernel;
    glm::dvec3 m_albedo;
    double m_cosSupport;
    int m_width, m_height;
    std::vector<double> m_texels; ///< [row][channel][column]
    std::vector<double> m_sinLon, m_cosLon, m_sinLat, m_cosLat, m_weight;
};

/// The whole map. @param yaw  radians, as yawed()
EnvironmentMap filterBrdfSum(const EnvironmentMap& latlong, const Brdf& brdf, const SurfaceView& seen, const MapLayout& target, double yaw,
                             const JobControl& job = {});

} // namespace mirrorball
