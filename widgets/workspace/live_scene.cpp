#include "live_scene.h"

#include "core/base/error.h"
#include "core/preview/mesh_file.h"
#include "core/preview/scene_settings.h"
#include "core/scene/scene_dependencies.h"

#include <filesystem>

namespace mirrorball::studio {

/// What the worker keeps from one scene to the next.
struct LiveScene::Maker {
    LiveMaps maps{};
    std::filesystem::path meshPath{};
    std::filesystem::file_time_type meshTime{};
    std::shared_ptr<const preview::Mesh> mesh{};
    std::string meshProblem{};
    bool isMeshKept = false; ///< the mesh is that of the file as it was before
    preview::DisplayChoice displayChoice{};
    std::shared_ptr<const preview::DisplayTransform> display{};
    std::string displayProblem{};

    std::shared_ptr<const PreparedScene> make(const Scene& scene, const MapDetail& detail, const JobControl& job)
    {
        PreparedScene prepared{maps.update(scene, detail, job)};
        if (const auto path = preview::meshFile(scene)) {
            readMesh(*path, job, prepared.record);
            prepared.mesh = mesh;
            prepared.meshProblem = meshProblem;
            if (isMeshKept)
                prepared.keptFiles.push_back(path->string());
            leaveOutPictures(prepared);
        }
        if (const auto choice = preview::displayChoice(scene)) {
            readDisplay(*choice, prepared.record);
            prepared.display = display;
            prepared.displayProblem = displayProblem;
        }
        return std::make_shared<const PreparedScene>(std::move(prepared));
    }

private:
    /// A mesh without texture coordinates is shown without the pictures that need them.
    static void leaveOutPictures(PreparedScene& prepared)
    {
        const std::string problem = preview::texCoordProblem(prepared.plan, *prepared.mesh, prepared.scene.view.geometry);
        if (problem.empty())
            return;
        prepared.meshProblem += (prepared.meshProblem.empty() ? "" : "; ") + problem;
        prepared.plan.diffusePicture.reset();
        prepared.plan.fleckPattern.reset();
        prepared.plan.normalMap.reset();
    }

    void readDisplay(const preview::DisplayChoice& choice, WorkRecord& record)
    {
        if (choice == displayChoice)
            return;
        display.reset();
        displayProblem.clear();
        try {
            display = timedStage(record.stages, "read display configuration", [&] { return preview::displayTransform(choice); });
        } catch (const Error& error) {
            displayProblem = error.what();
        }
        displayChoice = choice;
    }

    void readMesh(const std::filesystem::path& path, const JobControl& job, WorkRecord& record)
    {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(path, missing);
        if (mesh && path == meshPath && time == meshTime)
            return;
        const std::shared_ptr<const preview::Mesh> before = path == meshPath && (meshProblem.empty() || isMeshKept) ? mesh : nullptr;
        meshProblem.clear();
        isMeshKept = false;
        try {
            mesh =
                timedStage(record.stages, "read mesh", [&] { return std::make_shared<const preview::Mesh>(preview::readMesh(path, job)); });
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            isMeshKept = before != nullptr;
            mesh = isMeshKept ? before : std::make_shared<const preview::Mesh>(preview::boxMesh());
            meshProblem = error.what();
        }
        meshPath = path;
        meshTime = time;
    }
};

LiveScene::LiveScene(Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_runner(this), m_maker(std::make_shared<Maker>())
{
    connect(&m_document, &Document::changed, this, &LiveScene::follow);
    connect(&m_document, &Document::dragFinished, this, &LiveScene::follow);
    connect(&m_runner, &JobRunner::failed, this, [this](const QString& message) {
        m_isUpToDate = false;
        emit failed(message);
    });
    request();
}

void LiveScene::follow()
{
    const bool wantsFull = !m_document.isDragging() && !startsAnew();
    const bool isFineEnough = !wantsFull || m_requestedDetail == MapDetail{};
    if (isFineEnough && mapsOf(m_requested) == mapsOf(m_document.scene()) && (m_runner.isBusy() || m_made))
        return;
    request();
}

void LiveScene::refresh() { request(); }

// Another probe takes a while: a coarse picture of it comes first, the full one follows.
bool LiveScene::startsAnew() const { return !m_made || m_made->scene.probe.source != m_document.scene().probe.source; }

void LiveScene::request()
{
    const bool wantsCoarse = m_document.isDragging() || startsAnew();
    // A coarse result of a moment ago is better than none; a full one would only be in the way.
    const Running running = wantsCoarse && m_requestedDetail == coarseDetail ? Running::Finish : Running::Stop;
    m_requested = m_document.scene();
    m_requestedDetail = wantsCoarse ? coarseDetail : MapDetail{};
    m_isUpToDate = false;
    m_runner.start([maker = m_maker, scene = m_requested,
                    detail = m_requestedDetail](const JobControl& job) { return maker->make(scene, detail, job); },
                   [this](std::shared_ptr<const PreparedScene> made) { use(std::move(made)); }, running);
}

void LiveScene::use(std::shared_ptr<const PreparedScene> made)
{
    m_made = std::move(made);
    m_isUpToDate = m_made->detail == MapDetail{} && mapsOf(m_made->scene) == mapsOf(m_document.scene());
    emit updated();
    if (m_made->detail == coarseDetail && !m_document.isDragging())
        follow();
}

} // namespace mirrorball::studio
