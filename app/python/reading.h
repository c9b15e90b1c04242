#pragma once

#include "core/image/probe_reading.h"

#include <pybind11/pybind11.h>

#include <string>

namespace mirrorball::python {

/// How a file is to be read, from keyword arguments with the names of ProbeReading's fields; its parameterization is called `kind`. Values
/// are as scene files have them; `rotate` takes three angles or a quaternion, as numbers or in one word.
/// @param function  "read_probe", for messages. @throws InvalidArgument naming the keyword; TypeError for one that is none of them
ProbeReading toReading(const std::string& function, const pybind11::kwargs& keywords);

/// The documentation of a function that takes them: `text`, and a line for each.
std::string withReadingHelp(const std::string& text);

} // namespace mirrorball::python
