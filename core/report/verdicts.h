#pragma once

#include "report.h"

#include <optional>
#include <span>

/// What follows from the measurements of one probe and lobe.
namespace mirrorball {

/// Marks the settings that no other method beats: none of the others is as fast (median, first lobe) and as accurate (rel_rms) but for
/// ties. `auto`, which is always one of the others, and the reference, whose error is 0 by definition, do not take part.
void markFront(std::span<Measurement> measurements);

/// Seconds a method needs for an error, by the settings measured.
struct TimeForError {
    double seconds = 0.0;
    bool reached =
        true; ///< false: even the most accurate setting has a larger error; `seconds` is then the longest measured, a lower bound
};

/// Between two settings of a method the logarithms of time and error are taken to lie on a line; a method whose cheapest setting is more
/// accurate than asked for needs that setting's time. Empty when nothing of the method was measured.
std::optional<TimeForError> timeForError(std::span<const Measurement> measurements, Method method, double relRms);

/// How `auto` at the tolerance does against the fastest method that meets it. Empty when auto was not measured at that tolerance.
std::optional<Verdict> verdict(const ReportCase& measured, double tolerance);

/// The setting a method is shown with: the fastest that meets the tolerance, else its most accurate. Null: nothing measured.
const Measurement* workingSetting(std::span<const Measurement> measurements, Method method, double tolerance);

} // namespace mirrorball
