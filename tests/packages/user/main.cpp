// A program that has nothing of Mirrorball but its packages: the mean of a constant environment under a lobe is that constant.
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"

#include <algorithm>
#include <cstdio>

int main()
{
    using namespace mirrorball;
    EnvironmentMap probe = renderBuiltinProbe("studio", {Parameterization::Latlong, 16, 0});
    std::fill(probe.image.texels.begin(), probe.image.texels.end(), 1.0f);
    FilterSource source(std::move(probe));
    const PrefilterOutcome outcome = prefilter(source, {.lobe = phongLobe(10.0), .target = {.kind = Parameterization::Latlong, .size = 8}});
    std::printf("%.3g\n", static_cast<double>(outcome.map.image.texels[0]));
}
