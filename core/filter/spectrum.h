#pragma once

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

namespace mirrorball {

/// A probe's spherical-harmonic coefficients: one forward transform that many lobes share.
///
///   a_lm = sum_j w_j L_j conj(Y_lm(d_j))
///
/// over the texels of a latlong map with their exact solid angles w_j, in double precision. It is the reference sum in spectral
/// form: the truncated kernel sum_(l<=B) k_l (2l+1)/(4 pi) P_l(r.d) applied to the texels equals sum_lm k_l a_lm Y_lm(r) exactly,
/// whatever the band limit B is beside the map's size. (Colatitude is counted from +Y and azimuth along the rows, 2 pi u. That is
/// a left-handed frame, which radial convolutions cannot tell from a right-handed one.)
struct Spectrum {
    int bandLimit = 0;                                               ///< largest l
    int rings = 0;                                                   ///< rows of the map it was made from
    int ringLength = 0;                                              ///< texels in a row
    std::array<std::vector<std::complex<double>>, 3> coefficients{}; ///< R, G, B; m >= 0 only, at index(l, m)
    std::vector<std::complex<double>> unit{};                        ///< the same sum over a constant 1, which normalizes the filters
    std::vector<double> zonalUnit{};                                 ///< its m = 0, followed at least as far as the rows repeat themselves
    double peak = 0.0;                                               ///< largest |texel| of the map
    double least = 0.0;                                              ///< smallest texel of the map as it was read
    glm::dvec3 secondMoment{0.0};                                    ///< sum_j w_j L_j^2 of each channel: no degrees hold more together

    size_t index(int l, int m) const
    {
        return static_cast<size_t>(m) * static_cast<size_t>(2 * bandLimit + 1 - m) / 2 + static_cast<size_t>(l);
    }

    /// Adds the spectrum of other texels of the same map at the same band limit; `unit` stays. The peak and the least are those of both.
    Spectrum& operator+=(const Spectrum& other);

    /// Power per degree of the map about its mean, sum over m and the channels of |a_lm - mean unit_lm|^2; that of the mean itself at
    /// l = 0. A filter reproduces the mean exactly, so this is what a truncation can lose.
    std::vector<double> powerAboutMean() const;
    /// The same of each channel; [0] is that of the mean itself.
    std::vector<glm::dvec3> channelPowerAboutMean() const;
    /// sum_j w_j (L_j - mean)^2 of each channel: bounds the power of all degrees from 1 to the map's rows together.
    glm::dvec3 varianceAboutMean() const;
};

/// Fills `unit` and `zonalUnit` from the size of the map; of a band limit of a row's length and more, without what repeats along the rows.
void setUnit(Spectrum& spectrum);

/// Rows [first, end) of a map.
struct RowRange {
    int first = 0, end = 0;
    bool operator==(const RowRange&) const = default;
};

/// Builds a Spectrum from rows that arrive one block after the other, so that a probe of any size streams through: each row is
/// Fourier transformed, truncated to |m| <= bandLimit and kept at just the length that holds those. That is exact, not a
/// reduction. Memory: about 48 (bandLimit + 1) bytes a row, whatever the row's length.
class SpectrumBuilder {
public:
    SpectrumBuilder(int width, int height, int bandLimit) : SpectrumBuilder(width, height, bandLimit, {0, height}) {}
    /// The same of some rows only: the others count as black, and take no memory. `unit` is that of all rows.
    SpectrumBuilder(int width, int height, int bandLimit, RowRange rows);
    ~SpectrumBuilder();
    SpectrumBuilder(const SpectrumBuilder&) = delete;
    SpectrumBuilder& operator=(const SpectrumBuilder&) = delete;

    int width() const { return m_width; }
    int height() const { return m_height; }

    /// Rows [firstRow, firstRow + rows) of a center-sampled latlong map, 3 floats a texel, finite.
    void addRows(int firstRow, int rows, const float* rgb, const JobControl& job = {});
    /// Another radiance for the texel (x, y) of a row that was added: as if the row had come with it.
    /// @param before  what it came with
    void replace(int x, int y, const glm::dvec3& before, const glm::dvec3& radiance);
    /// The transform along the meridians. Every row of the range must have been added. The rows stay, so that it may be called again after
    /// replace().
    Spectrum finish(const JobControl& job = {});

private:
    struct Plans;
    struct Dirichlet;
    int m_width, m_height, m_bandLimit;
    RowRange m_range;
    int m_keptLength; ///< samples kept of each row: all of them where the band limit asks for it
    double m_peak = 0.0, m_least = HUGE_VAL;
    std::vector<glm::dvec3> m_rowSquares; ///< sum of L^2 over each row; their total does not depend on the threads
    std::array<std::vector<double>, 3> m_rows{};
    std::unique_ptr<Plans> m_plans;
    std::unique_ptr<Dirichlet> m_dirichlet; ///< made by the first replace() of a truncated row
};

/// The spectrum of a latlong map in memory. @throws InvalidArgument for another parameterization
Spectrum analyze(const EnvironmentMap& latlong, int bandLimit, const JobControl& job = {});

/// A filtered spectrum on rings, not yet normalized. The reference sum's denominator N, the filter of a constant 1, differs from 1 by the
/// quadrature error of the texel sum; of the numerator the part about the mean is followed to the band limit, and the mean's own, mean N,
/// as far as N is.
struct FilteredRings {
    std::array<std::vector<double>, 3> rgb{}; ///< rings x ringLength each: the filter of what differs from the mean, plus the mean
    std::vector<double> norm{};               ///< N
    glm::dvec3 mean{0.0};

    /// The filtered map. @param bright  numerators of what was taken out of the probe
    glm::dvec3 radiance(size_t i, const glm::dvec3& bright = glm::dvec3(0.0)) const
    {
        return (glm::dvec3(rgb[0][i], rgb[1][i], rgb[2][i]) + mean * (norm[i] - 1.0) + bright) / norm[i];
    }
};

/// e_lm = k_l a_lm on the rings of colatitudes `theta`, each of `ringLength` samples that start at azimuth `phi0`.
/// @param k  0 .. B, at most the spectrum's band limit
/// @param azimuthFactors  multiply every coefficient of order m; that of m = 0 is 1
/// @param longer  k followed further, for N; empty: k
FilteredRings synthesize(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& theta, int ringLength,
                         double phi0, const std::vector<std::complex<double>>& azimuthFactors, const JobControl& job,
                         const std::vector<double>& longer = {});

/// The zonal part of N at the colatitudes `theta`: all of it but what repeats along the rows, which only a band limit of a row's length
/// sees.
std::vector<double> zonalNorm(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& theta);
/// What zonalNorm() leaves out at most of a lobe's norm, root mean square.
inline constexpr double negligibleNorm = 1e-8;
/// The largest degree that zonalNorm() looks at. Within the first hundreds of degrees, which cost little, it leaves out no more than 1e-13:
/// beside a sun the norm's error counts as many times as the mean is brighter than the dark.
int zonalNormLimit(const Spectrum& spectrum, const std::vector<double>& k);

} // namespace mirrorball
