#include "reflection_kernel.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

// This file is compiled with the relaxed floating-point rules that let the compiler call vectorised exp, log and pow (see
// CMakeLists.txt). Nothing here may produce or test for infinities or NaN.
namespace mirrorball {

namespace {

template <typename Model>
inline __attribute__((always_inline)) void evaluateRow(const Model& model, double nv, size_t n, const double* nl, const double* lv,
                                                       double* out)
{
    for (size_t i = 0; i < n; ++i) {
        const double c = std::max(nl[i], 1e-12);
        out[i] = nl[i] > 0.0 ? model.value(c, nv, lv[i]) * c : 0.0;
    }
}

MIRRORBALL_CLONES void row(const PhongBrdf& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    const PhongBrdf model = m;
    evaluateRow(model, nv, n, nl, lv, out);
}
MIRRORBALL_CLONES void row(const LafortuneLobe& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    const LafortuneLobe lobe = m;
    for (size_t i = 0; i < n; ++i) {
        const double c = lobe.cxy * (lv[i] - nl[i] * nv) + lobe.cz * nl[i] * nv;
        const double f = lobe.weight * (lobe.exponent + 2.0) / (2.0 * pi) * std::pow(std::max(c, 1e-300), lobe.exponent);
        out[i] += nl[i] > 0.0 && c > 0.0 ? f * nl[i] : 0.0;
    }
}
void row(const LafortuneBrdf& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    std::fill(out, out + n, 0.0);
    for (const LafortuneLobe& lobe : m.lobes)
        row(lobe, nv, n, nl, lv, out);
}
MIRRORBALL_CLONES void row(const WardBrdf& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    const WardBrdf model = m;
    evaluateRow(model, nv, n, nl, lv, out);
}
MIRRORBALL_CLONES void row(const CookTorranceBrdf& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    const CookTorranceBrdf model = m;
    evaluateRow(model, nv, n, nl, lv, out);
}
MIRRORBALL_CLONES void row(const BeckmannBrdf& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    const BeckmannBrdf model = m;
    evaluateRow(model, nv, n, nl, lv, out);
}
MIRRORBALL_CLONES void row(const GgxBrdf& m, double nv, size_t n, const double* nl, const double* lv, double* out)
{
    const GgxBrdf model = m;
    evaluateRow(model, nv, n, nl, lv, out);
}
void row(const MeasuredBrdf&, double, size_t, const double*, const double*, double*) {} // evaluateMeasured() does it

constexpr int sliceGamma = 384, sliceChi = 181;

/// Cosines of a place about r.
struct Cosines {
    double nl, lv;
};
Cosines cosinesAt(double gamma, double cosChi, double view)
{
    const double c = std::cos(gamma), s = std::sin(gamma) * cosChi;
    return {c * std::cos(view) + s * std::sin(view), c * std::cos(2.0 * view) + s * std::sin(2.0 * view)};
}

} // namespace

ReflectionKernel::ReflectionKernel(const Brdf& brdf, double view)
    : m_brdf(brdf), m_fresnel(brdf.fresnel), m_view(view), m_nv(std::max(std::cos(view), 1e-6)),
      m_isGray(m_fresnel.isGray() && !std::holds_alternative<MeasuredBrdf>(brdf.model))
{
    assert(view >= 0.0 && view < 0.5 * pi);
    const auto* measured = std::get_if<MeasuredBrdf>(&brdf.model);
    if (!measured)
        return;
    m_slice.resize(static_cast<size_t>(sliceGamma + 1) * sliceChi);
    for (int g = 0; g <= sliceGamma; ++g) {
        const double root = static_cast<double>(g) / sliceGamma;
        for (int x = 0; x < sliceChi; ++x) {
            const Cosines at = cosinesAt(pi * root * root, std::cos(pi * x / (sliceChi - 1)), view);
            // Below the horizon it is continued, so that reading beside it finds what lies above.
            const glm::dvec3 f = measured->value(std::max(at.nl, 1e-3), m_nv, std::clamp(at.lv, -1.0, 1.0));
            m_slice[static_cast<size_t>(g) * sliceChi + static_cast<size_t>(x)] = {static_cast<float>(f.x), static_cast<float>(f.y),
                                                                                   static_cast<float>(f.z)};
        }
    }
}

void ReflectionKernel::evaluateMeasured(std::span<const double> nl, std::span<const double> lv, const std::array<double*, 3>& out) const
{
    const double sinView = std::sin(m_view);
    for (size_t i = 0; i < nl.size(); ++i) {
        if (nl[i] <= 0.0) {
            for (double* channel : out)
                channel[i] = 0.0;
            continue;
        }
        const double rl = std::clamp(2.0 * m_nv * nl[i] - lv[i], -1.0, 1.0), gamma = std::acos(rl);
        const double across = std::sqrt(std::max(1.0 - rl * rl, 0.0)) * sinView;
        const double cosChi = across > 1e-9 ? std::clamp((nl[i] - rl * m_nv) / across, -1.0, 1.0) : 1.0;
        const double g = std::min(std::sqrt(gamma / pi) * sliceGamma, sliceGamma - 1e-9), x = std::acos(cosChi) / pi * (sliceChi - 1);
        const auto g0 = static_cast<size_t>(g), x0 = std::min(static_cast<size_t>(x), static_cast<size_t>(sliceChi - 2));
        const double tg = g - static_cast<double>(g0), tx = x - static_cast<double>(x0);
        const std::array<float, 3>* at = m_slice.data() + g0 * sliceChi + x0;
        for (size_t c = 0; c < 3; ++c) {
            const double near = (1.0 - tx) * at[0][c] + tx * at[1][c], far = (1.0 - tx) * at[sliceChi][c] + tx * at[sliceChi + 1][c];
            out[c][i] = ((1.0 - tg) * near + tg * far) * nl[i];
        }
    }
}

void ReflectionKernel::evaluate(std::span<const double> nl, std::span<const double> lv, const std::array<double*, 3>& out) const
{
    assert(nl.size() == lv.size());
    if (std::holds_alternative<MeasuredBrdf>(m_brdf.model)) {
        evaluateMeasured(nl, lv, out);
        return;
    }
    const size_t n = nl.size();
    std::visit([&](const auto& model) { row(model, m_nv, n, nl.data(), lv.data(), out[0]); }, m_brdf.model);
    if (m_fresnel.isOne())
        return;
    for (size_t i = 0; i < n; ++i) {
        if (out[0][i] == 0.0) {
            for (size_t c = 1; c < channels(); ++c)
                out[c][i] = 0.0;
            continue;
        }
        const glm::dvec3 f = out[0][i] * m_fresnel.at(std::sqrt(std::max(0.5 * (1.0 + lv[i]), 0.0)));
        for (size_t c = 0; c < channels(); ++c)
            out[c][i] = f[static_cast<int>(c)];
    }
}

std::array<std::vector<double>, 3> kernelAtNodes(const ReflectionKernel& kernel, const LobeNodes& nodes)
{
    std::array<std::vector<double>, 3> values;
    std::array<double*, 3> out{};
    for (size_t c = 0; c < kernel.channels(); ++c) {
        values[c].resize(nodes.nl.size());
        out[c] = values[c].data();
    }
    kernel.evaluate(nodes.nl, nodes.lv, out);
    return values;
}

} // namespace mirrorball
