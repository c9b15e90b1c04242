#include "report_files.h"

#include "html_page.h"
#include "thumbnails.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

#include <unistd.h>

namespace mirrorball {

namespace {

using Json = nlohmann::ordered_json;

Json optionalNumber(const auto& value) { return value ? Json(*value) : Json(nullptr); }

Json pictureJson(const std::string& png, Pictures pictures)
{
    return pictures == Pictures::Embedded && !png.empty() ? Json(dataUri(png)) : Json(nullptr);
}

Json timesJson(const RunTimes& times)
{
    return {{"median", times.median()},
            {"shortest", times.shortest()},
            {"longest", times.longest()},
            {"runs", times.seconds.size()},
            {"cpu", times.cpuSeconds.empty() ? Json() : Json(times.cpuMedian())}};
}

Json layoutJson(const MapLayout& layout)
{
    return {{"kind", name(layout.kind)},
            {"size", layout.size},
            {"border", layout.border},
            {"width", layout.width()},
            {"height", layout.height()}};
}

Json machineJson(const Machine& m)
{
    return {{"processor", m.processor}, {"cores", m.cores},       {"memory_bytes", m.memoryBytes},
            {"system", m.system},       {"compiler", m.compiler}, {"build", m.build},
            {"date", m.date},           {"load", m.load}};
}

Json probeJson(const ReportProbe& p, Pictures pictures)
{
    return {{"name", p.name},
            {"origin", p.origin},
            {"width", p.width},
            {"height", p.height},
            {"resampling_error", p.resamplingError},
            {"sun_share", p.sunShare},
            {"mean_luminance", p.meanLuminance},
            {"max_luminance", p.maxLuminance},
            {"repaired", describe(p.repaired)},
            {"picture", pictureJson(p.picture, pictures)}};
}

Json measurementJson(const Measurement& m, Pictures pictures)
{
    Json json{{"method", name(m.setting.method)},
              {"setting", m.setting.label},
              {"state", wordOf(m.state)},
              {"why", m.why},
              {"command", m.command}};
    if (m.state != MeasurementState::Measured)
        return json;
    json.update({{"ran", name(m.ran)},
                 {"filtered", m.filtered},
                 {"band_limit", m.bandLimit},
                 {"seconds", timesJson(m.times)},
                 {"next_lobe_seconds", timesJson(m.nextLobe)},
                 {"scaled", m.scaled},
                 {"peak_bytes", optionalNumber(m.peakBytes)},
                 {"rel_rms", m.error.relRms},
                 {"max_abs", m.error.maxAbs},
                 {"median_rel", m.error.medianRel},
                 {"p99_rel", m.error.p99Rel},
                 {"energy", m.energy},
                 {"seam_ratios", m.seamRatios},
                 {"predicted_error", m.predictedError},
                 {"predicted_seconds", m.predictedSeconds},
                 {"on_front", m.onFront},
                 {"error_picture", pictureJson(m.errorPicture, pictures)},
                 {"error_picture_limit", m.errorPictureLimit}});
    return json;
}

Json caseJson(const ReportCase& c, Pictures pictures)
{
    Json measurements = Json::array();
    for (const Measurement& m : c.measurements)
        measurements.push_back(measurementJson(m, pictures));
    return {{"probe", c.probe},
            {"lobe", describe(c.lobe)},
            {"reference_directions", c.referenceDirections},
            {"reference_complete", c.referenceComplete},
            {"stand_in", c.standIn},
            {"stand_in_error", c.standInError},
            {"picture", pictureJson(c.picture, pictures)},
            {"measurements", measurements}};
}

Json studyJson(const ParameterizationStudy& study)
{
    Json rows = Json::array();
    for (const ParameterizationRow& r : study.rows) {
        Json row = layoutJson(r.layout);
        row.update({{"texels", r.texels},
                    {"used", r.used},
                    {"mirror_error", r.mirrorError},
                    {"mirror_p99", r.mirrorP99},
                    {"filtered_error", r.filteredError},
                    {"density_ratio", r.densityRatio},
                    {"anisotropy_median", r.anisotropyMedian},
                    {"anisotropy_p99", r.anisotropyP99},
                    {"lookup_seconds", r.lookupSeconds},
                    {"draw_seconds", optionalNumber(r.drawSeconds)},
                    {"solid_angle", r.solidAngle}});
        rows.push_back(std::move(row));
    }
    return {{"probe", study.probe},           {"lobe", describe(study.lobe)},
            {"directions", study.directions}, {"reference_directions", study.referenceDirections},
            {"drawn_by", study.drawnBy},      {"rows", rows}};
}

Json growthJson(const GrowthPoint& p)
{
    return {{"axis", wordOf(p.axis)},
            {"at", p.at},
            {"method", name(p.method)},
            {"state", wordOf(p.state)},
            {"why", p.why},
            {"ran", name(p.ran)},
            {"filtered", p.filtered},
            {"streamed", p.streamed},
            {"seconds", timesJson(p.times)},
            {"peak_bytes", optionalNumber(p.peakBytes)},
            {"probe_bytes", p.probeBytes}};
}

Json sizesJson(const KernelSizes& sizes)
{
    return {{"small", sizes.small}, {"large", sizes.large}, {"small_shrink", sizes.smallShrink}, {"large_shrink", sizes.largeShrink}};
}

Json kernelTableJson(const KernelTable& table)
{
    Json rows = Json::array();
    for (const KernelTableRow& r : table.rows)
        rows.push_back({{"exponent", r.exponent},
                        {"sizes", sizesJson(r.sizes)},
                        {"published_sizes", sizesJson(r.publishedSizes)},
                        {"published_frames", r.publishedFrames},
                        {"blended_seconds", r.blendedSeconds},
                        {"exact_seconds", r.exactSeconds},
                        {"auto_seconds", r.autoSeconds},
                        {"auto_ran", name(r.autoRan)}});
    return {{"half", table.knobs.half},
            {"border", table.knobs.border},
            {"clamp", table.knobs.clamp},
            {"largest_kernel", table.knobs.largestKernel},
            {"target", layoutJson(table.target)},
            {"drawn_by", table.drawnBy},
            {"rows", rows}};
}

Json comparisonJson(const MethodComparison& comparison, Pictures pictures)
{
    Json maps = Json::array();
    for (const ComparedMap& m : comparison.maps)
        maps.push_back({{"label", m.label},
                        {"how", m.how},
                        {"seconds", m.seconds},
                        {"rel_rms", m.error.relRms},
                        {"max_abs", m.error.maxAbs},
                        {"p99_rel", m.error.p99Rel},
                        {"picture", pictureJson(m.picture, pictures)},
                        {"error_picture", pictureJson(m.errorPicture, pictures)},
                        {"error_picture_limit", m.errorPictureLimit}});
    return {{"probe", comparison.probe}, {"lobe", describe(comparison.lobe)}, {"target", layoutJson(comparison.target)}, {"maps", maps}};
}

Json stabilityJson(const StabilityRow& r)
{
    return {{"name", r.name},
            {"method", name(r.method)},
            {"refused", r.refused},
            {"finite", r.finite},
            {"rel_rms", r.error.relRms},
            {"max_abs", r.error.maxAbs},
            {"median_rel", r.error.medianRel},
            {"p99_rel", r.error.p99Rel},
            {"promised", r.promised},
            {"predicted_error", r.predictedError},
            {"energy", r.energy},
            {"lowest", r.lowest},
            {"constant_error", r.constantError},
            {"seconds", r.seconds},
            {"holds", r.holds()},
            {"failures", r.failures}};
}

Json shadingJson(const ShadingRow& r)
{
    return {{"family", r.family}, {"name", r.name},     {"places", r.places},    {"error", r.largestError},
            {"bound", r.bound},   {"holds", r.holds()}, {"failures", r.failures}};
}

Json verdictJson(const Verdict& v)
{
    return {{"probe", v.probe},
            {"lobe", describe(v.lobe)},
            {"tolerance", v.tolerance},
            {"auto_ran", name(v.autoRan)},
            {"auto_error", v.autoError},
            {"auto_seconds", v.autoSeconds},
            {"meets_tolerance", v.meetsTolerance()},
            {"fastest", v.fastest ? Json(name(*v.fastest)) : Json(nullptr)},
            {"fastest_setting", v.fastestSetting},
            {"fastest_seconds", v.fastestSeconds},
            {"auto_over_fastest", v.fastest ? Json(v.autoOverFastest()) : Json(nullptr)},
            {"importance_ratio", optionalNumber(v.importanceRatio)},
            {"importance_ratio_is_bound", v.importanceRatioIsBound},
            {"reference_ratio", optionalNumber(v.referenceRatio)}};
}

template <typename List, typename Make>
Json listJson(const List& list, Make&& make)
{
    Json json = Json::array();
    for (const auto& item : list)
        json.push_back(make(item));
    return json;
}

void writeText(const std::filesystem::path& path, const std::string& text)
{
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace

std::string reportJson(const Report& report, Pictures pictures)
{
    const Json json{{"mirrorball_report", 1},
                    {"version", report.version},
                    {"command", report.command},
                    {"complete", report.complete},
                    {"seconds", report.seconds},
                    {"parts", listJson(report.parts,
                                       [](const PartTime& t) {
                                           return Json{{"part", wordOf(t.part)}, {"foretold_seconds", t.foretold}, {"seconds", t.seconds}};
                                       })},
                    {"machine", machineJson(report.machine)},
                    {"load_at_end", report.loadAtEnd},
                    {"threads", report.threads},
                    {"device", report.device},
                    {"target", layoutJson(report.target)},
                    {"tolerance", report.tolerance},
                    {"repeats", report.repeats},
                    {"longest", report.longest},
                    {"conclusions", report.conclusions},
                    {"verdicts", listJson(report.verdicts, verdictJson)},
                    {"probes", listJson(report.probes, [&](const ReportProbe& p) { return probeJson(p, pictures); })},
                    {"cases", listJson(report.cases, [&](const ReportCase& c) { return caseJson(c, pictures); })},
                    {"parameterizations", listJson(report.parameterizations, studyJson)},
                    {"growth_lobe", describe(report.growthLobe)},
                    {"growth", listJson(report.growth, growthJson)},
                    {"stability", listJson(report.stability, stabilityJson)},
                    {"shading", listJson(report.shading, shadingJson)},
                    {"kernels", report.kernelTable ? kernelTableJson(*report.kernelTable) : Json(nullptr)},
                    {"distortion", listJson(report.distortion,
                                            [](const DistortionCurve& c) {
                                                return Json{{"radius", c.radius}, {"distortion", c.distortion}};
                                            })},
                    {"comparison", report.comparison ? comparisonJson(*report.comparison, pictures) : Json(nullptr)}};
    return json.dump(pictures == Pictures::Embedded ? -1 : 1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void checkReportFolder(const std::filesystem::path& folder)
{
    std::error_code ignored;
    std::filesystem::path nearest = std::filesystem::absolute(folder);
    while (!std::filesystem::exists(nearest, ignored) && nearest.has_relative_path())
        nearest = nearest.parent_path();
    if (!std::filesystem::is_directory(nearest, ignored))
        throw InvalidArgument(folder.string() + ": " + nearest.string() + " is no folder; choose another for the report");
    if (access(nearest.c_str(), W_OK | X_OK) != 0)
        throw InvalidArgument(folder.string() + ": " + nearest.string() + " is write-protected; choose another folder for the report");
    checkTarget(nearest / "report.html"); // what permissions do not tell: a full disk, a file system of the kernel's own
}

std::vector<std::filesystem::path> writeReport(const Report& report, const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw WorkError(folder.string() + ": cannot make this folder (" + error.message() + "); choose another for -o");
    std::vector<std::filesystem::path> files;
    const auto add = [&](const char* name, const std::string& text) {
        files.push_back(folder / name);
        writeText(files.back(), text);
    };
    add("report.html", htmlPage(reportJson(report, Pictures::Embedded)));
    add("report.json", reportJson(report, Pictures::LeftOut));
    if (!report.cases.empty() || !report.complete)
        add("measurements.csv", measurementsCsv(report));
    if (!report.growth.empty())
        add("growth.csv", growthCsv(report));
    if (!report.parameterizations.empty())
        add("parameterizations.csv", parameterizationsCsv(report));
    if (!report.stability.empty())
        add("stability.csv", stabilityCsv(report));
    if (!report.shading.empty())
        add("shading.csv", shadingCsv(report));
    if (report.kernelTable)
        add("kernels.csv", kernelsCsv(*report.kernelTable));
    if (!report.distortion.empty())
        add("distortion.csv", distortionCsv(report.distortion));
    if (report.comparison)
        for (const ComparedMap& map : report.comparison->maps)
            add(("comparison_" + map.label + ".png").c_str(), map.picture);
    return files;
}

} // namespace mirrorball
