#include "command.h"

#include "core/base/error.h"
#include "core/filter/source_file.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/preview/paraboloid_blur.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <type_traits>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, out, lobe, to, from, method = "auto", stats;
    std::optional<double> exponent, roughness, alpha, lambda;
    std::optional<int> samples;
    std::optional<std::string> mipFiltering;
    std::map<std::string, std::string> paraboloid; ///< by option, as typed
    int size = 0, border = 0, threads = 0;
    double yawDeg = 0.0, tolerance = 1e-5;
    bool toleranceGiven = false, mips = false, half = false, explain = false;
};

void refuse(bool given, const std::string& option, const std::string& because)
{
    if (given)
        throw InvalidArgument(option + ": " + because);
}

/// The lobe the options ask for; empty for a ggx chain, whose levels each have their own.
std::optional<Lobe> parseLobe(const Options& o)
{
    if (o.lobe == "diffuse") {
        refuse(o.exponent || o.roughness || o.alpha, "--lobe", "diffuse takes no exponent, roughness or alpha");
        return diffuseLobe();
    }
    if (o.lobe == "phong") {
        refuse(o.alpha.has_value(), "--alpha", "belongs to ggx; phong takes --exponent");
        refuse(o.exponent && o.roughness, "--roughness", "given beside --exponent; for phong it is 1/exponent, so give one of them");
        if (o.roughness) {
            refuse(!(*o.roughness > 0.0 && *o.roughness <= 1.0), "--roughness", "must lie in (0, 1] for phong, where it is 1/exponent");
            return phongLobe(1.0 / *o.roughness);
        }
        if (!o.exponent)
            throw InvalidArgument("--exponent: is missing; the lobe phong needs it, e.g. --exponent 50");
        if (!(*o.exponent >= 0.0 && *o.exponent <= 1e300))
            throw InvalidArgument("--exponent: must be a finite number of at least 0");
        return phongLobe(*o.exponent);
    }
    if (o.lobe == "ggx") {
        refuse(o.exponent.has_value(), "--exponent", "belongs to phong; ggx takes --roughness or --alpha");
        refuse(o.roughness && o.alpha, "--alpha", "given beside --roughness; it is its square, so give one of them");
        if (o.roughness) {
            refuse(!(*o.roughness >= 0.0 && *o.roughness <= 1.0), "--roughness", "must lie in [0, 1]");
            return ggxLobe(*o.roughness * *o.roughness);
        }
        if (o.alpha) {
            refuse(!(*o.alpha >= 0.0 && *o.alpha <= 1.0), "--alpha", "must lie in [0, 1]");
            return ggxLobe(*o.alpha);
        }
        if (o.mips)
            return std::nullopt;
        throw InvalidArgument("--roughness: is missing; the lobe ggx needs it (or --alpha, or --mips for the whole chain)");
    }
    throw InvalidArgument("--lobe: '" + o.lobe + "' is no lobe; choose phong, diffuse or ggx");
}

MipFiltering parseMipFiltering(const std::string& word)
{
    const auto known = words(MipFiltering{});
    for (size_t i = 0; i < known.size(); ++i)
        if (known[i] == word)
            return static_cast<MipFiltering>(i);
    throw InvalidArgument("--mip-filtering: '" + word + "' is none; choose across-seams or per-face");
}

