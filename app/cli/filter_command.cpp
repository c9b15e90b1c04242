#include "command.h"
#include "engine_words.h"
#include "filter_brdf.h"
#include "frames.h"
#include "reading_options.h"

#include "core/base/error.h"
#include "core/base/field_json.h"
#include "core/engine/filter_chain.h"
#include "core/filter/lobe_row.h"
#include "core/image/map_file.h"
#include "core/image/mip_pyramid.h"
#include "core/preview/paraboloid_blur.h"
#include "core/scene/file_filter.h"
#include "core/scene/scene_kinds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <type_traits>
#include <utility>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string probe, out, lobe, to, method = "auto", stats, law, engine, encode, frames;
    ReadingOptions reading;
    std::optional<int> levels;
    std::optional<double> exponent, roughness, alpha, lambda;
    std::optional<int> samples;
    std::optional<std::string> mipFiltering;
    std::map<std::string, std::string> knobs; ///< the others, by option, as typed
    int size = 0, border = 0, threads = 0;
    double yawDeg = 0.0, azimuthDeg = 0.0;
    std::optional<double> viewDeg, tolerance; ///< tolerance: 1e-5 of a lobe
    std::string brdf{};
    bool mips = false, half = false, explain = false;
};

void refuse(bool given, const std::string& option, const std::string& because)
{
    if (given)
        throw InvalidArgument(option + ": " + because);
}

/// "phong, diffuse or ggx": those that a word makes.
std::string lobeWords()
{
    std::vector<std::string_view> words;
    for (const LobeRow& row : lobeRows)
        if (row.make)
            words.push_back(row.word);
    return field_json::listed(words);
}

