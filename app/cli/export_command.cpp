#include "command.h"
#include "scene_stats.h"

#include "core/scene/export.h"
#include "core/scene/scene_file.h"

#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Options {
    std::string scene, folder, stats;
    std::vector<std::string> only;
    int threads = 0;
    bool explain = false;
};

void run(const Options& o)
{
    const Scene scene = loadScene(o.scene);
    const JobControl job = jobWithProgress("export", o.threads);
    const PlanRequest request{.picture = false, .exports = o.only};
    const Plan plan = makePlan(scene, probeLayout(scene, request), request);
    if (o.explain)
        printStages(plan.stages);
    const ExportOutcome outcome = exportScene(scene, o.folder, {.only = o.only}, job);
    for (const std::filesystem::path& file : outcome.files)
        std::printf("%s\n", file.string().c_str());
    if (!o.stats.empty())
        writeStats(o.stats, sceneStats(plan, outcome.record, job.threadCount()));
}

} // namespace

void addExportCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("export", "Write the maps that a scene lists, each with a description beside it");
    command->add_option("SCENE", o->scene, "scene file (.mirrorball)")->required();
    command->add_option("-o,--output", o->folder, "folder for the files; made when missing")->required();
    command->add_option("--only", o->only, "names of exports; all others are left out");
    command->add_option("--threads", o->threads, "threads; 0: one per core")->check(CLI::Range(0, 1024));
    command->add_flag("--explain", o->explain, "print what is done, what is left out, and why; then do it");
    command->add_option("--stats", o->stats, "write times, method and predicted error to this JSON file");
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
