#include "arrays.h"
#include "module.h"
#include "work.h"

#include "core/base/error.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "core/spheremap/evaluation/painted_files.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

SphereMapDocument preset(const std::string& name)
{
    if (const SphereMapPreset* found = findSphereMapPreset(name))
        return found->document;
    throw InvalidArgument("name: '" + name + "' is no built-in sphere map; mirrorball.presets() lists them");
}

PaintedOptions checkedOptions(int size, bool levels, int border)
{
    if (size < 1 || size > largestSphereMap)
        throw InvalidArgument("size: must lie in 1 to " + std::to_string(largestSphereMap) + "; it is " + std::to_string(size));
    return {.size = size, .border = border, .levels = levels ? PaintedLevels::Authored : PaintedLevels::One};
}

std::vector<Image> paint(const SphereMapDocument& document, int size, bool levels, int border, int threads, const py::object& progress)
{
    const PaintedOptions options = checkedOptions(size, levels, border);
    return resultOf(threads, progress, [&](const JobControl& job) { return paintedPictures(document, options, job); });
}

} // namespace

void bindSphereMaps(py::module_& m)
{
    py::class_<SphereMapDocument>(m, "SphereMap", "A painted sphere map: a document of layers.")
        .def_static("load", &loadSphereMap, py::arg("path"), "a .spheremap file, or a file of recorded strokes")
        .def_static("preset", &preset, py::arg("name"), "a built-in one: cold-warm, ...")
        .def_static("from_json", &sphereMapFromText, py::arg("text"))
        .def("to_json", &sphereMapToText, "the document as the text of its file")
        .def("save", &saveSphereMap, py::arg("path"))
        .def(
            "evaluate",
            [](const SphereMapDocument& document, int size, int border, int threads, const py::object& progress) {
                return toArray(std::move(paint(document, size, false, border, threads, progress).front()));
            },
            py::arg("size"), py::kw_only(), py::arg("border") = 0, py::arg("threads") = 0, py::arg("progress") = py::none(),
            "float32 [size, size, 3], linear; [size, size, 4], multiplied by opacity, where not all of it is opaque")
        .def(
            "levels",
            [](const SphereMapDocument& document, int size, int threads, const py::object& progress) {
                py::list arrays;
                for (Image& level : paint(document, size, true, 0, threads, progress))
                    arrays.append(toArray(std::move(level)));
                return arrays;
            },
            py::arg("size"), py::kw_only(), py::arg("threads") = 0, py::arg("progress") = py::none(),
            "the whole mip chain as the document makes it, largest first")
        .def(
            "write",
            [](const SphereMapDocument& document, const std::filesystem::path& path, int size, bool levels, int border, bool half,
               int threads, const py::object& progress) {
                const PaintedOptions options = checkedOptions(size, levels, border);
                const SampleType samples = half ? SampleType::Half : SampleType::Float;
                return resultOf(threads, progress,
                                [&](const JobControl& job) { return writePainted(path, document, options, samples, job).files; });
            },
            py::arg("path"), py::arg("size"), py::kw_only(), py::arg("levels") = false, py::arg("border") = 0, py::arg("half") = false,
            py::arg("threads") = 0, py::arg("progress") = py::none(),
            "Writes the map as `mirrorball paint` does, the same bytes. Returns the paths written.");
}

} // namespace mirrorball::python
