#include "export.h"

#include "sidecar.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/map_file.h"
#include "core/spheremap/evaluation/painted_pictures.h"

#include <algorithm>
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
};

SampleType samplesOf(const ExportTarget& target) { return target.half ? SampleType::Half : SampleType::Float; }

Written writeFiltered(const Scene& scene, const ExportPlan& planned, SceneProbe& probe, const std::filesystem::path& folder,
                      const JobControl& job, WorkRecord& work)
{
    const ExportTarget& target = planned.target;
    const std::vector<EnvironmentMap> levels = buildMap(planned.map, probe, scene.probe.exposure, job, work);
    std::vector<std::filesystem::path> files = timedStage(work.stages, "save " + target.name, [&] {
        WriteOptions write{.sampleType = samplesOf(target)};
        write.attributes["mirrorball:indexed_by"] = indexedBy(target.kind);
        return writeMap(folder / target.fileName(), levels, write);
    });
    std::string description = sidecar(scene, planned, levels, files, work);
    return {std::move(files), std::move(description)};
}

Written writePainted(const Scene& scene, const ExportPlan& planned, const std::filesystem::path& folder, const JobControl& job,
                     WorkRecord& work)
{
    const ExportTarget& target = planned.target;
    const SphereMapDocument map = sphereMapDocument(scene, *planned.painted);
    const PaintedLevels chain = planned.painted->levels == SphereMapLevels::Plain ? PaintedLevels::Plain : PaintedLevels::Authored;
    const PaintedOptions options{.size = target.size, .border = target.border, .levels = target.mips ? chain : PaintedLevels::One};
    const std::vector<Image> levels = timedStage(work.stages, "paint " + target.name, [&] { return paintedPictures(map, options, job); });
    work.method = "paint";
    std::vector<std::filesystem::path> files = timedStage(work.stages, "save " + target.name, [&] {
        return writePictures(folder / target.fileName(), levels, paintedFileOptions(map, samplesOf(target)));
    });
    std::string description = paintedSidecar(scene, planned, map, levels, files);
    return {std::move(files), std::move(description)};
}

/// Builds, writes and describes one export.
void exportOne(const Scene& scene, const ExportPlan& planned, SceneProbe& probe, const std::filesystem::path& folder, const JobControl& job,
               ExportOutcome& outcome)
{
    WorkRecord work;
    Written written =
        planned.painted ? writePainted(scene, planned, folder, job, work) : writeFiltered(scene, planned, probe, folder, job, work);
    const std::filesystem::path description = folder / (planned.target.name + ".json");
    writeText(description, written.description);
    std::vector<std::filesystem::path>& files = written.files;
    files.push_back(description);

    outcome.files.insert(outcome.files.end(), files.begin(), files.end());
    WorkRecord& record = outcome.record;
    record.stages.insert(record.stages.end(), std::make_move_iterator(work.stages.begin()), std::make_move_iterator(work.stages.end()));
    if (record.method.find(work.method) == std::string::npos)
        record.method += (record.method.empty() ? "" : ", ") + work.method;
    record.bandLimit = std::max(record.bandLimit, work.bandLimit);
    record.predicted = largest(record.predicted, work.predicted);
    record.promised = record.promised && work.promised;
}

} // namespace

ExportOutcome exportScene(const Scene& scene, const std::filesystem::path& folder, const ExportOptions& options, const JobControl& job)
{
    if (scene.exports.empty())
        throw InvalidArgument(
            "exports: the scene lists none; add at least {\"name\": \"specular\", \"kind\": \"specular\"} to \"exports\"");
    const PlanRequest request{.picture = false, .exports = options.only};
    const Plan plan = makePlan(scene, probeLayout(scene, request), request);
    ExportOutcome outcome;
    constexpr float reading = 0.2f; // share of the progress
    SceneProbe probe = openProbe(scene, plan, partOf(job, 0.0f, reading), outcome.record);

    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw WorkError(folder.string() + ": cannot be made a folder" + (error ? ": " + error.message() : "") + "; choose another one");
    const float share = (1.0f - reading) / static_cast<float>(plan.exports.size());
    for (size_t i = 0; i < plan.exports.size(); ++i) {
        const float from = reading + share * static_cast<float>(i);
        exportOne(scene, plan.exports[i], probe, folder, partOf(job, from, from + share), outcome);
    }
    return outcome;
}

} // namespace mirrorball
