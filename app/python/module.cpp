#include "module.h"

#include "core/base/error.h"

#include <new>
#include <system_error>

namespace py = pybind11;

namespace mirrorball::python {

/// The command line's errors with the same words: Error, and below it WorkError (exit status 1), InvalidArgument, which is a ValueError,
/// and FileError (both 2), and Cancelled.
void bindErrors(py::module_& m)
{
    const auto& error = py::register_exception<Error>(m, "Error");
    py::register_exception<WorkError>(m, "WorkError", error.ptr());
    py::register_exception<Cancelled>(m, "Cancelled", error.ptr());
    const py::tuple argumentBases = py::make_tuple(error, py::handle(PyExc_ValueError));
    const auto& argument = py::register_exception<InvalidArgument>(m, "InvalidArgument", argumentBases.ptr());
    const py::tuple fileBases = py::make_tuple(argument, py::handle(PyExc_OSError));
    py::register_exception<FileError>(m, "FileError", fileBases.ptr());
}

} // namespace mirrorball::python

PYBIND11_MODULE(_mirrorball, m)
{
    using namespace mirrorball::python;
    m.doc() = "Materials with environment maps: light probes, prefiltering, sphere maps, scenes.";
    m.attr("__version__") = MIRRORBALL_VERSION;
    bindErrors(m);
    bindMaps(m);
    bindFilters(m);
    bindMaterials(m);
    bindSphereMaps(m);
    bindScenes(m);
    bindReports(m);
}
