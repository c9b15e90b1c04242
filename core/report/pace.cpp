#include "pace.h"

#include "reference_samples.h"
#include "run_times.h"

#include "core/filter/prediction.h"
#include "core/filter/reference.h"

namespace mirrorball {

Pace measurePace(const JobControl& job)
{
    constexpr MapLayout layout{Parameterization::Latlong, 64, 0};
    const MapLayout target{Parameterization::Octahedral, 16, 0};
    const JobControl quiet{.stop = job.stop, .threads = job.threads};
    EnvironmentMap probe(layout);
    std::fill(probe.image.texels.begin(), probe.image.texels.end(), 1.0f);
    const Lobe lobe = phongLobe(50.0);
    const std::vector<glm::dvec3> directions = evenDirections(target.width() * target.height());
    const auto sum = [&] { return secondsOf([&] { referenceSum(probe, lobe, directions, quiet); }); };
    sum(); // warms up
    const double measured = repeated(5, 0.5, sum).median();
    const PrefilterOptions options{.lobe = lobe, .target = target, .method = Method::Reference};
    return {measured / predictedSeconds(Method::Reference, options, {.width = layout.width()})};
}

} // namespace mirrorball
