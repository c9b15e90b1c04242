#include "core/filter/prefilter.h"
#include "core/filter/reference.h"
#include "core/image/builtin_probes.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

/// Times of the filtering methods on a 1024 x 512 probe in memory to a 128 cube in memory, on two threads unless a name says otherwise.
/// Beside the rows that people wait for stand their floor in milliseconds, what no way of doing it could go below on this machine, and the
/// share of the time that this is.
namespace mirrorball {
namespace {

const MapLayout cube128{Parameterization::Cube, 128, 0};
const JobControl twoThreads{.threads = 2};

const EnvironmentMap& probe()
{
    static const EnvironmentMap sky = renderBuiltinProbe("sky");
    return sky;
}

double secondsOf(int times, const auto& work)
{
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i)
        work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
}

/// One thread reading a block that no cache holds.
double bytesPerSecond()
{
    static const double rate = [] {
        const std::vector<float> block(1 << 26, 1.0f);
        const double seconds = secondsOf(3, [&] {
            std::array<float, 64> sums{}; // so many that the additions of one need not wait for the last
            for (size_t i = 0; i < block.size(); i += sums.size())
                for (size_t k = 0; k < sums.size(); ++k)
                    sums[k] += block[i + k];
            benchmark::DoNotOptimize(sums);
        });
        return 4.0 * static_cast<double>(block.size()) / seconds;
    }();
    return rate;
}

/// One thread multiplying and adding floats that it has at hand, as this program is built.
double multiplyAddsPerSecond()
{
    static const double rate = [] {
        std::array<float, 96> sums{}, factors{};
        factors.fill(0.999f);
        constexpr int rounds = 1 << 20;
        const double seconds = secondsOf(3, [&] {
            for (int i = 0; i < rounds; ++i)
                for (size_t k = 0; k < sums.size(); ++k)
                    sums[k] = sums[k] * factors[k] + 1.0f;
            benchmark::DoNotOptimize(sums);
        });
        return static_cast<double>(rounds) * static_cast<double>(sums.size()) / seconds;
    }();
    return rate;
}

/// What has to be moved and multiplied at least, shared by two threads.
struct Floor {
    double bytes = 0.0, multiplyAdds = 0.0;

    Floor& operator+=(const Floor& other)
    {
        bytes += other.bytes;
        multiplyAdds += other.multiplyAdds;
        return *this;
    }
};

/// The probe's texels once, and a real transform of each row: 5/4 N log2 N multiplications and additions together, half of them each.
Floor forwardFloor()
{
    const double width = probe().image.width, height = probe().image.height;
    return {12.0 * width * height, 3.0 * height * 1.25 * width * std::log2(width)};
}

/// A map's texels, each of three channels and a norm off 6 x 6 samples.
Floor mapFloor(int size)
{
    const double texels = 6.0 * size * size;
    return {12.0 * texels, texels * 4.0 * (36.0 + 6.0)};
}

void setFloor(benchmark::State& state, const Floor& floor)
{
    const double seconds = 0.5 * std::max(floor.bytes / bytesPerSecond(), floor.multiplyAdds / multiplyAddsPerSecond());
    state.counters["floor_ms"] = 1e3 * seconds;
    state.counters["floor_share"] = benchmark::Counter(seconds, benchmark::Counter::kIsIterationInvariantRate);
}

/// Everything: the forward transform, the lobe and the map.
void phong50ToCube128(benchmark::State& state)
{
    for (auto _ : state) {
        state.PauseTiming();
        FilterSource source(probe());
        state.ResumeTiming();
        benchmark::DoNotOptimize(prefilter(source, {.lobe = phongLobe(50), .target = cube128}, twoThreads));
    }
    Floor floor = forwardFloor();
    setFloor(state, floor += mapFloor(128));
}
BENCHMARK(phong50ToCube128)->UseRealTime()->Unit(benchmark::kMillisecond);

/// A slider moves: the probe's spectrum is there, the exponent is new each time.
void exponentChange(benchmark::State& state)
{
    FilterSource source(probe());
    prefilter(source, {.lobe = phongLobe(60), .target = cube128}, twoThreads);
    double n = 40.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(prefilter(source, {.lobe = phongLobe(n), .target = cube128}, twoThreads));
        n = n < 60.0 ? n + 0.1 : 40.0;
    }
    setFloor(state, mapFloor(128));
}
BENCHMARK(exponentChange)->UseRealTime()->Unit(benchmark::kMillisecond);

