#include "published_paraboloid.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>

namespace mirrorball {

namespace {

constexpr double clampValue = 0.1;
constexpr int half = 512, halfBorder = 64, largestKernel = 7;

/// What is drawn in the paper is not said to be larger than what the shrunk maps hold: 128 texels for the largest of them.
constexpr MapLayout tableTarget{Parameterization::Paraboloid, 160, 16};

struct PublishedRow {
    double exponent;
    KernelSizes sizes;
    double frames;
};
constexpr std::array<PublishedRow, 5> published{{{10, {174, 260, 32, 64}, 25},
                                                 {50, {78, 136, 16, 32}, 20},
                                                 {100, {56, 100, 8, 16}, 16},
                                                 {250, {36, 66, 8, 16}, 16},
                                                 {500, {26, 48, 4, 8}, 9}}};

/// Median seconds of frames by one method, after one that warms up.
double frameSeconds(const FilterSource& probe, const PrefilterOptions& filter, const KernelTableOptions& options, const JobControl& job,
                    Method& ran)
{
    FilterSource source = probe;
    const auto frame = [&] {
        source = probe; // which holds nothing but the probe
        return timeOf([&] {
            PrefilterOutcome outcome = prefilter(source, filter, job);
            ran = outcome.method;
            if (options.drawer)
                options.drawer->draw(
                    std::make_shared<const std::vector<EnvironmentMap>>(std::vector<EnvironmentMap>{std::move(outcome.map)}));
        });
    };
    const double first = frame().wall;
    return repeated(options.repeats, options.longest - first, frame).median();
}

} // namespace

KernelTable measureKernelTable(const FilterSource& probe, const KernelTableOptions& options, const JobControl& job)
{
    if (!probe.latlong())
        throw InvalidArgument("kernels: the probe is too large to hold, and a frame filters it whole; take a smaller one");
    const JobControl inner{.stop = job.stop, .threads = job.threads};
    KernelTable table{.knobs = {.kernel = ParaboloidKernel::Blended,
                                .clamp = clampValue,
                                .largestKernel = largestKernel,
                                .half = half,
                                .border = halfBorder},
                      .target = tableTarget,
                      .drawnBy = options.drawer ? options.drawer->description() : ""};
    for (const PublishedRow& paper : published) {
        job.checkStop();
        const Lobe lobe = phongLobe(paper.exponent);
        KernelTableRow row{.exponent = paper.exponent,
                           .sizes = kernelSizes(LobeShape(lobe).support(clampValue), half, largestKernel),
                           .publishedSizes = paper.sizes,
                           .publishedFrames = paper.frames};
        PrefilterOptions filter{.lobe = lobe, .target = tableTarget, .method = Method::Paraboloid, .knobs = {.paraboloid = table.knobs}};
        Method ran = Method::Auto;
        row.blendedSeconds = frameSeconds(probe, filter, options, inner, ran);
        filter.knobs = {};
        row.exactSeconds = frameSeconds(probe, filter, options, inner, ran);
        filter.method = Method::Auto;
        filter.tolerance = options.tolerance;
        row.autoSeconds = frameSeconds(probe, filter, options, inner, row.autoRan);
        table.rows.push_back(row);
        if (job.progress)
            job.progress(static_cast<float>(table.rows.size()) / static_cast<float>(published.size()));
    }
    return table;
}

double expectedKernelTableSeconds(const ProbeTraits& probe, const KernelTableOptions& options, const Pace& pace)
{
    constexpr double drawing = 0.02; // a picture on a software renderer
    double sum = 0.0;
    for (const PublishedRow& paper : published)
        for (const ParaboloidKernel kernel : {ParaboloidKernel::Blended, ParaboloidKernel::Exact}) {
            const PrefilterOptions filter{
                .lobe = phongLobe(paper.exponent), .target = tableTarget, .knobs = {.paraboloid = {.kernel = kernel}}};
            const double frame = pace.seconds(predictedSeconds(Method::Paraboloid, filter, probe) + drawing);
            sum += frame * (1 + repeats(options.repeats, options.longest - frame, frame));
        }
    return sum;
}

std::vector<DistortionCurve> distortionCurves()
{
    std::vector<DistortionCurve> curves;
    for (const double radius : {0.1, 0.2, 0.3, 0.4, 0.5}) {
        DistortionCurve curve{.radius = radius};
        for (int i = 0; i < distortionSteps; ++i)
            curve.distortion.push_back(circleDistortion(static_cast<double>(i) / (distortionSteps - 1), radius));
        curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace mirrorball