std::string optionOf(const Field& field)
{
    std::string option = "--" + std::string(field.name);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

/// Puts what was typed into a knob.
struct KnobParser {
    const std::map<std::string, std::string>& typed;

    template <typename Value>
    void operator()(const Field& field, Value& value) const
    {
        const auto given = typed.find(optionOf(field));
        if (given == typed.end() || given->second.empty())
            return;
        if constexpr (std::is_enum_v<Value>) {
            std::string known;
            for (size_t i = 0; i < words(Value{}).size(); ++i) {
                if (words(Value{})[i] == given->second) {
                    value = static_cast<Value>(i);
                    return;
                }
                known += (known.empty() ? "" : " or ") + std::string(words(Value{})[i]);
            }
            throw InvalidArgument(given->first + ": '" + given->second + "' is none; choose " + known);
        } else {
            std::istringstream text(given->second);
            double number = 0.0;
            const bool isNumber = (text >> number) && text.eof();
            if (!isNumber || !(number >= field.low && number <= field.high) ||
                (std::is_integral_v<Value> && number != std::floor(number))) {
                std::ostringstream message;
                message << given->first << ": must be " << (std::is_integral_v<Value> ? "a whole number" : "a number") << " from "
                        << field.low << " to " << field.high << "; it is '" << given->second << "'";
                throw InvalidArgument(message.str());
            }
            value = static_cast<Value>(number);
        }
    }
};

/// One filter job a level.
std::vector<PrefilterOptions> parseJobs(const Options& o)
{
    const auto method = methodFromName(o.method);
    if (!method) {
        std::string known;
        for (const Method m : allMethods)
            known += (known.empty() ? "" : ", ") + std::string(name(m));
        throw InvalidArgument("--method: '" + o.method + "' is no method; choose one of " + known);
    }
    refuse(o.samples && *method != Method::Importance, "--samples", "belongs to --method importance, not to '" + o.method + "'");
    refuse(o.lambda && *method != Method::Mip, "--lambda", "belongs to --method mip, not to '" + o.method + "'");
    refuse(o.mipFiltering && *method != Method::Mip, "--mip-filtering", "belongs to --method mip, not to '" + o.method + "'");
    MethodKnobs knobs{.lambda = o.lambda};
    if (o.samples)
        knobs.samples = *o.samples;
    if (o.mipFiltering)
        knobs.mipFiltering = parseMipFiltering(*o.mipFiltering);
    for (const auto& [option, value] : o.paraboloid)
        refuse(!value.empty() && *method != Method::Paraboloid, option, "belongs to --method paraboloid, not to '" + o.method + "'");
    ParaboloidKnobs::visitFields(knobs.paraboloid, KnobParser{o.paraboloid});
    refuse(o.toleranceGiven && !keepsTolerance(*method), "--tolerance",
           "'" + o.method + "' promises none; leave it out, or take auto, spectral, direct, hierarchical or reference");
    if (!(o.tolerance > 0.0 && o.tolerance <= 1.0))
        throw InvalidArgument("--tolerance: must lie in (0, 1]");
    const MapLayout base{.kind = parseKind("--to", o.to), .size = o.size, .border = o.border};
    validate(base);
    const std::optional<Lobe> lobe = parseLobe(o);
    const int levels = o.mips ? levelCount(base) : 1;
    std::vector<PrefilterOptions> jobs;
    for (int i = 0; i < levels; ++i) {
        const double r = chainRoughness(i, levels);
        jobs.push_back({.lobe = lobe ? *lobe : ggxLobe(r * r),
                        .target = levelLayout(base, i),
                        .method = *method,
                        .tolerance = o.tolerance,
                        .yaw = radians(o.yawDeg),
                        .knobs = knobs});
    }
    return jobs;
}

std::string notPromised(const PrefilterOptions& options, const PrefilterOutcome& outcome)
{
    std::ostringstream text;
    text.precision(2);
    text << "filter: " << describe(options.lobe) << " by '" << name(outcome.method) << "' is not promised; predicted are rel_rms "
         << outcome.predictedError << ", median_rel " << outcome.predictedMedianRel << ", p99_rel " << outcome.predictedP99Rel;
    return text.str();
}

std::string sizeText(const MapLayout& layout)
{
    std::ostringstream text;
    text << name(layout.kind) << ' ' << layout.width() << " x " << layout.height();
    return text.str();
}

void run(const Options& o)
{
    const std::vector<PrefilterOptions> jobs = parseJobs(o);
    checkMapFile(o.out, jobs.front().target);
    ReadProbeOptions read;
    if (!o.from.empty())
        read.from = parseKind("--from", o.from);
    const JobControl job = jobWithProgress("filter", o.threads);
    Stats stats{.threads = job.threadCount()};
    OpenedSource opened = openFilterSource(o.probe, read, jobs, job, stats.stages);
    opened.source.useParaboloidDevice(std::make_shared<preview::ParaboloidBlur>()); // starts no GPU before it is asked

    if (o.explain) {
        std::vector<Stage> plan = stats.stages;
        for (const PrefilterOptions& options : jobs) {
            const PrefilterPlan p = settlePrefilter(opened.source, options, job);
            std::ostringstream why;
            why.precision(3);
            if (p.filtered)
                why << "to " << sizeText(options.target) << " by " << name(p.method) << ": " << p.why;
            else
                why << p.why;
            if (p.filtered && p.method == Method::Spectral)
                why << "; band limit " << p.bandLimit;
            if (p.filtered)
                why << (p.promised ? "; promised: " : "; not promised: ") << "rel_rms " << p.predictedError << ", median_rel "
                    << p.predictedMedianRel << ", p99_rel " << p.predictedP99Rel << " predicted";
            plan.push_back({.name = "filter " + describe(options.lobe),
                            .leftOut = !p.filtered,
                            .why = why.str(),
                            .expected = {p.predictedSeconds, std::int64_t{12} * options.target.width() * options.target.height()}});
        }
        if (!o.mips)
            plan.push_back({.name = "mip levels", .leftOut = true, .why = "not asked for (--mips)"});
        plan.push_back({.name = "save map", .why = o.out});
        printStages(plan);
    }

    std::vector<EnvironmentMap> maps;
    std::string roughnesses;
    for (const PrefilterOptions& options : jobs) {
        PrefilterOutcome outcome = prefilter(opened.source, options, job);
        for (Stage& stage : outcome.stages) {
            stage.name += jobs.size() > 1 ? " " + describe(options.lobe) : "";
            stats.stages.push_back(std::move(stage));
        }
        if (outcome.filtered) {
            stats.method = name(outcome.method);
            stats.promised = stats.promised && outcome.promised;
            if (!outcome.promised)
                std::cerr << notPromised(options, outcome) << '\n';
        }
        stats.bandLimit = std::max(stats.bandLimit, outcome.bandLimit);
        stats.predicted = largest(stats.predicted, {outcome.predictedError, outcome.predictedMedianRel, outcome.predictedP99Rel});
        maps.push_back(std::move(outcome.map));
        roughnesses += (roughnesses.empty() ? "" : " ") + describe(options.lobe);
    }
    if (stats.method.empty())
        stats.method = "lookup";
    WriteOptions write{.sampleType = o.half ? SampleType::Half : SampleType::Float};
    write.attributes["mirrorball:lobes"] = roughnesses;
    write.attributes["mirrorball:indexed_by"] = jobs.front().lobe.kind == LobeKind::Diffuse ? "normal" : "reflection";
    timedStage(stats.stages, "save map", [&] { writeMap(o.out, maps, write); });
    if (!o.stats.empty())
        writeStats(o.stats, stats);
}

} // namespace

void addFilterCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("filter", "Prefilter a probe with a lobe");
    command->add_option("PROBE", o->probe, "file or builtin:NAME")->required();
    command->add_option("-o,--output", o->out, "output file; %s in the name of a cube makes six files, %d one file a level")->required();
    command->add_option("--lobe", o->lobe, "phong, diffuse or ggx")->required();
    command->add_option("--exponent", o->exponent, "phong: exponent, at least 0");
    command->add_option("--roughness", o->roughness, "ggx: alpha is its square; phong: the exponent is its inverse");
    command->add_option("--alpha", o->alpha, "ggx: width in [0, 1]; 0 is a mirror");
    command->add_option("--to", o->to, "parameterization of the output (KIND)")->required();
    command->add_option("--size", o->size, "face edge, disc edge, latlong height or octahedral edge, in texels")->required();
    command->add_option("--from", o->from, "parameterization of the input, where it is not to be found out (KIND)");
    command->add_option("--yaw", o->yawDeg, "turn the environment about +Y, counterclockwise from above, in degrees");
    command->add_option("--border", o->border, "texels kept free outside each disc of a paraboloid map");
    command->add_flag("--mips", o->mips,
                      "every mip level, down to one texel; ggx without a roughness makes the chain of roughness 0 to 1 from base to top");
    command->add_option("--method", o->method, "auto, reference, spectral, direct, hierarchical, importance, paraboloid, mip or sh9");
    CLI::Option* tolerance = command->add_option(
        "--tolerance", o->tolerance,
        "what is promised, in (0, 1]: rel_rms and median_rel against the reference sum, five times it for p99_rel, and no negative light");
    command->add_option("--samples", o->samples, "importance: samples of the lobe a texel (1024)");
    command->add_option("--lambda", o->lambda, "mip: least level of detail of the environment; without it matched to the lobe by width");
    command->add_option("--mip-filtering", o->mipFiltering, "mip: across-seams, or per-face as the hardware of 2002 did");
    ParaboloidKnobs knobs;
    ParaboloidKnobs::visitFields(knobs, [&](const Field& field, auto&) {
        command->add_option(optionOf(field), o->paraboloid[optionOf(field)], std::string(field.help));
    });
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(CLI::Range(0, 1024));
    command->add_flag("--half", o->half, "16-bit floats (.exr, .tif)");
    command->add_flag("--explain", o->explain, "print what is done, what is left out, and why; then do it");
    command->add_option("--stats", o->stats, "write times, method and predicted error to this JSON file");
    command->callback([o, tolerance] {
        o->toleranceGiven = tolerance->count() > 0;
        run(*o);
    });
}

} // namespace mirrorball::cli
