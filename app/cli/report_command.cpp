#include "command.h"
#include "interrupt.h"
#include "reading_options.h"

#include "core/base/error.h"
#include "core/base/shell_word.h"
#include "core/preview/paraboloid_blur.h"
#include "core/preview/sphere_drawer.h"
#include "core/report/lobe_words.h"
#include "core/report/make_report.h"
#include "core/report/report_files.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string_view>

namespace mirrorball::cli {

namespace {

struct Options {
    ReportOptions report{};
    ReadingOptions reading;
    std::string folder, lobes = "phong:50,ggx:0.3,diffuse", methods, parts, to = "cube";
    int size = 64, threads = 0;
    bool stability = false, quick = false;
};

std::vector<Method> parseMethods(const std::string& words)
{
    if (words.empty())
        return {allMethods.begin(), allMethods.end()};
    std::vector<Method> methods;
    for (const std::string_view word : split(words, ',')) {
        const auto method = methodFromName(word);
        if (!method) {
            std::string known;
            for (const Method m : allMethods)
                known += (known.empty() ? "" : ", ") + std::string(name(m));
            throw InvalidArgument("--methods: '" + std::string(word) + "' is no method; choose among " + known);
        }
        if (std::find(methods.begin(), methods.end(), *method) == methods.end())
            methods.push_back(*method);
    }
    return methods;
}

/// What the device runs on; without a GPU context, why there is none: its measurements will fail with the same words.
std::string deviceName(ParaboloidDevice& device)
{
    try {
        return device.description();
    } catch (const WorkError& error) {
        return error.what();
    }
}

/// What measures on a graphics card, or on what stands in for one, where the report needs it.
void useDevices(ReportOptions& options)
{
    const bool runsParaboloid = std::find(options.methods.begin(), options.methods.end(), Method::Paraboloid) != options.methods.end() &&
                                (options.has(ReportPart::Methods) || options.has(ReportPart::Growth) || options.has(ReportPart::Stability));
    if (runsParaboloid || options.has(ReportPart::Kernels) || options.has(ReportPart::Comparison)) {
        options.device = std::make_shared<preview::ParaboloidBlur>();
        options.deviceName = deviceName(*options.device);
    }
    if (options.has(ReportPart::Parameterizations) || options.has(ReportPart::Kernels))
        options.drawer = preview::sphereDrawer();
}

/// The program's own words, as they would be typed again.
std::string typed(int argc, const char* const* argv)
{
    std::string text;
    for (int i = 0; i < argc; ++i)
        text += (i == 0 ? "" : " ") + (i == 0 ? std::string("mirrorball") : shellWord(argv[i]));
    return text;
}

void run(const Options& o, const CLI::App& command)
{
    ReportOptions options = o.report;
    try {
        options.lobes = lobesFromWords(o.lobes);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument("--lobes: " + std::string(error.what()));
    }
    options.methods = parseMethods(o.methods);
    if (!o.parts.empty())
        try {
            options.parts = reportPartsFromWords(o.parts);
        } catch (const InvalidArgument& error) {
            throw InvalidArgument("--parts: " + std::string(error.what()));
        }
    if (o.stability && !options.has(ReportPart::Stability))
        options.parts.push_back(ReportPart::Stability);
    options.reading = o.reading.parse();
    options.target = {.kind = parseKind("--to", o.to), .size = o.size};
    options.version = MIRRORBALL_VERSION;
    if (o.quick) { // a number that was given stays
        const ReportOptions given = options;
        options = quickReport(std::move(options));
        const auto keep = [&](const char* flag, auto member) {
            if (command.count(flag) != 0)
                options.*member = given.*member;
        };
        keep("--repeats", &ReportOptions::repeats);
        keep("--longest", &ReportOptions::longest);
        keep("--directions", &ReportOptions::directions);
        keep("--growth-to", &ReportOptions::growthTo);
    }
    validate(options);
    checkReportFolder(o.folder);

    const Interrupt interrupt; // before the device, whose driver starts threads
    useDevices(options);
    options.foretell = [](const ReportForecast& forecast) {
        std::fprintf(stderr, "mirrorball: report: takes %s\n", describe(forecast).c_str());
    };
    JobControl job = jobWithProgress("report", o.threads);
    job.stop = interrupt.token();
    const Report report = makeReport(options, job);
    job.progress = nullptr; // clears the bar before anything is printed
    const std::vector<std::filesystem::path> files = writeReport(report, o.folder);
    for (const std::filesystem::path& file : files)
        std::printf("%s\n", file.string().c_str());
    if (!report.complete)
        throw WorkError("stopped: " + files.front().string() + " holds what was measured until then");
}

} // namespace

void addReportCommand(CLI::App& program, int argc, const char* const* argv)
{
    const auto o = std::make_shared<Options>();
    o->report.command = typed(argc, argv);
    CLI::App* command = program.add_subcommand(
        "report", "Measure every filtering method: error against run time, memory, stability; as HTML, JSON and CSV");
    command->add_option("PROBE", o->report.probes, "files or builtin:NAME; none where no part looks at one");
    command->add_option("-o,--output", o->folder, "folder for report.html, report.json and the .csv files; made when missing")->required();
    o->reading.addTo(*command);
    command->add_option("--lobes", o->lobes, "phong:EXPONENT, ggx:ALPHA and diffuse, with commas (" + o->lobes + ")");
    command->add_option("--methods", o->methods, "names with commas; without it all");
    command->add_option(
        "--parts", o->parts,
        "what the report holds, with commas: methods, parameterizations, growth, stability, kernels, distortion, comparison; "
        "without it the first three");
    command->add_option("--to", o->to, "parameterization of the filtered maps (KIND)");
    command->add_option("--size", o->size, "size of the filtered maps, as in filter")->check(anEdge());
    command->add_flag("--stability", o->stability, "add the tables of extreme cases to the parts");
    command->add_flag("--quick", o->quick,
                      "few settings and repeats, a coarse reference, no growth of cost: some seconds for one probe and one lobe");
    ReportOptions::visitFields(o->report, [&](const Field& field, auto& member) {
        std::string help(field.help);
        if (!field.unit.empty())
            help += " (" + std::string(field.unit) + ")";
        command->add_option("--" + std::string(field.name), member, help + "; " + shortNumber(static_cast<double>(member)))
            ->check(within(field.low, field.high));
    });
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->callback([o, command] { run(*o, *command); });
}

} // namespace mirrorball::cli
