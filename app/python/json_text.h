#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace mirrorball::python {

/// JSON as Python's own values.
inline pybind11::object fromJson(const std::string& text) { return pybind11::module_::import("json").attr("loads")(text); }

/// A value as a JSON file has it; numpy's numbers and arrays count as Python's. @throws TypeError for what JSON cannot hold
inline std::string toJsonText(const pybind11::object& value)
{
    namespace py = pybind11;
    const py::cpp_function numpysToo([](const py::object& thing) -> py::object {
        if (!py::hasattr(thing, "tolist"))
            throw py::type_error("a field takes numbers, words, lists and dicts, no " +
                                 py::str(py::type::of(thing).attr("__name__")).cast<std::string>());
        return thing.attr("tolist")();
    });
    return py::module_::import("json").attr("dumps")(value, py::arg("default") = numpysToo).cast<std::string>();
}

} // namespace mirrorball::python
