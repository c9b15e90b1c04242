#include "export.h"

#include "sidecar.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file_transaction.h"
#include "core/image/map_file.h"
#include "core/spheremap/evaluation/painted_files.h"

#include <algorithm>
#include <set>
#include <system_error>

namespace mirrorball {

namespace {

void writeText(const std::filesystem::path& path, const std::string& text)
{
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

/// What one export wrote, and what is to be said of it.
struct Written {
    std::vector<std::filesystem::path> files{};
    std::string description{};
    WorkRecord record{};
};

SampleType samplesOf(const ExportTarget& target) { return target.half ? SampleType::Half : SampleType::Float; }

Written writeFiltered(const Scene& scene, const ExportPlan& planned, SceneProbe& probe, const std::filesystem::path& folder,
                      const JobControl& job)
{
    const ExportTarget& target = planned.target;
    BuiltMap built = buildMap(planned.map, probe, scene.probe.exposure, job);
    Written written{.record = std::move(built.record)};
    written.files = timedStage(written.record.stages, "save " + target.name, [&] {
        WriteOptions write{.sampleType = samplesOf(target)};
        write.faceBorder = target.faceBorder();
        write.attributes["mirrorball:indexed_by"] = indexedBy(target.kind);
        return writeMap(folder / target.fileName(), built.levels, write);
    });
    written.description = sidecar(scene, planned, built.levels, written.files, written.record);
    return written;
}

Written writePainted(const Scene& scene, const ExportPlan& planned, const std::filesystem::path& folder, const JobControl& job)
{
    const ExportTarget& target = planned.target;
    const SphereMapDocument map = sphereMapDocument(scene, *planned.painted);
    const PaintedLevels chain = planned.painted->levels == SphereMapLevels::Plain ? PaintedLevels::Plain : PaintedLevels::Authored;
    const PaintedOptions options{.size = target.size, .border = target.border, .levels = target.mips ? chain : PaintedLevels::One};
    Written written{.record = {.methods = {"paint"}}};
    std::vector<Stage>& stages = written.record.stages;
    PaintedFiles painted = writePainted(folder / target.fileName(), map, options, samplesOf(target), job);
    for (size_t i = 0; i < painted.stages.size(); ++i) { // a large map is saved as it is painted
        painted.stages[i].name = (i == 0 ? "paint " : "save ") + target.name;
        stages.push_back(std::move(painted.stages[i]));
    }
    written.files = std::move(painted.files);
    written.description = paintedSidecar(scene, planned, map, painted.levels, written.files);
    return written;
}

/// Builds, writes and describes one export.
void exportOne(const Scene& scene, const ExportPlan& planned, SceneProbe& probe, const std::filesystem::path& folder, const JobControl& job,
               ExportOutcome& outcome)
{
    Written written = planned.painted ? writePainted(scene, planned, folder, job) : writeFiltered(scene, planned, probe, folder, job);
    const std::filesystem::path description = folder / (planned.target.name + ".json");
    writeText(description, written.description);
    outcome.files.insert(outcome.files.end(), written.files.begin(), written.files.end());
    outcome.files.push_back(description);
    outcome.record += std::move(written.record);
}

/// A name with marks may mean the file of another export.
void checkDifferent(const std::vector<std::filesystem::path>& files)
{
    std::set<std::filesystem::path> seen;
    for (const std::filesystem::path& file : files)
        if (file.filename() == FileTransaction::manifestName || !seen.insert(file.filename()).second)
            throw InvalidArgument("exports: two outputs are named " + file.filename().string() + "; give each export a name of its own");
}

} // namespace

ExportOutcome exportScene(const Scene& scene, const std::filesystem::path& folder, const ExportOptions& options, const JobControl& job)
{
    return exportPlanned(planExports(scene, options), folder, job);
}

PlannedScene planExports(const Scene& scene, const ExportOptions& options)
{
    if (scene.exports.empty())
        throw InvalidArgument(
            "exports: the scene lists none; add at least {\"name\": \"specular\", \"kind\": \"specular\"} to \"exports\"");
    return planScene(scene, {.picture = false, .exports = options.only});
}

ExportOutcome exportPlanned(PlannedScene planned, const std::filesystem::path& folder, const JobControl& job)
{
    const Plan& plan = planned.plan;
    constexpr float reading = 0.2f; // share of the progress
    SceneProbe probe = openProbe(std::move(planned.probe), plan, partOf(job, 0.0f, reading));
    ExportOutcome outcome{.record = std::move(planned.record)};
    outcome.record += probe.record;

    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw WorkError(folder.string() + ": cannot be made a folder" + (error ? ": " + error.message() : "") + "; choose another one");
    FileTransaction together(folder);
    try {
        const float share = (1.0f - reading) / static_cast<float>(plan.exports.size());
        for (size_t i = 0; i < plan.exports.size(); ++i) {
            const float from = reading + share * static_cast<float>(i);
            exportOne(planned.scene, plan.exports[i], probe, together.staging(), partOf(job, from, from + share), outcome);
        }
        checkDifferent(outcome.files);
        together.addManifest();
        job.checkStop(); // what was cancelled leaves nothing, however little was left to do
    } catch (const WorkError& failure) {
        throw WorkError(together.aboutTheFolder(failure.what()));
    }
    together.commit();
    for (std::filesystem::path& file : outcome.files)
        file = folder / file.filename();
    return outcome;
}

} // namespace mirrorball
