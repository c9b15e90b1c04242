#pragma once

#include "core/base/job.h"

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <type_traits>

namespace mirrorball::python {

/// Runs work without holding the interpreter, so that other Python threads go on, and follows a progress function. On the main thread,
/// where Python hears signals, Ctrl-C stops the work and raises KeyboardInterrupt. What a progress function raises stops it too.
/// @param threads  0: one per core. @param progress  None, or called with the share that is done, in [0, 1]
void runWork(int threads, const pybind11::object& progress, const std::function<void(const JobControl&)>& body);

/// The same for work with a result.
template <typename Body>
auto resultOf(int threads, const pybind11::object& progress, Body&& body)
{
    std::optional<std::invoke_result_t<Body, const JobControl&>> result;
    runWork(threads, progress, [&](const JobControl& job) { result.emplace(body(job)); });
    return std::move(*result);
}

} // namespace mirrorball::python
