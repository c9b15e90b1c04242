#pragma once

#include "spectrum.h"

#include <array>
#include <span>
#include <vector>

namespace mirrorball {

/// A place on the sphere in the spectrum's angles.
struct SpherePoint {
    double azimuth;    ///< along the rows of a latlong map, 2 pi u, in [0, 2 pi]
    double colatitude; ///< from +Y, in [0, pi]
};

/// A band-limited function on the sphere, held on rings and read at any direction: how a filtered spectrum reaches the maps whose
/// texels do not lie on rings (cube, paraboloid, octahedral, discs).
///
/// The function is synthesized on N rings of 2N samples and interpolated by a quintic B-spline, exactly through the samples: along the
/// azimuth the spline's prefilter is a factor per order m, 120/(66 + 52 cos w + 2 cos 2w) with w = 2 pi m / 2N; along the meridians it is
/// the spline's recursive filter, run over whole great circles so that the poles are no ends. Of a harmonic of degree l the
/// interpolation lets aliases of about (x/(1-x))^6 through, x = l/2N.
/// Source: M. Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16(6), 1999, eqs. 10-13.
class RingGrid {
public:
    /// Rings that keep the interpolation error below `tolerance` (rel_rms), for a function whose degrees hold these shares of its power
    /// (0 .. band limit); at least one more than the band limit, a length FFTs like.
    static int ringsFor(const std::vector<double>& share, double tolerance);

    /// Share of a degree's power that the interpolation gets wrong, at most.
    static double leakage(int degree, int rings);
    /// Rings that hold a function of this band limit, a length FFTs like: at least one more than it.
    static int leastRings(int bandLimit);

    /// That error for a number of rings, at most.
    static double interpolationError(const std::vector<double>& share, int rings);

    /// @param yaw radians, as yawed(): the function is turned about +Y
    /// @param longer  k followed further, for the norm; empty: k
    RingGrid(const Spectrum& spectrum, const std::vector<double>& k, int rings, double yaw, const JobControl& job = {},
             const std::vector<double>& longer = {});

    /// The reference sum's numerators (what was taken out of the probe apart) and its denominator less 1 at many places, 4 floats each.
    void read(std::span<const SpherePoint> points, float* rgbn) const;

    /// The same, but for roundings, at rows [first, last) of the four sides of a cube map of size x size texels, +X, -X, +Z and -Z one
    /// after the other. A column of a side lies on one meridian: what the rings give there is found once for all its texels, each of which
    /// then takes 6 samples in place of 36; and the sides share their colatitudes.
    /// @param points  spherePoints() of the whole cube
    void readSides(int size, int first, int last, std::span<const SpherePoint> points, float* rgbn) const;

private:
    int m_rings;
    int m_stride; ///< samples a row of m_texels, halo included
    std::vector<float>
        m_texels; ///< spline coefficients of RGB and the norm less 1, or what of it is not zonal, with a halo so that no tap needs wrapping
    /// A function of the colatitude as cubics on even intervals from pole to pole, in rising powers of the place within one.
    using Line = std::vector<std::array<float, 4>>;
    /// The zonal norm less 1, empty where the rings hold it as well; and that part of it that lies beyond their band limit, which the
    /// numerators of RGB have times the mean, empty where none does. What a float does not tell beside 1 counts as none.
    Line m_zonal, m_zonalBeyond;
    glm::vec3 m_mean{0.0f};
};

/// The places of a layout's texels on the sphere, row by row: worth keeping when several lobes are read off in the same layout.
std::vector<SpherePoint> spherePoints(const MapLayout& layout, const JobControl& job = {});

} // namespace mirrorball
