#include "command.h"
#include "frames.h"

#include "core/base/error.h"
#include "core/image/image_format.h"
#include "core/image/map_file.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "core/spheremap/evaluation/matcap_passes.h"
#include "core/spheremap/evaluation/painted_files.h"

#include <algorithm>
#include <iterator>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string document, out, saved, stats, frames;
    int size = 512, border = 0, threads = 0;
    std::vector<std::string> specular;
    bool levels = false, half = false;
};

SphereMapDocument findDocument(const std::string& word)
{
    if (const SphereMapPreset* preset = findSphereMapPreset(word))
        return preset->document;
    if (word.find_first_of("./\\") != std::string::npos)
        return loadSphereMap(word);
    std::string known;
    for (const SphereMapPreset& preset : sphereMapPresets())
        known += (known.empty() ? "" : ", ") + preset.name;
    throw InvalidArgument("'" + word + "' is neither a sphere map file nor a preset (" + known + ")");
}

void runOne(const Options& o, const JobControl& job)
{
    if (!o.specular.empty())
        passFormat(o.out);
    checkMapFile(o.out, {Parameterization::Sphere, std::max(o.size, 1), 0});
    const MapLayout layout{.kind = Parameterization::Sphere, .size = o.size};
    if (!o.levels)
        checkOutputsDiffer({{"--output", mapFiles(o.out, {layout})}, {"--save-document", filesOf(o.saved)}, {"--stats", filesOf(o.stats)}});
    else
        checkOutputsDiffer({{"--output", {o.out}}, {"--save-document", filesOf(o.saved)}, {"--stats", filesOf(o.stats)}});
    std::vector<Stage> stages;
    const SphereMapDocument document = timedStage(stages, "read document", [&] { return findDocument(o.document); });
    if (o.size <= 2 * o.border)
        throw InvalidArgument("--border: must leave room for the map between the borders of a picture of " + std::to_string(o.size) +
                              " texels; it is " + std::to_string(o.border));
    const auto writeTheRest = [&] { // once all went well
        if (!o.saved.empty())
            saveSphereMap(document, o.saved);
        if (!o.stats.empty())
            writeStats(o.stats, {}, {.stages = stages, .methods = {"paint"}}, job.threadCount());
    };
    if (!o.specular.empty()) {
        const MatcapPasses passes =
            timedStage(stages, "evaluate", [&] { return evaluatePasses(document, o.specular, {.size = o.size - 2 * o.border}, job); });
        timedStage(stages, "write map", [&] {
            writePasses(o.out, {{"diffuse", bordered(passes.diffuse, o.border)}, {"specular", bordered(passes.specular, o.border)}},
                        paintedFileOptions(document, o.half ? SampleType::Half : SampleType::Float));
        });
        writeTheRest();
        return;
    }
    const PaintedOptions options{.size = o.size, .border = o.border, .levels = o.levels ? PaintedLevels::Authored : PaintedLevels::One};
    PaintedFiles painted = writePainted(o.out, document, options, o.half ? SampleType::Half : SampleType::Float, job);
    stages.insert(stages.end(), std::make_move_iterator(painted.stages.begin()), std::make_move_iterator(painted.stages.end()));
    writeTheRest();
}

void run(const Options& o)
{
    if (o.frames.empty()) {
        runOne(o, jobWithProgress("paint", o.threads));
        return;
    }
    forFrames(o.frames, {o.out, o.saved, o.stats}, o.threads, FramesAtOnce::PerCore, [&](int frame, const JobControl& job) {
        Options one = o;
        for (std::string* name : {&one.document, &one.out, &one.saved, &one.stats})
            *name = withFrame(*name, frame);
        runOne(one, job);
    });
}

} // namespace

void addPaintCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("paint", "Evaluate a sphere map: a document, a preset, or recorded strokes");
    command->add_option("DOCUMENT", o->document, ".spheremap file or preset; `mirrorball presets` lists them")->required();
    command
        ->add_option("-o,--output", o->out,
                     "output file: .exr and .tif keep linear light, .png shows it clipped; %d in the name: one file a level")
        ->required();
    command->add_option("--size", o->size, "edge of the map, in texels")->check(anEdge())->required();
    CLI::Option* levels = command->add_flag(
        "--levels", o->levels,
        "the whole mip chain, as the document makes it: in one .exr or .tif, else NAME.LEVEL.EXT, or where the name has a %d");
    command
        ->add_option(
            "--border", o->border,
            "texels between the disc and the picture's edge, in the rim's colors; Blender looks 0.8 percent inside the edge, 2 at 512")
        ->check(within(0, 4096))
        ->excludes(levels);
    command
        ->add_option("--specular", o->specular,
                     "names of layers: write two passes as Blender's matcaps have them, these layers and the rest, into one .exr")
        ->delimiter(',')
        ->excludes(levels);
    command->add_flag("--half", o->half, "16-bit floats (.exr, .tif)");
    command->add_option("--save-document", o->saved, "also write the document to this .spheremap file, to start from a preset");
    command->add_option("--frames", o->frames, "make every frame of a sequence, FIRST-LAST; #### in names stands for the frame's number");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(aThreadCount());
    command->add_option("--stats", o->stats, "write times to this JSON file");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
