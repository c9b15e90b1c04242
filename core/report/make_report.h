#pragma once

#include "map_drawer.h"
#include "report.h"
#include "report_forecast.h"
#include "report_parts.h"

#include "core/base/fields.h"
#include "core/base/job.h"
#include "core/filter/paraboloid.h"
#include "core/image/probe_reading.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace mirrorball {

struct ReportOptions {
    std::vector<std::string> probes{}; ///< paths or builtin:NAME, at least one where a part needs one
    ProbeReading reading{};            ///< how each is to be read
    std::vector<Lobe> lobes{};
    std::vector<Method> methods{allMethods.begin(), allMethods.end()};
    std::vector<ReportPart> parts{ReportPart::Methods, ReportPart::Parameterizations, ReportPart::Growth};
    MapLayout target{.kind = Parameterization::Cube, .size = 64};
    Sweep sweep = Sweep::Usual;
    double tolerance = 1e-3;
    int repeats = 5;
    double longest = 3.0;
    int directions = 512;
    int growthTo = 16384;                       ///< columns; 0 leaves the growth of cost out
    std::shared_ptr<ParaboloidDevice> device{}; ///< of the paraboloid method; null: the CPU
    std::string deviceName{};
    std::shared_ptr<MapDrawer> drawer{}; ///< for the time of a picture; null: it is not measured
    std::string command{};               ///< as typed, for the record
    std::string version{};
    /// Told what the report is expected to take, once, before anything is measured.
    std::function<void(const ReportForecast&)> foretell{};

    bool has(ReportPart part) const
    {
        return std::find(parts.begin(), parts.end(), part) != parts.end() && (part != ReportPart::Growth || growthTo > 0);
    }

    /// The numbers that the command line offers, each under its name.
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"tolerance", "rel_rms of the verdicts, and of the setting that each method is shown with", 1e-9, 1.0}, self.tolerance);
        visit(Field{"repeats", "timed runs of each setting; the median is taken", 1, 1000}, self.repeats);
        visit(Field{"longest", "a setting predicted to take longer is left out", 0.001, 86400, "seconds"}, self.longest);
        visit(Field{"directions", "directions at which the reference sum is taken; all where the map has no more texels", 16, 1 << 24},
              self.directions);
        visit(Field{"growth-to", "widest probe of the growth of cost, 256 to 16384 columns; 0 leaves growth out", 0, 16384}, self.growthTo);
    }
};

/// The options of a quick look: few settings and repeats, a coarse reference, no growth of cost.
ReportOptions quickReport(ReportOptions options);

/// @throws InvalidArgument naming the field
void validate(const ReportOptions& options);

/// The largest probe that a report takes: it is held whole, and the reference sums over it.
inline constexpr std::int64_t largestReportProbe = std::int64_t{1} << 25;

/// Measures what the options ask for. When the job is stopped it returns what it has, with `complete` false; it does not throw Cancelled.
/// @throws FileError, InvalidArgument for a probe that cannot be read or is too large
Report makeReport(const ReportOptions& options, const JobControl& job = {});

} // namespace mirrorball
