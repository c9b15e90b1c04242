#pragma once

#include "paraboloid.h"

#include <functional>
#include <optional>
#include <vector>

/// The exact paraboloid method's sums in very many directions from those in fewer: what a lobe has smoothed is read between points of a
/// lattice.
namespace mirrorball {

/// Points in the planes of both halves, `perTexel` of them along the edge of a texel of the halves.
class ParaboloidLattice {
public:
    /// @param radius    of a half's disc, in texels
    ParaboloidLattice(double radius, int perTexel);

    /// Where sums are needed, of both halves.
    const std::vector<glm::dvec3>& directions() const { return m_directions; }
    /// Reads between the sums at directions() by Lagrange interpolation over eight points each way: for a smooth lobe its error is far
    /// below that of the cubics by which the probe was spread over the halves, whose points lie `perTexel` times as far apart.
    std::vector<glm::vec3> read(std::span<const glm::vec3> sums, std::span<const glm::dvec3> directions, const JobControl& job = {}) const;

private:
    double m_step;                  ///< between points, in radii of the disc
    int m_reach;                    ///< points from the middle of a half to its last
    std::vector<size_t> m_places{}; ///< of directions() in a square of both halves
    std::vector<glm::dvec3> m_directions{};
};

/// Points in both halves, about.
double latticePoints(double radius, int perTexel);

/// Points along a texel's edge with which a lattice serves so many directions at a fraction of the sums; 0: it does not, as latticeFor()
/// says.
/// @param reach   angle at which the lobe is clamped
/// @param radius  of a half's disc, in texels
int latticeDensity(const Lobe& lobe, double reach, double radius, double directions);

/// The lattice that serves so many directions at a fraction of the sums; nothing where they are too few, or where the lobe's end is no
/// smooth one: at a horizon, a clamp above 0.01, or of a table.
std::optional<ParaboloidLattice> latticeFor(const ParaboloidHalves& halves, size_t directions);

/// Sums in a list of directions, as ParaboloidDevice::sum() and paraboloidSum() give them.
using ParaboloidSums = std::function<std::vector<glm::vec3>(std::span<const glm::dvec3> directions)>;

/// Sums in each direction: on a lattice where latticeFor() has one, otherwise one by one.
std::vector<glm::vec3> paraboloidSums(const ParaboloidHalves& halves, std::span<const glm::dvec3> directions, const ParaboloidSums& sums,
                                      const JobControl& job = {});

} // namespace mirrorball
