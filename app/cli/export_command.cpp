#include "command.h"
#include "frames.h"
#include "reading_options.h"

#include "core/base/error.h"
#include "core/scene/engine_scene_export.h"
#include "core/scene/export.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_maps.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string scene, folder, stats, engine, probe, name, frames;
    std::vector<std::string> only, encode;
    ReadingOptions reading;
    int threads = 0, size = 0;
    double yawDeg = 0.0;
    bool explain = false, zstd = false;
};

/// The scene to export from: a file, or a plain probe, which an engine's files need no more than.
Scene sceneOf(const Options& o)
{
    if (o.probe.empty() && o.scene.empty())
        throw InvalidArgument("SCENE: is missing; name a scene file, or a probe with --probe");
    if (!o.probe.empty() && !o.scene.empty())
        throw InvalidArgument("--probe: given beside the scene '" + shownPath(o.scene) + "', which names its own; leave one of them out");
    const std::filesystem::path extension = std::filesystem::path(o.scene).extension();
    Scene scene;
    if (o.probe.empty() && (o.engine.empty() || extension == ".mirrorball" || extension == ".json"))
        scene = loadScene(o.scene);
    else
        scene.probe.source = o.probe.empty() ? o.scene : o.probe;
    scene.probe.reading = o.reading.parse(scene.probe.reading);
    return scene;
}

EngineExportOptions engineOptions(const Options& o, const EngineProfile& profile)
{
    EngineExportOptions options{.size = o.size, .name = o.name.empty() ? engineExportName(o.folder) : o.name, .compressKtx2 = o.zstd};
    for (const std::string& word : o.encode) {
        if (profile.word == "playcanvas" && (word == "rgbp" || word == "rgbm")) {
            options.atlas = word == "rgbm" ? PackedColor::Rgbm : PackedColor::Rgbp;
            continue;
        }
        const auto formats = allTexelFormats();
        const auto named = [&](TexelFormat format) { return traits(format).name == word; };
        const auto found = std::find_if(formats.begin(), formats.end(), named);
        if (profile.word != "bevy" || found == formats.end())
            throw InvalidArgument("--encode: '" + word + "' is none of " + std::string(profile.title) +
                                  "; PlayCanvas takes rgbp or rgbm, Bevy rgba16f, rgba32f, r11g11b10 or e5b9g9r9, others have one");
        options.texels = *found;
    }
    return options;
}

void runForEngine(const Options& o, const JobControl& job)
{
    const EngineProfile& profile = engineProfile(o.engine);
    if (!o.only.empty())
        throw InvalidArgument("--only: belongs to a scene's own exports; --for writes every file that the engine takes");
    if (o.folder.find('%') != std::string::npos)
        throw InvalidArgument("--output: '" + shownPath(o.folder) +
                              "' has a % in it; --for writes whole containers into a folder, so name one");
    const EngineExportOptions options = engineOptions(o, profile);
    checkedSize(profile, options.size);
    Scene scene = sceneOf(o);
    scene.probe.yawDeg += o.yawDeg;
    if (o.explain) {
        std::vector<Stage> stages;
        for (const EngineFilePlan& file : planEngineExport(profile, options, probeLayout(scene)))
            stages.push_back(
                {.name = file.file,
                 .why = std::string(name(file.content)) +
                        (file.size > 0 ? ", " + std::to_string(file.size) + " texels, levels: " + std::to_string(file.levels) : ""),
                 .expected = {0.0, file.bytes}});
        printStages(stages);
    }
    const EngineExport done = exportForEngine(scene, profile, options, o.folder, job);
    for (const std::filesystem::path& file : done.files)
        std::printf("%s\n", file.string().c_str());
    for (const std::string& warning : done.warnings)
        std::fprintf(stderr, "mirrorball: note: %s\n", warning.c_str());
    if (!o.stats.empty())
        writeStats(o.stats, {}, {.stages = done.stages, .methods = {"auto"}}, job.threadCount());
}

void runOne(const Options& o, const JobControl& job)
{
    if (!o.engine.empty()) {
        runForEngine(o, job);
        return;
    }
    if (o.size != 0 || !o.name.empty() || !o.probe.empty() || !o.encode.empty() || o.zstd || o.yawDeg != 0.0)
        throw InvalidArgument(
            "--size, --name, --probe, --yaw, --encode and --zstd: belong to --for ENGINE; a scene's exports say these themselves");
    const Scene scene = sceneOf(o);
    PlannedScene planned = planExports(scene, {.only = o.only});
    const std::vector<Stage> plan = planned.plan.stages();
    if (o.explain)
        printStages(plan);
    const ExportOutcome outcome = exportPlanned(std::move(planned), o.folder, job);
    printNotes(scene.probe.source, outcome.record.notes);
    sayUnpromised("export", outcome.record);
    for (const std::filesystem::path& file : outcome.files)
        std::printf("%s\n", file.string().c_str());
    if (!o.stats.empty())
        writeStats(o.stats, plan, outcome.record, job.threadCount());
}

void run(const Options& o)
{
    if (o.frames.empty()) {
        runOne(o, jobWithProgress("export", o.threads));
        return;
    }
    forFrames(o.frames, {o.folder, o.stats}, o.threads, FramesAtOnce::One, [&](int frame, const JobControl& job) {
        Options one = o;
        for (std::string* name : {&one.scene, &one.folder, &one.stats, &one.probe, &one.name})
            *name = withFrame(*name, frame);
        runOne(one, job);
    });
}

} // namespace

void addExportCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("export", "Write the maps that a scene lists, each with a description beside it");
    command->add_option("SCENE", o->scene, "scene file (.mirrorball); with --for also a probe");
    command->add_option("-o,--output", o->folder, "folder for the files; made when missing")->required();
    command->add_option("--only", o->only, "names of exports; all others are left out");
    std::string known;
    for (const EngineProfile& profile : engineProfiles())
        known += (known.empty() ? "" : ", ") + std::string(profile.word);
    command->add_option("--for", o->engine, "write the light as this engine takes it: " + known);
    command->add_option("--probe", o->probe, "with --for: a probe in place of a scene");
    command->add_option("--size", o->size, "with --for: edge of the largest cube face, or height of the latlong, in texels")
        ->check(anEdge());
    command->add_option("--name", o->name, "with --for: names the files; the folder's name where it is left out");
    command->add_option("--yaw", o->yawDeg, "with --for: turns the environment about +Y, counterclockwise from above, in degrees")
        ->check(anAngle());
    o->reading.addTo(*command);
    command->add_option("--encode", o->encode, "with --for playcanvas: rgbp or rgbm; bevy: rgba16f, rgba32f, r11g11b10 or e5b9g9r9");
    command->add_flag("--zstd", o->zstd, "with --for: compress .ktx2 files with Zstandard");
    command->add_option("--frames", o->frames, "make every frame of a sequence, FIRST-LAST; #### in names stands for the frame's number");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->add_flag("--explain", o->explain, "print what is done, what is left out, and why; then do it");
    command->add_option("--stats", o->stats, "write times, method and predicted error to this JSON file");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
