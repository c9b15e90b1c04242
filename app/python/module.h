#pragma once

#include <pybind11/pybind11.h>

/// The parts of the Python module, a file each. What they bind is documented in docs/python.md and in mirrorball/__init__.pyi.
namespace mirrorball::python {

void bindErrors(pybind11::module_& module);
void bindMaps(pybind11::module_& module);
void bindFilters(pybind11::module_& module);
void bindMaterials(pybind11::module_& module);
void bindSphereMaps(pybind11::module_& module);
void bindScenes(pybind11::module_& module);
void bindReports(pybind11::module_& module);

} // namespace mirrorball::python
