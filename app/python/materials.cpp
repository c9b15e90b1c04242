#include "arrays.h"
#include "module.h"
#include "work.h"

#include "core/base/error.h"
#include "core/filter/lookup_table.h"
#include "core/shading/brdf.h"
#include "core/shading/brdf_table.h"
#include "core/shading/reflection_kernel.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace mirrorball::python {

void bindMaterials(py::module_& m)
{
    py::class_<Brdf>(m, "Brdf", "A reflection model or a measured material: f(l, v) in 1/sr, isotropic.")
        .def(py::init(&brdfFromText), py::arg("text"),
             "MODEL[:key=value,...] (phong, lafortune, ward, cook-torrance, beckmann, ggx; ior=N, f0=R or metal=NAME beside) or a "
             "measured file, as `mirrorball brdf` takes it")
        .def(
            "evaluate",
            [](const Brdf& brdf, const py::object& lights, const py::object& views) {
                const py::array light = toNumbers(lights, "light"), view = toNumbers(views, "view");
                const auto shape = shapeOfVectors(light, "light");
                const std::vector<glm::dvec3> l = toVectors(light, "light"), v = toVectors(view, "view");
                if (l.size() != v.size() && v.size() != 1)
                    throw InvalidArgument("view: must hold one vector, or as many as light");
                std::vector<glm::dvec3> f(l.size());
                for (size_t i = 0; i < l.size(); ++i)
                    f[i] = evaluate(brdf, glm::normalize(l[i]), glm::normalize(v[v.size() == 1 ? 0 : i]));
                return fromVectors(f, shape);
            },
            py::arg("light"), py::arg("view"),
            "f in 1/sr, float64 [..., 3], of directions [..., 3] in the surface's frame, whose normal is +Z; `view` may be one vector")
        .def(
            "albedo",
            [](const Brdf& brdf, double view) {
                if (!(view >= 0.0 && view < 90.0))
                    throw InvalidArgument("view: must be an angle of at least 0 and below 90 degrees");
                const glm::dvec3 albedo = directionalAlbedo(brdf, view * pi / 180.0);
                return py::make_tuple(albedo.r, albedo.g, albedo.b);
            },
            py::arg("view"), "directional albedo, RGB, at an angle of view in degrees")
        .def(
            "table",
            [](const Brdf& brdf, const std::string& name, int size) {
                const auto table = brdfTableFromName(name);
                if (!table)
                    throw InvalidArgument("name: '" + name + "' is no table; choose one of " + brdfTableNames());
                return toArray(resultOf(0, py::none(), [&](const JobControl& job) { return makeBrdfTable(brdf, *table, size, job); }));
            },
            py::arg("name"), py::arg("size") = 0, "a table that renderers read, float32 [h, w, 3]: albedo, ab or fresnel")
        .def("__repr__", [](const Brdf& brdf) { return "<mirrorball.Brdf " + describe(brdf) + ">"; });
}

} // namespace mirrorball::python
