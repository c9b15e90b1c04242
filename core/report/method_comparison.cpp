#include "method_comparison.h"

#include "thumbnails.h"

#include "core/image/reproject.h"

#include <array>
#include <utility>

namespace mirrorball {

namespace {

MapLayout originalLayout(const MethodComparisonOptions& options) { return {Parameterization::Paraboloid, options.size, options.border}; }
/// What the methods are handed: as many texels as the original has.
MapLayout summedLayout(const MethodComparisonOptions& options) { return {Parameterization::Latlong, options.size, 0}; }
constexpr double exponent = 100.0;
constexpr double hierarchicalTolerance = 1e-2; ///< what an eye does not see

ComparedMap filtered(FilterSource source, const PrefilterOptions& options, std::string label, std::string how, EnvironmentMap& map,
                     const JobControl& job)
{
    ComparedMap compared{.label = std::move(label), .how = std::move(how)};
    compared.seconds = secondsOf([&] { map = prefilter(source, options, job).map; });
    return compared;
}

} // namespace

MethodComparison compareMethods(const EnvironmentMap& probe, const MethodComparisonOptions& options, const JobControl& job)
{
    const MapLayout original = originalLayout(options);
    const JobControl inner{.stop = job.stop, .threads = job.threads};
    MethodComparison comparison{.lobe = phongLobe(exponent), .target = original};
    const EnvironmentMap unfiltered = reproject(probe, {.target = original}, inner);
    FilterSource source(reproject(unfiltered, {.target = summedLayout(options)}, inner));
    source.useParaboloidDevice(options.device);
    const PrefilterOptions classic{.lobe = comparison.lobe, .target = original, .method = Method::Reference};
    PrefilterOptions hierarchical = classic, hardware = classic;
    hierarchical.method = Method::Hierarchical;
    hierarchical.tolerance = hierarchicalTolerance;
    hardware.method = Method::Paraboloid;
    hardware.knobs.paraboloid = {.kernel = ParaboloidKernel::Blended,
                                 .clamp = 0.1,
                                 .largestKernel = 7,
                                 .half = original.size - 2 * original.border,
                                 .border = original.border};

    EnvironmentMap truth, tree, kernels;
    const double exposure = pictureExposure(unfiltered);
    comparison.maps.push_back({.label = "unfiltered", .how = "the original"});
    comparison.maps.push_back(filtered(source, classic, "classic", "the sum over every texel", truth, inner));
    comparison.maps.push_back(filtered(source, hierarchical, "hierarchical", "tolerance 1e-2", tree, inner));
    comparison.maps.push_back(filtered(source, hardware, "hardware", "two kernels, clamp 0.1, at most 7 texels", kernels, inner));
    const std::array<const EnvironmentMap*, 4> maps{&unfiltered, &truth, &tree, &kernels};
    for (size_t i = 0; i < maps.size(); ++i) {
        ComparedMap& compared = comparison.maps[i];
        compared.picture = texelPicture(*maps[i], exposure);
        if (i < 2)
            continue;
        compared.error = errorMetrics(*maps[i], truth);
        ErrorPicture picture = errorPicture(*maps[i], truth, original);
        compared.errorPicture = std::move(picture.png);
        compared.errorPictureLimit = picture.limit;
    }
    return comparison;
}

double expectedComparisonSeconds(const MethodComparisonOptions& options, const Pace& pace)
{
    const PrefilterOptions classic{.lobe = phongLobe(exponent), .target = originalLayout(options), .method = Method::Reference};
    return pace.seconds(predictedSeconds(Method::Reference, classic, {.width = summedLayout(options).width()}));
}

} // namespace mirrorball