Lobe parsePhong(const Options& o)
{
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

std::optional<Lobe> parseGgx(const Options& o)
{
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

/// The lobe the options ask for; empty for a ggx chain, whose levels each have their own.
std::optional<Lobe> parseLobe(const Options& o)
{
    const auto row = std::find_if(lobeRows.begin(), lobeRows.end(), [&](const LobeRow& r) { return r.make && r.word == o.lobe; });
    if (row != lobeRows.end())
        switch (row->kind) {
        case LobeKind::Phong:
            return parsePhong(o);
        case LobeKind::Diffuse:
            refuse(o.exponent || o.roughness || o.alpha, "--lobe", "diffuse takes no exponent, roughness or alpha");
            return diffuseLobe();
        case LobeKind::Ggx:
            return parseGgx(o);
        case LobeKind::Tabulated: // no word makes one
            break;
        }
    throw InvalidArgument("--lobe: '" + o.lobe + "' is no lobe; choose " + lobeWords());
}

MipFiltering parseMipFiltering(const std::string& word)
{
    const auto known = words(MipFiltering{});
    for (size_t i = 0; i < known.size(); ++i)
        if (known[i] == word)
            return static_cast<MipFiltering>(i);
    throw InvalidArgument("--mip-filtering: '" + word + "' is none; choose across-seams or per-face");
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
            const std::optional<Value> known = fromWord<Value>(given->second);
            if (!known)
                throw InvalidArgument(given->first + ": '" + given->second + "' is none; choose " + field_json::listed(words(Value{})));
            value = *known;
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

/// Knobs whose values are checked as they are typed; the others are read by KnobParser.
bool isTyped(const Field& knob) { return knob.name == "samples" || knob.name == "lambda" || knob.name == "mip_filtering"; }

/// Refuses knobs that belong to another method.
void checkKnobs(const Options& o, Method method)
{
    std::map<std::string, bool> given{
        {"--samples", o.samples.has_value()}, {"--lambda", o.lambda.has_value()}, {"--mip-filtering", o.mipFiltering.has_value()}};
    for (const auto& [option, value] : o.knobs)
        given[option] = !value.empty();
    const MethodKnobs knobs;
    MethodKnobs::visitFields(knobs, [&](const Field& field, const auto&) {
        const std::string option = optionOf(field);
        refuse(given.at(option) && !hasKnob(method, field.name), option,
               "belongs to --method " + ownersOf(field.name) + ", not to '" + o.method + "'");
    });
}

/// How many levels are made: one, all of them (--mips), or as many as --levels says of a chain by --law.
int chainLength(const Options& o, const MapLayout& base)
{
    refuse(o.levels && o.law.empty(), "--levels", "belongs to --law, whose chain it counts; give one, e.g. --law filament");
    if (o.law.empty())
        return o.mips ? levelCount(base) : 1;
    refuse(!o.lobe.empty() && o.lobe != "ggx", "--lobe", "is ggx for every --law; leave it out");
    refuse(o.roughness || o.alpha || o.exponent, "--law",
           "says the roughness of every level; leave --roughness, --alpha and --exponent out");
    const int most = levelCount(base);
    if (o.levels && (*o.levels < 2 || *o.levels > most))
        throw InvalidArgument("--levels: a chain from " + std::to_string(base.size) + " texels has 2 to " + std::to_string(most) +
                              " levels; it is " + std::to_string(*o.levels));
    return o.levels.value_or(most);
}

/// One filter job a level.
std::vector<PrefilterOptions> parseJobs(const Options& o, double yaw)
{
    const auto method = methodFromName(o.method);
    if (!method) {
        throw InvalidArgument("--method: '" + o.method + "' is no method; choose one of " + field_json::listed(words(Method{})));
    }
    checkKnobs(o, *method);
    MethodKnobs knobs{.lambda = o.lambda};
    if (o.samples)
        knobs.samples = *o.samples;
    if (o.mipFiltering)
        knobs.mipFiltering = parseMipFiltering(*o.mipFiltering);
    MethodKnobs::visitFields(knobs, KnobParser{o.knobs});
    refuse(o.tolerance && !keepsTolerance(*method), "--tolerance",
           "'" + o.method + "' promises none; leave it out, or take auto, spectral, direct, hierarchical or reference");
    const double tolerance = o.tolerance.value_or(1e-5);
    if (!(tolerance > 0.0 && tolerance <= 1.0))
        throw InvalidArgument("--tolerance: must lie in (0, 1]");
    const MapLayout base = parseTarget(o.to, o.size, o.border).layout;
    const std::optional<Lobe> lobe = o.law.empty() ? parseLobe(o) : std::nullopt;
    const std::optional<RoughnessLaw> law = o.law.empty() ? std::nullopt : std::optional(lawOfEngine(o.law));
    const int levels = chainLength(o, base);
    PrefilterOptions first;
    first.target = base;
    first.method = *method;
    first.tolerance = tolerance;
    first.yaw = yaw + radians(engineTurn(o.engine, base.kind).yawDeg);
    first.knobs = knobs;
    return filterChain(first, lobe, law, levels);
}

void runBrdf(const Options& o)
{
    refuse(!o.lobe.empty(), "--lobe", "given beside --brdf; give one of them");
    refuse(o.exponent || o.roughness || o.alpha, "--brdf", "takes its parameters in its own text, e.g. --brdf ggx:alpha=0.1");
    refuse(o.samples || o.lambda || o.mipFiltering, "--brdf",
           "takes none of the lobes' methods; choose sum, stack, lookups:K or split-sum");
    refuse(o.mips, "--mips", "is a chain of lobes; --brdf makes one map");
    refuse(!o.law.empty() || !o.engine.empty() || !o.encode.empty(), "--brdf", "takes no --law, --for and --encode");
    filterByBrdf({.probe = o.probe,
                  .out = o.out,
                  .brdf = o.brdf,
                  .to = o.to,
                  .stats = o.stats,
                  .reading = o.reading.parse(),
                  .method = o.method,
                  .viewDeg = o.viewDeg,
                  .tolerance = o.tolerance,
                  .azimuthDeg = o.azimuthDeg,
                  .yawDeg = o.yawDeg,
                  .size = o.size,
                  .border = o.border,
                  .threads = o.threads,
                  .half = o.half,
                  .explain = o.explain});
}

void runOne(const Options& o, const JobControl& job)
{
    refuse(o.lobe.empty() && o.law.empty(), "--lobe",
           "is missing; give phong, diffuse or ggx, a BRDF by --brdf, or an engine's chain by --law");
    refuse(o.viewDeg.has_value(), "--view", "belongs to --brdf");
    const ReadingAndYaw apart = yawApart(o.reading.parse());
    const std::vector<PrefilterOptions> levels = parseJobs(o, radians(o.yawDeg + apart.yawDeg));
    checkMapFile(o.out, levels.front().target);
    const int faceBorder = parseTarget(o.to, o.size, o.border).faceBorder;
    const ByteEncoding bytes = parseEncode(o.encode, o.out);
    std::vector<MapLayout> layouts;
    for (const PrefilterOptions& level : levels)
        layouts.push_back(level.target);
    checkOutputsDiffer({{"--output", mapFiles(o.out, layouts, faceBorder)}, {"--stats", filesOf(o.stats)}});
    PlannedFileFilter planned = planFileFilter({.probe = o.probe,
                                                .read = {.reading = apart.reading},
                                                .levels = levels,
                                                .file = o.out,
                                                .device = std::make_shared<preview::ParaboloidBlur>()}, // starts no GPU before it is asked
                                               job);
    const std::vector<Stage> plan = planned.plan.stages();
    if (o.explain)
        printStages(plan);
    BuiltMap built = filterFile(std::move(planned), job);
    WorkRecord& record = built.record;
    printNotes(o.probe, record.notes);
    sayUnpromised("filter", record);

    store(built.levels, engineTurn(o.engine, levels.front().target.kind).orientation);
    const WriteOptions write{.sampleType = o.half ? SampleType::Half : SampleType::Float,
                             .attributes = filterAttributes(levels),
                             .bytes = bytes,
                             .faceBorder = faceBorder};
    timedStage(record.stages, "save map", [&] { writeMap(o.out, built.levels, write); });
    if (!o.stats.empty())
        writeStats(o.stats, plan, record, job.threadCount());
}

void run(const Options& o)
{
    if (!o.brdf.empty()) {
        refuse(!o.frames.empty(), "--frames", "belongs to lobes, not to --brdf");
        runBrdf(o);
        return;
    }
    if (o.frames.empty()) {
        runOne(o, jobWithProgress("filter", o.threads));
        return;
    }
    refuse(o.explain, "--explain", "explains one frame; leave out --frames");
    forFrames(o.frames, {o.out, o.stats}, o.threads, FramesAtOnce::PerCore, [&](int frame, const JobControl& job) {
        Options one = o;
        for (std::string* name : {&one.probe, &one.out, &one.stats})
            *name = withFrame(*name, frame);
        runOne(one, job);
    });
}

/// A line for each method, below the options.
std::string methodHelp()
{
    std::string text = "Methods:";
    for (const Method method : allMethods) {
        const std::string word(name(method));
        text += "\n  " + word + std::string(14 - word.size(), ' ') + std::string(helpOf(method));
    }
    return text;
}

} // namespace

void addFilterCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("filter", "Prefilter a probe with a lobe");
    command->add_option("PROBE", o->probe, "file, builtin:NAME, or a spectrum made by `mirrorball spectrum`")->required();
    command->add_option("-o,--output", o->out, outputHelp)->required();
    command->add_option("--lobe", o->lobe, lobeWords() + "; ggx with --law");
    command->add_option("--law", o->law,
                        "a chain of ggx levels whose roughness follows this engine: three, filament, babylon, playcanvas, "
                        "bevy, unity, unreal");
    command->add_option("--levels", o->levels, "of the chain by --law; without it down to one texel");
    command->add_option("--for", o->engine, "turn and mirror the map as this engine looks it up (latlong or cube)");
    command->add_option("--encode", o->encode, "of 8-bit formats: filmic (as without it), srgb, or in a .png rgbe, rgbm, rgbd, rgbp");
    command->add_option("--brdf", o->brdf, "in place of a lobe: MODEL[:key=value,...] or a measured file, as `mirrorball brdf` takes it");
    command->add_option("--view", o->viewDeg, "brdf: the angle between normal and view, in degrees")->check(within(0, 90));
    command->add_option("--azimuth", o->azimuthDeg, "brdf: of the normal about r, 0 where it lies towards +Y of r's meridian, in degrees")
        ->check(anAngle());
    command->add_option("--exponent", o->exponent, "phong: exponent, at least 0")->check(within(0, 1e300));
    command->add_option("--roughness", o->roughness, "ggx: alpha is its square; phong: the exponent is its inverse")->check(within(0, 1));
    command->add_option("--alpha", o->alpha, "ggx: width in [0, 1]; 0 is a mirror")->check(within(0, 1));
    command->add_option("--to", o->to, "parameterization of the output (KIND)")->required();
    command->add_option("--size", o->size, "face edge, disc edge, latlong height or octahedral edge, in texels")
        ->check(anEdge())
        ->required();
    o->reading.addTo(*command);
    command->add_option("--yaw", o->yawDeg, "turn the environment about +Y, counterclockwise from above, in degrees")->check(anAngle());
    command->add_option("--border", o->border, borderHelp)->check(within(0, 4096));
    command->add_flag("--mips", o->mips,
                      "every mip level, down to one texel; ggx without a roughness makes the chain of roughness 0 to 1 from base to top");
    command->add_option("--method", o->method,
                        field_json::listed(words(Method{})) +
                            "; brdf: sum, stack, lookups:K, split-sum, three, filament, round or warp:DEG");
    command
        ->add_option("--tolerance", o->tolerance,
                     "what is promised, in (0, 1]: rel_rms and median_rel against the reference sum, five times it for p99_rel, and no "
                     "negative light")
        ->check(above(0, 1));
    command->add_option("--samples", o->samples, "importance: samples of the lobe a texel (1024)")->check(within(1, 1 << 20));
    command->add_option("--lambda", o->lambda, "mip: least level of detail of the environment; without it matched to the lobe by width")
        ->check(within(0, 32));
    command->add_option("--mip-filtering", o->mipFiltering, "mip: across-seams, or per-face as the hardware of 2002 did");
    const MethodKnobs knobs;
    MethodKnobs::visitFields(knobs, [&](const Field& field, const auto&) {
        if (!isTyped(field))
            command->add_option(optionOf(field), o->knobs[optionOf(field)], std::string(field.help));
    });
    command->add_option("--frames", o->frames, "make every frame of a sequence, FIRST-LAST; #### in names stands for the frame's number");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->add_flag("--half", o->half, "16-bit floats, where the format has them");
    command->add_flag("--explain", o->explain, "print what is done, what is left out, and why; then do it");
    command->add_option("--stats", o->stats, "write times, method and predicted error to this JSON file");
    command->footer(methodHelp() + "\n\n" + program.get_footer());
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
