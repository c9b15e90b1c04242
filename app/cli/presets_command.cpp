#include "command.h"

#include "core/base/error.h"
#include "core/image/builtin_probes.h"
#include "core/image/map_file.h"
#include "core/preview/offscreen_context.h"
#include "core/preview/renderer.h"
#include "core/preview/scene_settings.h"
#include "core/scene/material_presets.h"
#include "core/scene/scene_maps.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/contact_sheet.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Preset {
    std::string name, kind, description;
};

std::vector<Preset> allPresets()
{
    std::vector<Preset> presets;
    for (const BuiltinProbe& probe : builtinProbes())
        presets.push_back({"builtin:" + std::string(probe.name), "probe", std::string(probe.description)});
    for (const MaterialPreset& material : materialPresets())
        presets.push_back({std::string(material.name), "material", std::string(material.description)});
    for (const auto maps : {sphereMapPresets(), windowViewPresets()})
        for (const SphereMapPreset& map : maps)
            presets.push_back({map.name, "sphere-map", map.description});
    return presets;
}

constexpr float ground = 0.05f; ///< radiance behind balls and models

/// A sphere map as a ball, with a margin, on transparent ground.
Image ballOf(const SphereMapPreset& map, int size, const JobControl& job)
{
    const int margin = std::max(size / 32, 1);
    const Image disc = cutToDisc(evaluate(map.document, {.size = size - 2 * margin}, job));
    Image cell(size, size, 4);
    for (int y = 0; y < disc.height; ++y)
        std::copy_n(disc.row(y), 4 * static_cast<size_t>(disc.width), cell.texel(margin, margin + y));
    return cell;
}

/// Every sphere map as a ball, in the order of the list, on a dark ground.
Image sphereMapSheet(int size, const JobControl& job)
{
    std::vector<Image> balls;
    for (const SphereMapPreset& map : sphereMapPresets())
        balls.push_back(ballOf(map, size, job));
    return contactSheet(balls, sheetLayout(balls.size()).columns, ground);
}

/// Every sphere map as a ball in a file of its own: NAME.png.
void writeThumbnails(const std::filesystem::path& folder, int size, const JobControl& job)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw WorkError(shownPath(folder.string()) + ": cannot be made a folder: " + error.message());
    for (const auto maps : {sphereMapPresets(), windowViewPresets()})
        for (const SphereMapPreset& map : maps)
            writePictures(folder / (map.name + ".png"), {contactSheet(std::vector{ballOf(map, size, job)}, 1, ground)});
}

/// Every sphere map on a geometry. Cells are 4 to 3, as a teapot is.
Image geometrySheet(const std::string& geometry, int size, const JobControl& job)
{
    const preview::OffscreenContext context;
    preview::Renderer renderer;
    std::vector<Image> pictures;
    for (const SphereMapPreset& map : sphereMapPresets()) {
        Scene scene;
        scene.view.geometry = geometry;
        scene.view.width = size;
        scene.view.height = std::max(3 * size / 4, 1);
        scene.view.camera.distance = 2.6;
        scene.view.background.kind = Backdrop::None;
        scene.material.sphereMap.source = map.name;
        PlannedScene planned = planScene(scene);
        const preview::RenderSettings settings = preview::renderSettings(scene, planned.plan);
        pictures.push_back(renderer.renderRadiance(settings, preview::renderMaps(buildMaps(std::move(planned), job))));
    }
    return contactSheet(pictures, sheetLayout(pictures.size()).columns, ground);
}

struct Options {
    bool json = false;
    std::string sheet, thumbnails, geometry;
    int size = 256;
};

void run(const Options& o)
{
    if (!o.sheet.empty()) {
        const JobControl job = jobWithProgress("presets", 0);
        writePictures(o.sheet, {o.geometry.empty() ? sphereMapSheet(o.size, job) : geometrySheet(o.geometry, o.size, job)});
        return;
    }
    if (!o.thumbnails.empty()) {
        writeThumbnails(o.thumbnails, o.size, jobWithProgress("presets", 0));
        return;
    }
    if (o.json) {
        nlohmann::json list = nlohmann::json::array();
        for (const Preset& p : allPresets())
            list.push_back({{"name", p.name}, {"kind", p.kind}, {"description", p.description}});
        std::printf("%s\n", list.dump(2).c_str());
        return;
    }
    for (const Preset& p : allPresets())
        std::printf("%s\t%s\t%s\n", p.name.c_str(), p.kind.c_str(), p.description.c_str());
}

} // namespace

void addPresetsCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("presets", "List the built-in probes, materials and sphere maps");
    command->add_flag("--json", o->json, "as JSON");
    command->add_option("--sheet", o->sheet, "instead of the list, write a picture of all sphere maps to this file");
    command->add_option("--thumbnails", o->thumbnails,
                        "instead of the list, write a picture of each sphere map into this folder: NAME.png");
    command->add_option("--geometry", o->geometry, "sheet: show them on a teapot, torus, sphere or box in place of balls")
        ->check(CLI::IsMember({"teapot", "torus", "sphere", "box"}));
    command->add_option("--size", o->size, "sheet, thumbnails: width of one picture, in pixels")->check(within(16, 2048));
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
