#include "kernel_spectrum.h"

#include "spin_transform.h"

#include "core/base/multiversion.h"

#include <cmath>

namespace mirrorball {

namespace {

/// sum_i part_i cos(m chi_i) for m = 0, 1, ... into every `stride`-th place of `sums`. Node by node in the inner loop, which then runs in
/// vectors.
MIRRORBALL_CLONES void addCosines(std::span<const double> chi, std::span<const double> part, std::span<double> sums, size_t stride)
{
    const size_t count = chi.size();
    std::vector<double> twice(count), before(count), now(count, 1.0);
    for (size_t i = 0; i < count; ++i) {
        before[i] = std::cos(chi[i]); // cos(-chi)
        twice[i] = 2.0 * before[i];
    }
    for (size_t at = 0; at < sums.size(); at += stride) {
        double sum = 0.0;
#pragma omp simd reduction(+ : sum)
        for (size_t i = 0; i < count; ++i) {
            sum += part[i] * now[i];
            const double next = twice[i] * now[i] - before[i];
            before[i] = now[i];
            now[i] = next;
        }
        sums[at] += sum;
    }
}

} // namespace

KernelSpectrum kernelSpectrum(const ReflectionKernel& kernel, int bandLimit, int orders)
{
    const LobeNodes nodes = lobeNodes(kernel.view(), bandLimit);
    const auto values = kernelAtNodes(kernel, nodes);
    const auto degrees = static_cast<size_t>(bandLimit) + 1, ms = static_cast<size_t>(orders) + 1;
    KernelSpectrum result{
        .view = kernel.view(), .bandLimit = bandLimit, .orders = orders, .isGray = kernel.isGray(), .albedo = glm::dvec3(0.0)};
    const size_t channels = kernel.channels();
    for (size_t c = 0; c < channels; ++c)
        result.k[c].assign(ms * degrees, 0.0);

    // Along the azimuth first: the integrals of K cos(m chi) d chi, weighted by their rings, [channel][order][ring].
    const size_t rings = nodes.rings.size();
    std::vector<double> azimuthal(channels * ms * rings), part, gammas;
    for (size_t r = 0; r < rings; ++r) {
        const size_t first = nodes.rings[r].first, count = nodes.end(r) - first;
        gammas.push_back(nodes.rings[r].gamma);
        for (size_t c = 0; c < channels; ++c) {
            part.assign(count, 0.0);
            for (size_t i = 0; i < count; ++i) {
                part[i] = nodes.rings[r].weight * nodes.chiWeight[first + i] * values[c][first + i];
                result.power[c] += part[i] * values[c][first + i];
            }
            addCosines({nodes.chi.data() + first, count}, part, {azimuthal.data() + c * ms * rings + r, (ms - 1) * rings + 1}, rings);
        }
    }
    for (size_t m = 0; m < ms; ++m) {
        const OrderHarmonics harmonics(static_cast<int>(m), bandLimit);
        for (size_t c = 0; c < channels; ++c) {
            const std::span<double> to = std::span(result.k[c]).subspan(m * degrees, degrees);
            harmonics.addSums(gammas, std::span(azimuthal).subspan((c * ms + m) * rings, rings), to);
            if (m > 0)
                for (double& value : to)
                    value *= 2.0;
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
    if (result.isGray) {
        result.albedo = glm::dvec3(result.albedo.x);
        result.power[1] = result.power[2] = result.power[0];
    }
    return result;
}

} // namespace mirrorball
