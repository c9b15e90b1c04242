#include "command.h"

#include "core/error.h"
#include "core/image/color.h"
#include "core/image/map_file.h"
#include "core/image/image_io.h"
#include "core/spheremap/evaluate.h"
#include "core/spheremap/matcap_passes.h"
#include "core/spheremap/presets.h"
#include "core/spheremap/sphere_map_file.h"

#include <algorithm>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string document, out, saved, stats;
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

bool isOpaque(const Image& rgba)
{
    for (size_t i = 3; i < rgba.texels.size(); i += 4)
        if (rgba.texels[i] < 1.0f - 1e-6f)
            return false;
    return true;
}

Image withoutOpacity(const Image& rgba)
{
    Image rgb(rgba.width, rgba.height, 3);
    for (size_t i = 0; i < rgb.texels.size() / 3; ++i)
        std::copy_n(&rgba.texels[4 * i], 3, &rgb.texels[3 * i]);
    return rgb;
}

void run(const Options& o)
{
    std::vector<Stage> stages;
    const SphereMapDocument document = timedStage(stages, "read document", [&] { return findDocument(o.document); });
    const JobControl job = jobWithProgress("paint", o.threads);
    if (o.size <= 2 * o.border)
        throw InvalidArgument("--border: must leave room for the map between the borders of a picture of " + std::to_string(o.size) + " texels; it is " +
                              std::to_string(o.border));
    const EvaluateOptions options{.size = o.size - 2 * o.border};
    const std::string index(words(document.index)[static_cast<size_t>(document.index)]);
    const WriteOptions writeOptions{.sampleType = o.half ? SampleType::Half : SampleType::Float,
                                    .attributes = {{"mirrorball:parameterization", "sphere"}, {"mirrorball:index", index}}};
    const auto writeTheRest = [&] { // once all went well
        if (!o.saved.empty())
            saveSphereMap(document, o.saved);
        if (!o.stats.empty())
            writeStats(o.stats, {.stages = stages, .method = "paint", .threads = job.threadCount()});
    };
    if (!o.specular.empty()) {
        const MatcapPasses passes = timedStage(stages, "evaluate", [&] { return evaluatePasses(document, o.specular, options, job); });
        timedStage(stages, "write map", [&] {
            writePasses(o.out, {{"diffuse", bordered(passes.diffuse, o.border)}, {"specular", bordered(passes.specular, o.border)}}, writeOptions);
        });
        writeTheRest();
        return;
    }
    std::vector<Image> levels = timedStage(stages, "evaluate", [&] {
        return o.levels ? evaluateLevels(document, options, job) : std::vector<Image>{bordered(evaluate(document, options, job), o.border)};
    });
    if (std::all_of(levels.begin(), levels.end(), isOpaque))
        std::transform(levels.begin(), levels.end(), levels.begin(), withoutOpacity);
    timedStage(stages, "write map", [&] { writePictures(o.out, levels, writeOptions); });
    writeTheRest();
}

} // namespace

void addPaintCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("paint", "Evaluate a sphere map: a document, a preset, or recorded strokes");
    command->add_option("DOCUMENT", o->document, ".spheremap file or preset; `mirrorball presets` lists them")->required();
    command->add_option("-o,--output", o->out, "output file: .exr and .tif keep linear light, .png shows it clipped")->required();
    command->add_option("--size", o->size, "edge of the map, in texels")->required();
    CLI::Option* levels = command->add_flag("--levels", o->levels, "the whole mip chain, as the document makes it: in one file, or NAME.LEVEL.EXT");
    command
        ->add_option("--border", o->border,
                     "texels between the disc and the picture's edge, in the rim's colours; Blender looks 0.8 percent inside the edge, 2 at 512")
        ->check(CLI::Range(0, 4096))
        ->excludes(levels);
    command
        ->add_option("--specular", o->specular,
                     "names of layers: write two passes as Blender's matcaps have them, these layers and the rest, into one .exr")
        ->delimiter(',')
        ->excludes(levels);
    command->add_flag("--half", o->half, "16-bit floats (.exr, .tif)");
    command->add_option("--save-document", o->saved, "also write the document to this .spheremap file, to start from a preset");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(CLI::Range(0, 1024));
    command->add_option("--stats", o->stats, "write times to this JSON file");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
