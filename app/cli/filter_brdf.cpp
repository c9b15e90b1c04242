#include "filter_brdf.h"

#include "command.h"
#include "reading_options.h"

#include "core/base/error.h"
#include "core/filter/brdf_stack.h"
#include "core/filter/brdf_sum.h"
#include "core/filter/lookup_table.h"
#include "core/filter/view_warp.h"
#include "core/image/map_file.h"

#include <charconv>
#include <cmath>
#include <sstream>

namespace mirrorball::cli {

namespace {

enum class BrdfMethod { Sum, Stack, Lookups, Round, Warp };

struct MethodChoice {
    BrdfMethod method;
    std::optional<int> number{}; ///< stack: the largest order; warp: degrees between the views
    LookupChoice lookups{};
};

constexpr double usualTolerance = 1e-3; ///< of a stack: a kernel's kink at the horizon makes 1e-5 dear

/// The whole number after the colon.
std::optional<int> numberAfter(const std::string& word, const std::string& name)
{
    if (word.size() < name.size() + 2 || word.compare(0, name.size() + 1, name + ":") != 0)
        return std::nullopt;
    int value = 0;
    const char *first = word.data() + name.size() + 1, *last = word.data() + word.size();
    const auto [end, error] = std::from_chars(first, last, value);
    return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

MethodChoice parseMethod(const std::string& word)
{
    if (word == "sum")
        return {BrdfMethod::Sum};
    if (word == "auto" || word == "stack")
        return {BrdfMethod::Stack};
    if (word == "round")
        return {BrdfMethod::Round};
    if (const auto choice = lookupChoiceFromWord(word))
        return {BrdfMethod::Lookups, {}, *choice};
    if (const auto m = numberAfter(word, "stack"); m && *m >= 0 && *m <= largestStackOrder)
        return {BrdfMethod::Stack, m};
    if (const auto degrees = numberAfter(word, "warp"); degrees && *degrees >= 0 && *degrees < 180)
        return {BrdfMethod::Warp, degrees};
    throw InvalidArgument("--method: '" + word + "' is no method of --brdf; choose sum, stack (or stack:ORDERS, 0 to 40), round, " +
                          "warp:DEG, " + lookupChoiceHelp());
}

struct Made {
    EnvironmentMap map{};
    std::string why{};
    int bandLimit = 0;
    double predictedError = 0.0;
};

std::string lookupText(const LookupFit& fit)
{
    std::ostringstream text;
    text.precision(3);
    for (const BrdfLookup& lookup : fit.lookups)
        text << (text.tellp() > 0 ? "; " : "") << "offset " << lookup.offset * 180.0 / pi << " deg, alpha " << lookup.alpha << ", weight "
             << lookup.weight.r << ' ' << lookup.weight.g << ' ' << lookup.weight.b;
    return text.str();
}

Made make(FilterSource& source, const BrdfFilterOptions& o, const MethodChoice& choice, const Brdf& brdf, const MapLayout& target,
          const JobControl& job)
{
    const SurfaceView seen{radians(*o.viewDeg), radians(o.azimuthDeg)};
    const double yaw = radians(o.yawDeg), tolerance = o.tolerance.value_or(usualTolerance);
    Made made;
    if (choice.method == BrdfMethod::Sum || isUnresolved(ggxLobe(equivalentAlpha(brdf)), source.width())) {
        if (choice.method == BrdfMethod::Sum && !isUnresolved(ggxLobe(equivalentAlpha(brdf)), source.width())) {
            made.map = filterBrdfSum(*source.latlong(), brdf, seen, target, yaw, job);
            made.why = "brute force over every texel";
            return made;
        }
        made.map = EnvironmentMap(target);
        const glm::vec3 albedo(directionalAlbedo(brdf, seen.view));
        for (int y = 0; y < target.height(); ++y)
            for (int x = 0; x < target.width(); ++x) {
                const glm::vec3 value = albedo * source.latlong()->radiance(yawed(texelDirection(target, x, y), -yaw));
                for (int c = 0; c < 3; ++c)
                    made.map.image.texel(x, y)[c] = value[c];
            }
        made.why = "the lobe is narrower than the probe's texels: a lookup times the albedo";
        return made;
    }
    if (choice.method == BrdfMethod::Stack || choice.method == BrdfMethod::Round) {
        const bool isRound = choice.method == BrdfMethod::Round;
        const StackPlan plan = choice.number || isRound ? planStack(brdf, seen.view, tolerance, choice.number.value_or(0), source, job)
                                                        : planStack(brdf, seen.view, tolerance, source, job);
        if (o.tolerance && !choice.number && !isRound && plan.predictedError > tolerance)
            throw InvalidArgument("--tolerance: degrees to " + std::to_string(largestStackDegree) + " and orders to " +
                                  std::to_string(largestStackOrder) + " leave an error of " + std::to_string(plan.predictedError) +
                                  "; ask for that or take --method sum");
        made.map = filterBrdfStack(source, plan, seen.azimuth, target, yaw, job);
        made.bandLimit = plan.kernel.bandLimit;
        made.predictedError = plan.predictedError;
        made.why = "orders to " + std::to_string(plan.kernel.orders) + ", degrees to " + std::to_string(plan.kernel.bandLimit);
        return made;
    }
    if (choice.method == BrdfMethod::Warp) {
        made.map = filterBrdfWarped(source, brdf, seen, radians(*choice.number), target, yaw, tolerance, job);
        made.predictedError = std::nan("");
        made.why = "the mean of three views " + std::to_string(*choice.number) + " degrees away, each where it mirrors the same direction";
        return made;
    }
    const LookupFit fit = lookupsFor(brdf, seen.view, choice.lookups);
    made.map = filterBrdfLookups(source, fit, seen.azimuth, target, yaw, std::min(tolerance, 1e-3), job);
    made.predictedError = fit.residual;
    made.why = lookupText(fit);
    return made;
}

} // namespace

void filterByBrdf(const BrdfFilterOptions& o)
{
    const MethodChoice choice = parseMethod(o.method);
    if (!o.viewDeg)
        throw InvalidArgument("--view: is missing; --brdf needs the angle between the normal and the view, in degrees");
    if (!(*o.viewDeg >= 0.0 && *o.viewDeg < 90.0))
        throw InvalidArgument("--view: must be at least 0 and below 90 degrees");
    if (!std::isfinite(o.azimuthDeg))
        throw InvalidArgument("--azimuth: must be a finite angle in degrees");
    if (o.tolerance && !(*o.tolerance > 0.0 && *o.tolerance <= 1.0))
        throw InvalidArgument("--tolerance: must lie in (0, 1]");
    const auto [target, faceBorder] = parseTarget(o.to, o.size, o.border);
    checkMapFile(o.out, target);
    const ReadProbeOptions read{.reading = o.reading};
    const Brdf brdf = brdfFromText(o.brdf);

    const JobControl job = jobWithProgress("filter", o.threads);
    Probe probe = readProbe(o.probe, read, partOf(job, 0.0f, 0.2f));
    printNotes(o.probe, probe.notes);
    WorkRecord record{.stages = std::move(probe.stages), .methods = {"brdf " + o.method}};
    FilterSource source(std::move(probe.map), partOf(job, 0.2f, 0.3f));
    Made made;
    timedStage(record.stages, "filter " + describe(brdf), [&] { made = make(source, o, choice, brdf, target, partOf(job, 0.3f, 1.0f)); });
    record.stages.back().why = made.why;
    record.bandLimit = made.bandLimit;
    record.predicted = {made.predictedError, std::nan(""), std::nan("")}; // a tolerance is of a lobe's map
    record.unpromised.push_back("brdf " + o.method);
    WriteOptions write{.sampleType = o.half ? SampleType::Half : SampleType::Float, .faceBorder = faceBorder};
    write.attributes["mirrorball:brdf"] = describe(brdf);
    write.attributes["mirrorball:view"] = std::to_string(*o.viewDeg);
    write.attributes["mirrorball:azimuth"] = std::to_string(o.azimuthDeg);
    write.attributes["mirrorball:indexed_by"] = "reflection";
    if (o.explain)
        printStages(record.stages);
    timedStage(record.stages, "save map", [&] { writeMap(o.out, {made.map}, write); });
    if (!o.stats.empty())
        writeStats(o.stats, {}, record, job.threadCount());
}

} // namespace mirrorball::cli
