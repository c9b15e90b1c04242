#include "brdf_errors.h"

#include "curve_picture.h"
#include "error_metrics.h"

#include "core/base/error.h"
#include "core/filter/brdf_sum.h"
#include "core/filter/lookup_table.h"
#include "core/image/reproject.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

constexpr double azimuths[] = {0.7, 3.9};
constexpr double tolerance = 1e-3; ///< of the filtered maps; far below what is measured

void check(const BrdfErrorOptions& o)
{
    if (o.choices.empty() || o.viewsDeg.empty())
        throw InvalidArgument("errors: at least one angle of view and one choice of lookups are needed");
    for (const double view : o.viewsDeg)
        if (!(view >= 0.0 && view < 90.0))
            throw InvalidArgument("views: must be at least 0 and below 90 degrees");
    if (o.height < 8 || o.height > 1024)
        throw InvalidArgument("height: must be a whole number from 8 to 1024");
}

EnvironmentMap latlongOf(const EnvironmentMap& probe, int height, const JobControl& job)
{
    if (probe.layout.kind == Parameterization::Latlong && probe.layout.size <= height)
        return probe;
    return reproject(probe, {.target = {Parameterization::Latlong, height, 0}}, job);
}

std::string formatted(const char* format, double value)
{
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

} // namespace

BrdfFrames::BrdfFrames(const EnvironmentMap& latlong, const Brdf& brdf, double view, const JobControl& job, int rows)
    : m_layout{Parameterization::Latlong, rows, 0}
{
    for (const double azimuth : azimuths)
        m_truth.push_back(filterBrdfSum(latlong, brdf, {view, azimuth}, m_layout, 0.0, job));
}

double BrdfFrames::relRms(const std::function<EnvironmentMap(double azimuth)>& map) const
{
    double sum = 0.0;
    for (size_t i = 0; i < m_truth.size(); ++i)
        sum += std::pow(errorMetrics(map(azimuths[i]), m_truth[i]).relRms, 2.0);
    return std::sqrt(sum / static_cast<double>(m_truth.size()));
}

BrdfErrors measureBrdfErrors(const EnvironmentMap& probe, const Brdf& brdf, const BrdfErrorOptions& o, const JobControl& job)
{
    check(o);
    if (const int rows = std::min(o.height, probe.layout.kind == Parameterization::Latlong ? probe.layout.size : o.height);
        isUnresolved(ggxLobe(equivalentAlpha(brdf)), 2 * rows))
        throw InvalidArgument("errors: the lobe is narrower than a texel of a probe of " + std::to_string(rows) +
                              " rows: every lookup would show that texel; take a rougher material or more rows");
    const EnvironmentMap latlong = latlongOf(probe, o.height, partOf(job, 0.0f, 0.1f));
    FilterSource source(latlong);
    BrdfErrors errors{.model = describe(brdf), .viewsDeg = o.viewsDeg, .choices = o.choices};
    errors.relRms.assign(o.choices.size(), {});
    for (size_t v = 0; v < o.viewsDeg.size(); ++v) {
        const auto at = [&](double share) {
            return static_cast<float>(0.1 + 0.9 * (static_cast<double>(v) + share) / static_cast<double>(o.viewsDeg.size()));
        };
        const double view = o.viewsDeg[v] * pi / 180.0;
        const BrdfFrames frames(latlong, brdf, view, partOf(job, at(0.0), at(0.5)));
        const JobControl rest = partOf(job, at(0.5), at(1.0));
        for (size_t c = 0; c < o.choices.size(); ++c) {
            job.checkStop();
            const LookupFit fit = lookupsFor(brdf, view, o.choices[c]);
            errors.relRms[c].push_back(frames.relRms(
                [&](double azimuth) { return filterBrdfLookups(source, fit, azimuth, frames.layout(), 0.0, tolerance, rest); }));
        }
    }
    return errors;
}

std::string brdfErrorsText(const BrdfErrors& errors)
{
    constexpr size_t least = 10;
    std::string text = "view";
    const auto cell = [&](const std::string& word, size_t width) {
        text += std::string(width > word.size() ? width - word.size() : 1, ' ') + word;
    };
    for (const LookupChoice& choice : errors.choices)
        cell(describe(choice), std::max(describe(choice).size() + 2, least));
    for (size_t v = 0; v < errors.viewsDeg.size(); ++v) {
        text += '\n';
        const std::string view = formatted("%.4g", errors.viewsDeg[v]);
        text += view + std::string(view.size() < 4 ? 4 - view.size() : 0, ' ');
        for (size_t c = 0; c < errors.choices.size(); ++c)
            cell(formatted("%.4f", errors.relRms[c][v]), std::max(describe(errors.choices[c]).size() + 2, least));
    }
    return text + '\n';
}

std::string brdfErrorsCsv(const BrdfErrors& errors)
{
    std::string text = "model,lookups,view_degrees,rel_rms\r\n";
    for (size_t c = 0; c < errors.choices.size(); ++c)
        for (size_t v = 0; v < errors.viewsDeg.size(); ++v)
            text += '"' + errors.model + "\"," + describe(errors.choices[c]) + ',' + formatted("%.9g", errors.viewsDeg[v]) + ',' +
                    formatted("%.9g", errors.relRms[c][v]) + "\r\n";
    return text;
}

std::string brdfErrorsJson(const BrdfErrors& errors)
{
    nlohmann::ordered_json curves = nlohmann::ordered_json::array();
    for (size_t c = 0; c < errors.choices.size(); ++c)
        curves.push_back({{"lookups", describe(errors.choices[c])}, {"rel_rms", errors.relRms[c]}});
    return nlohmann::ordered_json{{"model", errors.model}, {"view_degrees", errors.viewsDeg}, {"curves", curves}}.dump(2) + '\n';
}

Image brdfErrorsPicture(const BrdfErrors& errors)
{
    CurvePlot plot{.title = errors.model, .xTitle = "angle of view, degrees", .yTitle = "rel_rms", .xTicks = errors.viewsDeg};
    for (size_t c = 0; c < errors.choices.size(); ++c) {
        Curve curve{.label = describe(errors.choices[c]), .color = curveColor(c)};
        for (size_t v = 0; v < errors.viewsDeg.size(); ++v)
            curve.points.emplace_back(errors.viewsDeg[v], errors.relRms[c][v]);
        std::sort(curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
        plot.curves.push_back(std::move(curve));
    }
    return curvePicture(plot);
}

} // namespace mirrorball
