#include "pace.h"

#include "run_times.h"

#include "core/filter/prefilter.h"

#include <algorithm>
#include <array>
#include <utility>

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
    constexpr std::array<std::pair<Method, int>, 3> filters{{{Method::Reference, 1}, {Method::Importance, 1}, {Method::Spectral, 8}}};
    for (const auto& [method, share] : filters) {
        const PrefilterOptions options{.lobe = phongLobe(50.0), .target = target, .method = method, .knobs = {.samples = 64}};
        FilterSource source = probe;
        const auto run = [&] {
            source = probe;
            return timeOf([&] { prefilter(source, options, quiet); });
        };
        measured += share * repeated(3, 0.2, run).median();
        predicted += share * predictedSeconds(method, options, traits(probe));
    }
    return {measured / predicted};
}

} // namespace mirrorball
