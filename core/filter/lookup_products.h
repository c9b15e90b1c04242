#pragma once

#include "kernel_spectrum.h"
#include "spin_transform.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <vector>

/// The inner products that a fit of lookups (brdf_lookups.h) asks for thousands of times, read from tables:
///   <a, b> = sum_l naturalPower(l) (a's part of degree l, b's).
namespace mirrorball {

inline constexpr double leastLookupAlpha = 2e-3; ///< to 1

/// Weight of degree l: the power of natural light over the (2l+1) harmonics that share it; the mean, l = 0, is met by the albedo. Windows
/// and lamps hold about as much in every degree until they are resolved, here at l = 50, some degrees of arc. The mean over many scenes
/// falls sooner, about as 1/(l+1), but it is in scenes of hard light that lookups are seen to miss. How it was chosen: docs/materials.md.
inline double naturalPower(int l)
{
    const double fall = 1.0 + l * l / 2500.0;
    return l == 0 ? 0.0 : 1.0 / ((2.0 * l + 1.0) * fall * fall);
}

/// Direction of a lookup's axis in the frame of r: +Z is r, +X lies towards the normal, the plane of incidence is y = 0.
inline glm::dvec3 lookupAxis(double offset, double turn)
{
    return {std::sin(offset) * std::cos(turn), std::sin(turn), std::cos(offset) * std::cos(turn)};
}

/// A place between the nodes of a table: the first of four and their weights, Lagrange's cubic.
struct CubicTaps {
    size_t first = 0;
    std::array<double, 4> weight{};
    /// @param x  in nodes; clamped to them. @param nodes  at least 4
    static CubicTaps at(double x, size_t nodes);
};

/// Lobes of ggx at 25 widths, and what two of them have in common at a distance. A lobe between two widths is the cubic combination of four
/// of them, in ln alpha, here and in KernelProducts: what is interpolated is the lobe, so that costs stay sums of squares. Made once for
/// each band limit.
class LobeProducts {
public:
    static constexpr size_t widths = 25;
    static std::shared_ptr<const LobeProducts> of(int bandLimit);

    static CubicTaps taps(double alpha);
    double at(const CubicTaps& a, const CubicTaps& b, double cosDistance) const;
    /// k_l of the widths, [l][width].
    const std::vector<double>& coefficients() const { return m_k; }

private:
    explicit LobeProducts(int bandLimit);

    std::vector<double> m_k{}, m_products{}; ///< [distance][width][width]
};

/// What a kernel, all channels taken together, has in common with a lobe anywhere.
class KernelProducts {
public:
    /// @param spectrum  its orders are used as far as they hold a part in 1e7
    explicit KernelProducts(const KernelSpectrum& spectrum);

    double at(const CubicTaps& alpha, const glm::dvec3& axis) const;
    double square() const { return m_square; }
    const LobeProducts& lobes() const { return *m_lobes; }

private:
    std::shared_ptr<const LobeProducts> m_lobes;
    size_t m_orders = 1;
    double m_square = 0.0;
    std::vector<double> m_products{}; ///< [angle from r][order][width]
};

/// The same sums written out, without a table, per channel: what weights are made of in the end.
class ExactProducts {
public:
    explicit ExactProducts(const KernelSpectrum& spectrum);

    /// k_l of a lobe of any width.
    std::vector<double> lobe(double alpha) const;
    /// One value a channel.
    glm::dvec3 kernel(const std::vector<double>& lobe, const glm::dvec3& axis) const;
    double lobes(const std::vector<double>& a, const std::vector<double>& b, double cosDistance) const;
    double square(int channel) const;

private:
    const KernelSpectrum& m_spectrum;
    std::vector<OrderHarmonics> m_harmonics{}; ///< one an order
};

} // namespace mirrorball
