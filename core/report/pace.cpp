#include "pace.h"

#include "run_times.h"

#include "core/filter/prefilter.h"

#include <algorithm>
#include <tuple>

namespace mirrorball {

Pace measurePace(const JobControl& job)
{
    constexpr MapLayout layout{Parameterization::Latlong, 128, 0};
    const MapLayout target{Parameterization::Cube, 16, 0};
    const JobControl quiet{.stop = job.stop, .threads = job.threads};
    EnvironmentMap map(layout);
    std::fill(map.image.texels.begin(), map.image.texels.end(), 1.0f);
    const FilterSource probe(std::move(map), quiet);
    double measured = 0.0, predicted = 0.0;
    // Long vectors, lookups that jump about, and transforms: each some hundredths of a second.
    for (const auto& [method, share, samples] :
         {std::tuple{Method::Reference, 1, 0}, {Method::Importance, 1, 64}, {Method::Spectral, 8, 0}}) {
        const PrefilterOptions options{
            .lobe = phongLobe(50.0), .target = target, .method = method, .knobs = {.samples = std::max(1, samples)}};
        FilterSource source = probe;
        const auto run = [&] {
            source = probe;
            return secondsOf([&] { prefilter(source, options, quiet); });
        };
        measured += share * repeated(3, 0.2, run).shortest();
        predicted += share * predictedSeconds(method, options, traits(probe));
    }
    return {measured / predicted};
}

} // namespace mirrorball
