#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace mirrorball::python {

/// JSON as Python's own values.
inline pybind11::object fromJson(const std::string& text) { return pybind11::module_::import("json").attr("loads")(text); }

} // namespace mirrorball::python
