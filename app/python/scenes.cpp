#include "arrays.h"
#include "json_text.h"
#include "module.h"
#include "work.h"

#include "core/base/error.h"
#include "core/image/builtin_probes.h"
#include "core/preview/picture_file.h"
#include "core/scene/engine_scene_export.h"
#include "core/scene/export.h"
#include "core/scene/material_presets.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_words.h"
#include "core/spheremap/document/presets.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

/// A value as a file has it; a word as it is.
std::string toText(const py::object& value)
{
    if (py::isinstance<py::str>(value))
        return value.cast<std::string>();
    if (py::hasattr(value, "__fspath__"))
        return value.attr("__fspath__")().cast<std::string>();
    return toJsonText(value);
}

void bindFields(py::class_<Scene>& scene)
{
    scene
        .def(
            "__getitem__", [](const Scene& s, const std::string& field) { return fromJson(fieldText(s, field)); }, py::arg("field"),
            "A field by its path, such as \"material.specular.exponent\", or a group of them as a dict.")
        .def(
            "__setitem__", [](Scene& s, const std::string& field, const py::object& value) { setField(s, field, toText(value)); },
            py::arg("field"), py::arg("value"), "Sets a field as a file or `--set` does, and checks it.")
        .def_static(
            "fields",
            [] {
                py::list list;
                for (const FieldEntry& entry : sceneFields()) {
                    py::dict row(py::arg("path") = entry.path, py::arg("help") = std::string(entry.field.help),
                                 py::arg("unit") = std::string(entry.field.unit));
                    row["words"] = std::vector<std::string>(entry.words.begin(), entry.words.end());
                    row["low"] = entry.field.low;
                    row["high"] = entry.field.high;
                    list.append(row);
                }
                return list;
            },
            "Every field but those of exports: dicts of path, help, unit, words, low, high.")
        .def(
            "to_dict", [](const Scene& s) { return fromJson(fieldText(s, "")); }, "the scene as its file holds it");
}

void bindMaking(py::class_<Scene>& scene)
{
    scene
        .def(
            "render",
            [](const Scene& s, bool display, int threads, const py::object& progress) {
                const auto light = display ? preview::PictureLight::Display : preview::PictureLight::Radiance;
                return toArray(std::move(resultOf(threads, progress, [&](const JobControl& job) {
                                             return preview::drawPicture(planScene(s), light, job);
                                         }).image));
            },
            py::kw_only(), py::arg("display") = false, py::arg("threads") = 0, py::arg("progress") = py::none(),
            "The picture, float32 [height, width, 4]: scene-linear radiance, or with display=True exposed, tone-mapped and sRGB-encoded. "
            "Colors are multiplied by opacity, which is 1 unless the background is none.")
        .def(
            "save_picture",
            [](const Scene& s, const std::filesystem::path& path, int threads, const py::object& progress) {
                resultOf(threads, progress, [&](const JobControl& job) { return preview::savePicture(planScene(s), path, job); });
            },
            py::arg("path"), py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
            "Draws into a file as `mirrorball render` does, the same bytes.")
        .def(
            "plan",
            [](const Scene& s) {
                py::list list;
                for (const Stage& stage : planScene(s).plan.stages())
                    list.append(py::dict(py::arg("name") = stage.name, py::arg("left_out") = stage.leftOut, py::arg("why") = stage.why));
                return list;
            },
            "What a picture of it needs, what is left out, and why: dicts of name, left_out, why. Nothing is computed.")
        .def(
            "export",
            [](const Scene& s, const std::filesystem::path& folder, const std::vector<std::string>& only, int threads,
               const py::object& progress) {
                return resultOf(threads, progress, [&](const JobControl& job) { return exportScene(s, folder, {.only = only}, job); })
                    .files;
            },
            py::arg("folder"), py::kw_only(), py::arg("only") = std::vector<std::string>{}, py::arg("threads") = 0,
            py::arg("progress") = py::none(), "Writes the scene's exports as `mirrorball export` does. Returns the paths written.")
        .def(
            "export_for",
            [](const Scene& s, const std::string& engine, const std::filesystem::path& folder, int size, const std::string& name,
               int threads, const py::object& progress) {
                const EngineProfile& profile = engineProfile(engine, "engine");
                const EngineExportOptions options{.size = size, .name = name.empty() ? engineExportName(folder) : name};
                const EngineExport done =
                    resultOf(threads, progress, [&](const JobControl& job) { return exportForEngine(s, profile, options, folder, job); });
                return py::dict(py::arg("files") = done.files, py::arg("warnings") = done.warnings);
            },
            py::arg("engine"), py::arg("folder"), py::kw_only(), py::arg("size") = 0, py::arg("name") = "", py::arg("threads") = 0,
            py::arg("progress") = py::none(),
            "Writes the scene's light as an engine takes it (three, filament, babylon, ...), as `mirrorball export --for` does. Returns "
            "{'files': [...], 'warnings': [...]}.");
}

py::list presets()
{
    py::list list;
    const auto add = [&](std::string name, const char* kind, std::string description) {
        list.append(py::dict(py::arg("name") = std::move(name), py::arg("kind") = kind, py::arg("description") = std::move(description)));
    };
    for (const BuiltinProbe& probe : builtinProbes())
        add("builtin:" + std::string(probe.name), "probe", std::string(probe.description));
    for (const MaterialPreset& material : materialPresets())
        add(std::string(material.name), "material", std::string(material.description));
    for (const auto maps : {sphereMapPresets(), windowViewPresets()})
        for (const SphereMapPreset& map : maps)
            add(map.name, "sphere-map", map.description);
    return list;
}

Scene sceneOf(const std::optional<std::filesystem::path>& probe, const std::optional<std::string>& material)
{
    Scene scene;
    if (probe)
        scene.probe.source = probeFromWord(probe->string());
    if (material)
        scene.material = materialFromWord("material", *material);
    return scene;
}

} // namespace

void bindScenes(py::module_& m)
{
    py::class_<Scene> scene(m, "Scene", "What to make: probe, map, material, view and exports. Fields are read and set by their paths.");
    scene.def(py::init(&sceneOf), py::arg("probe") = py::none(), py::arg("material") = py::none(),
              "A scene with a probe (a file or builtin:NAME) and a material (a preset or a file); without them the defaults.");
    scene.def_static("load", &loadScene, py::arg("path"), "a .mirrorball file");
    scene.def("save", &saveScene, py::arg("path"), "Writes every field; the file appears whole or not at all.");
    bindFields(scene);
    bindMaking(scene);
    m.def("presets", &presets, "The built-in probes, materials and sphere maps: dicts of name, kind, description.");
}

} // namespace mirrorball::python
