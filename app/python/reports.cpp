#include "arrays.h"
#include "json_text.h"
#include "module.h"
#include "reading.h"
#include "work.h"

#include "core/base/error.h"
#include "core/doctor/diagnosis.h"
#include "core/doctor/stored_map.h"
#include "core/image/probe_file.h"
#include "core/report/error_metrics.h"
#include "core/report/lobe_words.h"
#include "core/report/make_report.h"
#include "core/report/report_files.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

py::object makeReportIn(const std::vector<std::string>& probes, const std::filesystem::path& folder, const std::string& lobes,
                        const std::optional<std::vector<std::string>>& methods, const std::string& to, int size, bool stability, bool quick,
                        int threads, const py::object& progress, const py::kwargs& reading)
{
    ReportOptions options{.probes = probes, .reading = toReading("report", reading)};
    options.lobes = lobesFromWords(lobes);
    if (methods) {
        options.methods.clear();
        for (const std::string& word : *methods) {
            const auto method = methodFromName(word);
            if (!method)
                throw InvalidArgument("methods: '" + word + "' is no method");
            options.methods.push_back(*method);
        }
    }
    options.target = toLayout(to, size, 0);
    if (stability)
        options.parts.push_back(ReportPart::Stability);
    options.version = MIRRORBALL_VERSION;
    options.command = "mirrorball.report()";
    if (quick)
        options = quickReport(std::move(options));
    validate(options);
    checkReportFolder(folder);
    const Report report = resultOf(threads, progress, [&](const JobControl& job) { return makeReport(options, job); });
    writeReport(report, folder);
    if (!report.complete)
        throw Cancelled();
    return fromJson(reportJson(report, Pictures::LeftOut));
}

} // namespace

void bindReports(py::module_& m)
{
    m.def(
        "error_metrics",
        [](const EnvironmentMap& map, const EnvironmentMap& reference) {
            const ErrorMetrics e = errorMetrics(map, reference);
            return py::dict(py::arg("rel_rms") = e.relRms, py::arg("max_abs") = e.maxAbs, py::arg("median_rel") = e.medianRel,
                            py::arg("p99_rel") = e.p99Rel);
        },
        py::arg("map"), py::arg("reference"),
        "Error of a map against a reference of the same layout, weighted by solid angle: a dict of rel_rms, max_abs, median_rel, p99_rel.");
    m.def(
        "report", &makeReportIn, py::arg("probes"), py::arg("folder"), py::kw_only(), py::arg("lobes") = "phong:50,ggx:0.3,diffuse",
        py::arg("methods") = py::none(), py::arg("to") = "cube", py::arg("size") = 64, py::arg("stability") = false,
        py::arg("quick") = false, py::arg("threads") = 0, py::arg("progress") = py::none(),
        withReadingHelp(
            "Measures every method as `mirrorball report` does, writes its files into a folder, and returns report.json without pictures.")
            .c_str());
    m.def(
        "diagnose",
        [](const std::string& map, const std::optional<std::string>& probe, const std::optional<std::string>& kind, int threads,
           const py::object& progress, const py::kwargs& keywords) {
            const ProbeReading reading = toReading("diagnose", keywords);
            const std::optional<Parameterization> from = kind ? std::optional(toKind(*kind, "kind")) : std::nullopt;
            return fromJson(diagnosisJson(resultOf(threads, progress, [&](const JobControl& job) {
                const StoredMap stored = readStoredMap(map, {.from = from}, job);
                std::optional<EnvironmentMap> truth;
                if (probe)
                    truth = readProbe(*probe, {.reading = reading}, job).map;
                Diagnosis diagnosis = diagnose(stored, truth, {}, job);
                diagnosis.map = map;
                diagnosis.probe = probe.value_or("");
                return diagnosis;
            })));
        },
        py::arg("map"), py::arg("probe") = py::none(), py::kw_only(), py::arg("kind") = py::none(), py::arg("threads") = 1,
        py::arg("progress") = py::none(),
        withReadingHelp(
            "What a prefiltered map of anyone is, as `mirrorball doctor --json` tells it. `kind` is the map's; the keywords below are "
            "about the probe.")
            .c_str());
}

} // namespace mirrorball::python
