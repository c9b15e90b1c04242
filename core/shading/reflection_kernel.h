#pragma once

#include "brdf.h"

#include <array>
#include <span>
#include <vector>

namespace mirrorball {

/// Where a direction l lies in the frame of the mirrored view r: gamma the angle between them, chi the azimuth of l about r, 0 towards the
/// normal. With t the angle between n and r (and n and v),
///   n.l = cos gamma cos t + sin gamma cos chi sin t,   l.v = cos gamma cos 2t + sin gamma cos chi sin 2t.

/// The light that a BRDF sends to one view, by where it comes from: K(l) = f(l, v) (n.l), 0 below the horizon. What the reflected radiance
/// is an integral of:
///   L_o = integral K(l) L(l) d omega.
/// Made ready for many directions: rows of them are evaluated at once.
class ReflectionKernel {
public:
    /// @param view  t, the angle between n and v, radians in [0, pi/2)
    ReflectionKernel(const Brdf& brdf, double view);

    double view() const { return m_view; }
    double cosView() const { return m_nv; }
    /// Whether the three channels are alike; then only the first is ever written.
    bool isGray() const { return m_isGray; }
    size_t channels() const { return m_isGray ? 1 : 3; }

    /// K at many directions, named by n.l and l.v. @param out  channels() arrays as long as nl
    void evaluate(std::span<const double> nl, std::span<const double> lv, const std::array<double*, 3>& out) const;

private:
    void evaluateMeasured(std::span<const double> nl, std::span<const double> lv, const std::array<double*, 3>& out) const;

    Brdf m_brdf;
    FresnelCurve m_fresnel;
    double m_view, m_nv;
    bool m_isGray;
    /// A measurement at this view, [gamma][chi], in steps of the root of gamma: reading it there costs too much for every texel.
    std::vector<std::array<float, 3>> m_slice{};
};

/// Nodes and weights over the directions about r above the horizon, fine where lobes are narrow: integrals of a kernel by Gauss-Legendre,
/// in gamma on panels that grow from the peak outwards and break where the horizon begins to cut, in chi up to the horizon,
/// cos chi = -cot gamma cot t. Sixteen nodes follow a harmonic of degree l over 20/l radians, which is the widest panel.
struct LobeNodes {
    struct Ring {
        double gamma;
        double weight; ///< of d gamma, sin gamma included
        size_t first;  ///< of the nodes in chi; the next ring's begin where they end
    };
    std::vector<Ring> rings{};
    std::vector<double> chi{};       ///< in (0, pi): kernels are even in chi
    std::vector<double> chiWeight{}; ///< of d chi, both sides
    std::vector<double> nl{}, lv{};

    size_t end(size_t ring) const { return ring + 1 < rings.size() ? rings[ring + 1].first : chi.size(); }
};
LobeNodes lobeNodes(double view, int degree = 200);

/// The kernel at the nodes, per channel.
std::array<std::vector<double>, 3> kernelAtNodes(const ReflectionKernel& kernel, const LobeNodes& nodes);

/// What share of a constant environment is reflected to the view: the directional albedo, the integral of K.
glm::dvec3 directionalAlbedo(const Brdf& brdf, double view);

/// Gauss-Legendre nodes and weights on [-1, 1].
struct GaussLegendre {
    std::vector<double> nodes{}, weights{};
};
const GaussLegendre& gaussLegendre16();

} // namespace mirrorball