void phongToCube128(benchmark::State& state)
{
    for (auto _ : state) {
        state.PauseTiming();
        FilterSource source(probe());
        state.ResumeTiming();
        benchmark::DoNotOptimize(
            prefilter(source, {.lobe = phongLobe(static_cast<double>(state.range(0))), .target = cube128}, twoThreads));
    }
}
BENCHMARK(phongToCube128)->Arg(1)->Arg(10)->Arg(500)->Arg(5000)->Arg(50000)->UseRealTime()->Unit(benchmark::kMillisecond);

void diffuseToCube128(benchmark::State& state)
{
    for (auto _ : state) {
        state.PauseTiming();
        FilterSource source(probe());
        state.ResumeTiming();
        benchmark::DoNotOptimize(prefilter(source, {.lobe = diffuseLobe(), .target = cube128}, twoThreads));
    }
}
BENCHMARK(diffuseToCube128)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Every level of a 256 cube, roughness 0 to 1, from one forward transform.
void ggxChainToCube256(benchmark::State& state)
{
    for (auto _ : state) {
        state.PauseTiming();
        FilterSource source(probe());
        state.ResumeTiming();
        for (int level = 0; level < 9; ++level) {
            const double roughness = chainRoughness(level, 9);
            benchmark::DoNotOptimize(prefilter(
                source, {.lobe = ggxLobe(roughness * roughness), .target = {Parameterization::Cube, 256 >> level, 0}}, twoThreads));
        }
    }
    Floor floor = forwardFloor();
    for (int level = 0; level < 9; ++level)
        floor += mapFloor(256 >> level);
    setFloor(state, floor);
}
BENCHMARK(ggxChainToCube256)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The reference sum for one row of the cube; the counter scales it to the whole cube of 768 rows.
void referencePhong50(benchmark::State& state)
{
    std::vector<glm::dvec3> row;
    for (int x = 0; x < 128; ++x)
        row.push_back(texelDirection(cube128, x, 300));
    for (auto _ : state)
        benchmark::DoNotOptimize(referenceSum(probe(), phongLobe(50), row, twoThreads));
    state.counters["whole_cube_seconds"] =
        benchmark::Counter(static_cast<double>(state.iterations()) / 768.0, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(referencePhong50)->UseRealTime()->Unit(benchmark::kMillisecond);

/// What the field does, plainly: 1024 samples of the lobe a texel, nearest texels, no filtering of the samples.
void importanceSampling1024(benchmark::State& state)
{
    constexpr int samples = 1024;
    constexpr double n = 50.0;
    std::mt19937 generator(1);
    std::vector<glm::dvec3> lobe;
    for (int i = 0; i < samples; ++i) { // cos t = u^(1/(n+1))
        const double u = (i + 0.5) / samples, phi = 2.0 * pi * static_cast<double>(generator()) / 4294967296.0;
        const double c = std::pow(u, 1.0 / (n + 1.0)), s = std::sqrt(1.0 - c * c);
        lobe.emplace_back(s * std::cos(phi), s * std::sin(phi), c);
    }
    const Image& image = probe().image;
    for (auto _ : state) {
        EnvironmentMap map(cube128);
        parallelRows(768, twoThreads, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < 128; ++x) {
                    const glm::dvec3 r = texelDirection(cube128, x, y);
                    const glm::dvec3 t = glm::normalize(glm::cross(std::abs(r.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), r));
                    const glm::dvec3 b = glm::cross(r, t);
                    glm::vec3 sum(0.0f);
                    for (const glm::dvec3& l : lobe) {
                        const glm::dvec2 p = coordinate(probe().layout, l.x * t + l.y * b + l.z * r);
                        const float* texel = image.texel(std::min(static_cast<int>(p.x), image.width - 1),
                                                         std::min(static_cast<int>(p.y), image.height - 1));
                        sum += glm::vec3(texel[0], texel[1], texel[2]);
                    }
                    sum /= static_cast<float>(samples);
                    std::copy_n(&sum.x, 3, map.image.texel(x, y));
                }
        });
        benchmark::DoNotOptimize(map);
    }
}
BENCHMARK(importanceSampling1024)->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(1);

} // namespace
} // namespace mirrorball
