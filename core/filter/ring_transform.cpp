#include "ring_transform.h"

#include "core/base/open_mp.h"
#include "core/sphere/direction.h"

#include <algorithm>

namespace mirrorball::ring_transform {

using Complex = std::complex<double>;

std::vector<double> ringColatitudes(int rings)
{
    std::vector<double> theta(static_cast<size_t>(rings));
    for (int j = 0; j < rings; ++j)
        theta[static_cast<size_t>(j)] = pi * (j + 0.5) / rings;
    return theta;
}

std::vector<Geometry> ringBlocks(const std::vector<double>& theta, const std::vector<double>& weight, int ringLength, double phi0,
                                 size_t mostBlocks)
{
    constexpr size_t pairsInBlock = 64; // each block prepares the Legendre recursions anew, at the cost of some four pairs
    const size_t n = theta.size(), pairs = (n + 1) / 2, count = std::clamp(pairs / pairsInBlock, size_t{1}, mostBlocks);
    std::vector<Geometry> blocks;
    for (size_t block = 0; block < count; ++block) {
        std::vector<double> thetas, weights;
        std::vector<ptrdiff_t> offsets;
        const auto add = [&](size_t ring) {
            thetas.push_back(theta[ring]);
            weights.push_back(weight.empty() ? 1.0 : weight[ring]);
            offsets.push_back(static_cast<ptrdiff_t>(ring) * ringLength);
        };
        for (size_t ring = block * pairs / count; ring < (block + 1) * pairs / count; ++ring) {
            add(ring);
            if (ring != n - 1 - ring)
                add(n - 1 - ring);
        }
        const std::vector<int> lengths(thetas.size(), ringLength), strides(thetas.size(), 1);
        const std::vector<double> starts(thetas.size(), phi0);
        sharp_geom_info* info = nullptr;
        sharp_make_geom_info(static_cast<int>(thetas.size()), lengths.data(), offsets.data(), strides.data(), starts.data(), thetas.data(),
                             weights.data(), &info);
        blocks.emplace_back(info);
    }
    return blocks;
}

Coefficients triangle(int bandLimit)
{
    sharp_alm_info* info = nullptr;
    sharp_make_triangular_alm_info(bandLimit, bandLimit, 1, &info);
    return Coefficients(info);
}

void toRings(std::vector<Complex>& coefficients, std::vector<double>& map, const std::vector<Geometry>& blocks,
             const Coefficients& triangle, const JobControl& job)
{
    parallelRows(
        static_cast<int>(blocks.size()), {.stop = job.stop, .progress = {}, .threads = job.threads},
        [&](int first, int last) {
            const OpenMpThreads alone(1);
            Complex* alm = coefficients.data();
            double* texels = map.data();
            for (int i = first; i < last; ++i)
                sharp_execute(SHARP_ALM2MAP, 0, &alm, &texels, blocks[static_cast<size_t>(i)].get(), triangle.get(), SHARP_DP, nullptr,
                              nullptr);
        },
        1);
}

void fromRings(std::span<std::vector<Complex>> coefficients, std::span<std::vector<double>> maps, const std::vector<Geometry>& blocks,
               const Coefficients& triangle, const JobControl& job)
{
    const auto add = [&](std::vector<Complex>& to, std::vector<double>& map, size_t block, int flags) {
        job.checkStop();
        Complex* alm = to.data();
        double* texels = map.data();
        sharp_execute(SHARP_MAP2ALM, 0, &alm, &texels, blocks[block].get(), triangle.get(), SHARP_DP | flags, nullptr, nullptr);
    };
    if (blocks.size() == 1) {
        const OpenMpThreads threads(job.threadCount());
        for (size_t c = 0; c < maps.size(); ++c)
            add(coefficients[c], maps[c], 0, 0);
        return;
    }
    constexpr size_t lots = 2;
    std::vector<std::vector<Complex>> sums(maps.size() * lots);
    parallelRows(
        static_cast<int>(sums.size()), {.stop = job.stop, .progress = {}, .threads = job.threads},
        [&](int first, int last) {
            const OpenMpThreads alone(1);
            for (size_t i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i) {
                sums[i].resize(coefficients[i / lots].size());
                for (size_t block = i % lots; block < blocks.size(); block += lots)
                    add(sums[i], maps[i / lots], block, SHARP_ADD);
            }
        },
        1);
    for (size_t c = 0; c < maps.size(); ++c)
        for (size_t i = 0; i < coefficients[c].size(); ++i)
            coefficients[c][i] = sums[c * lots][i] + sums[c * lots + 1][i];
}

} // namespace mirrorball::ring_transform
