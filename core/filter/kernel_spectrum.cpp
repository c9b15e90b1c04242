#include "kernel_spectrum.h"

#include "spin_transform.h"

#include <cmath>

namespace mirrorball {

KernelSpectrum kernelSpectrum(const ReflectionKernel& kernel, int bandLimit, int orders)
{
    const LobeNodes nodes = lobeNodes(kernel.view(), bandLimit);
    const auto values = kernelAtNodes(kernel, nodes);
    const auto degrees = static_cast<size_t>(bandLimit) + 1, ms = static_cast<size_t>(orders) + 1;
    KernelSpectrum result{
        .view = kernel.view(), .bandLimit = bandLimit, .orders = orders, .isGrey = kernel.isGrey(), .albedo = glm::dvec3(0.0)};
    const size_t channels = kernel.channels();
    for (size_t c = 0; c < channels; ++c)
        result.k[c].assign(ms * degrees, 0.0);

    // Along the azimuth first: the integrals of K cos(m chi) d chi, weighted by their rings.
    const size_t rings = nodes.rings.size();
    std::vector<double> azimuthal(ms * rings * channels), cosines(ms);
    for (size_t r = 0; r < rings; ++r)
        for (size_t i = nodes.rings[r].first; i < nodes.end(r); ++i) {
            const double twice = 2.0 * std::cos(nodes.chi[i]);
            cosines[0] = 1.0;
            if (ms > 1)
                cosines[1] = 0.5 * twice;
            for (size_t m = 2; m < ms; ++m)
                cosines[m] = twice * cosines[m - 1] - cosines[m - 2];
            for (size_t c = 0; c < channels; ++c) {
                const double part = nodes.rings[r].weight * nodes.chiWeight[i] * values[c][i];
                result.power[c] += part * values[c][i];
                for (size_t m = 0; m < ms; ++m)
                    azimuthal[(r * channels + c) * ms + m] += part * cosines[m];
            }
        }
    std::vector<double> lambda(degrees);
    for (size_t m = 0; m < ms; ++m) {
        const OrderHarmonics harmonics(static_cast<int>(m), bandLimit);
        for (size_t r = 0; r < rings; ++r) {
            harmonics.at(nodes.rings[r].gamma, lambda);
            for (size_t c = 0; c < channels; ++c) {
                const double scale = (m == 0 ? 1.0 : 2.0) * azimuthal[(r * channels + c) * ms + m];
                double* to = result.k[c].data() + m * degrees;
                for (size_t l = m; l < degrees; ++l)
                    to[l] += scale * lambda[l];
            }
        }
    }
    for (size_t c = 0; c < channels; ++c) {
        double& albedo = result.albedo[static_cast<int>(c)];
        albedo = result.k[c][0] * std::sqrt(4.0 * pi);
        const double over = albedo > 0.0 ? 1.0 / albedo : 0.0;
        result.power[c] *= over * over;
        for (size_t m = 0; m < ms; ++m)
            for (size_t l = m; l < degrees; ++l)
                result.k[c][m * degrees + l] *= over * std::sqrt(4.0 * pi / (2.0 * static_cast<double>(l) + 1.0));
    }
    if (result.isGrey) {
        result.albedo = glm::dvec3(result.albedo.x);
        result.power[1] = result.power[2] = result.power[0];
    }
    return result;
}

} // namespace mirrorball
