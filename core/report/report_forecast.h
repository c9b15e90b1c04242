#pragma once

#include "pace.h"
#include "report_parts.h"

#include "core/base/job.h"

#include <string>
#include <vector>

namespace mirrorball {

struct ReportOptions;

/// What a report is expected to take, in seconds of the clock, told before it starts. Measured within a factor of 1.5 on the probes of the
/// test data, while the machine stays as busy as it was when the forecast was made.
struct ReportForecast {
    struct Part {
        ReportPart part = ReportPart::Methods;
        double seconds = 0.0;
    };
    std::vector<Part> parts{}; ///< those that the report holds

    double seconds() const; ///< of all
};

/// Reads no more of the probes than their headers.
/// @throws FileError, InvalidArgument for a probe that cannot be read or is too large
ReportForecast forecastReport(const ReportOptions& options, const Pace& pace);

/// "about 2 min 30 s (methods 1 min 40 s, growth 45 s)"
std::string describe(const ReportForecast& forecast);

/// "4 s", "1 min 40 s": as finely as a forecast deserves.
std::string durationText(double seconds);

} // namespace mirrorball
