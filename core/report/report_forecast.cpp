#include "report_forecast.h"

#include "part_options.h"

#include "core/base/error.h"
#include "core/image/probe_file.h"
#include "core/scene/stage_cost.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirrorball {

namespace {

struct ExpectedProbe {
    ProbeTraits traits{};
    double openingSeconds = 0.0;
};

ExpectedProbe expectedProbe(const ReportOptions& options, const std::string& name)
{
    const ProbeFile file(name, {.reading = options.reading});
    const MapLayout& layout = file.layout();
    if (std::int64_t{layout.width()} * layout.height() > largestReportProbe)
        throw InvalidArgument(name + ": has " + std::to_string(layout.width()) + " x " + std::to_string(layout.height()) +
                              " texels, more than a report holds; give a smaller one, and --growth-to 16384 to see how large ones stream");
    return {{.width = 2 * latlongHeight(layout), .hasParaboloidDevice = options.device != nullptr},
            readingCost(layout, file.isBuiltin(), false).seconds};
}

} // namespace

double ReportForecast::seconds() const
{
    return std::accumulate(parts.begin(), parts.end(), 0.0, [](double sum, const Part& part) { return sum + part.seconds; });
}

ReportForecast forecastReport(const ReportOptions& options, const Pace& pace)
{
    std::vector<ExpectedProbe> probes;
    if (std::any_of(options.parts.begin(), options.parts.end(), needsProbe))
        for (const std::string& name : options.probes)
            probes.push_back(expectedProbe(options, name));
    ReportForecast forecast;
    for (const ReportPart part : options.parts) {
        if (!options.has(part))
            continue;
        double seconds = 0.0;
        switch (part) {
        case ReportPart::Methods:
            for (const ExpectedProbe& probe : probes) {
                seconds += pace.seconds(probe.openingSeconds);
                for (const Lobe& lobe : options.lobes)
                    seconds += expectedCaseSeconds(probe.traits, lobe, errorTimeOptions(options), pace);
            }
            break;
        case ReportPart::Parameterizations:
            seconds = expectedStudySeconds(probes.front().traits, studyOptions(options), pace);
            break;
        case ReportPart::Growth:
            seconds = expectedGrowthSeconds(probes.front().traits, growthOptions(options), pace);
            break;
        case ReportPart::Stability:
            seconds = expectedStabilitySeconds(options.methods, stabilityScale(options), pace);
            break;
        case ReportPart::Kernels:
            seconds = expectedKernelTableSeconds(probes.front().traits, kernelTableOptions(options), pace);
            break;
        case ReportPart::Comparison:
            seconds = expectedComparisonSeconds(comparisonOptions(options), pace);
            break;
        case ReportPart::Distortion:
            break;
        }
        forecast.parts.push_back({part, seconds});
    }
    return forecast;
}

std::string durationText(double seconds)
{
    if (seconds < 9.5)
        return shortNumber(seconds, seconds < 1.0 ? 1 : 2) + " s";
    const double step = seconds < 60.0 ? 1.0 : seconds < 600.0 ? 10.0 : 60.0;
    const auto rounded = static_cast<int>(step * std::round(seconds / step));
    if (rounded < 60)
        return std::to_string(rounded) + " s";
    const std::string rest = rounded % 60 == 0 ? "" : " " + std::to_string(rounded % 60) + " s";
    return std::to_string(rounded / 60) + " min" + rest;
}

std::string describe(const ReportForecast& forecast)
{
    if (forecast.seconds() < 0.1)
        return "a moment";
    std::string text = "about " + durationText(forecast.seconds());
    if (forecast.parts.size() < 2)
        return text;
    const char* separator = " (";
    for (const ReportForecast::Part& part : forecast.parts) {
        text += separator + std::string(wordOf(part.part)) + " " + durationText(part.seconds);
        separator = ", ";
    }
    return text + ")";
}

} // namespace mirrorball
