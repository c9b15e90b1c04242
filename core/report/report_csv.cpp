#include "report_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace mirrorball {

namespace {

/// Rows of a CSV file.
class Csv {
public:
    explicit Csv(const std::vector<std::string_view>& header)
    {
        for (const std::string_view title : header)
            cell(title);
        endRow();
    }
    Csv& cell(std::string_view text)
    {
        separate();
        const bool isFormula = !text.empty() && std::string_view("=+-@\t").find(text.front()) != std::string_view::npos;
        if (!isFormula && text.find_first_of(",\"\r\n") == std::string_view::npos) {
            m_text += text;
            return *this;
        }
        m_text += '"';
        if (isFormula) // spreadsheets would run it; a file's name may be anything
            m_text += '\'';
        for (const char c : text)
            m_text += c == '"' ? "\"\"" : std::string(1, c);
        m_text += '"';
        return *this;
    }
    Csv& cell(double value)
    {
        separate();
        if (!std::isfinite(value)) // an empty cell
            return *this;
        std::array<char, 32> digits{};
        m_text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
        return *this;
    }
    Csv& empty(int cells)
    {
        for (int i = 0; i < cells; ++i)
            cell(std::string_view{});
        return *this;
    }
    void endRow()
    {
        m_text += "\r\n";
        m_first = true;
    }
    std::string text() && { return std::move(m_text); }

private:
    void separate()
    {
        if (!m_first)
            m_text += ',';
        m_first = false;
    }
    std::string m_text{};
    bool m_first = true;
};

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

double bytesOrAbsent(const std::optional<std::int64_t>& bytes) { return bytes ? static_cast<double>(*bytes) : absent; }

} // namespace

std::string measurementsCsv(const Report& report)
{
    Csv csv({"probe",
             "lobe",
             "method",
             "setting",
             "state",
             "ran",
             "filtered",
             "band_limit",
             "median_seconds",
             "shortest_seconds",
             "longest_seconds",
             "cpu_seconds",
             "runs",
             "scaled",
             "next_lobe_seconds",
             "predicted_seconds",
             "peak_bytes",
             "rel_rms",
             "max_abs",
             "median_rel",
             "p99_rel",
             "predicted_error",
             "energy",
             "seam_ratio",
             "largest_level_seam_ratio",
             "on_front",
             "why",
             "command"});
    for (const ReportCase& c : report.cases)
        for (const Measurement& m : c.measurements) {
            csv.cell(report.probes[c.probe].name)
                .cell(describe(c.lobe))
                .cell(name(m.setting.method))
                .cell(m.setting.label)
                .cell(wordOf(m.state));
            if (m.state != MeasurementState::Measured) {
                csv.empty(21);
            } else {
                csv.cell(name(m.ran)).cell(m.filtered ? "yes" : "no").cell(m.bandLimit);
                csv.cell(m.times.median())
                    .cell(m.times.shortest())
                    .cell(m.times.longest())
                    .cell(m.times.cpuSeconds.empty() ? absent : m.times.cpuMedian())
                    .cell(static_cast<double>(m.times.seconds.size()));
                csv.cell(m.scaled ? "yes" : "no").cell(m.nextLobe.empty() ? absent : m.nextLobe.median()).cell(m.predictedSeconds);
                csv.cell(bytesOrAbsent(m.peakBytes)).cell(m.error.relRms).cell(m.error.maxAbs);
                csv.cell(m.error.medianRel).cell(m.error.p99Rel).cell(m.predictedError);
                csv.cell(m.energy).cell(m.seamRatios.empty() ? absent : m.seamRatios.front());
                csv.cell(m.seamRatios.empty() ? absent : *std::max_element(m.seamRatios.begin(), m.seamRatios.end()))
                    .cell(m.onFront ? "yes" : "no");
            }
            csv.cell(m.why).cell(m.command).endRow();
        }
    return std::move(csv).text();
}

std::string growthCsv(const Report& report)
{
    Csv csv({"axis", "at", "method", "state", "ran", "filtered", "streamed", "median_seconds", "cpu_seconds", "runs", "peak_bytes",
             "probe_bytes", "why"});
    for (const GrowthPoint& p : report.growth) {
        csv.cell(wordOf(p.axis)).cell(p.at).cell(name(p.method)).cell(wordOf(p.state));
        if (p.state != MeasurementState::Measured)
            csv.empty(7);
        else
            csv.cell(name(p.ran))
                .cell(p.filtered ? "yes" : "no")
                .cell(p.streamed ? "yes" : "no")
                .cell(p.times.median())
                .cell(p.times.cpuMedian())
                .cell(static_cast<double>(p.times.seconds.size()))
                .cell(bytesOrAbsent(p.peakBytes))
                .cell(static_cast<double>(p.probeBytes));
        csv.cell(p.why).endRow();
    }
    return std::move(csv).text();
}

std::string parameterizationsCsv(const Report& report)
{
    Csv csv({"probe", "lobe", "parameterization", "width", "height", "texels_used", "mirror_rel_rms", "mirror_p99_rel", "filtered_rel_rms",
             "largest_over_smallest_texel", "anisotropy_median", "anisotropy_p99", "lookup_seconds", "draw_seconds"});
    for (const ParameterizationStudy& study : report.parameterizations)
        for (const ParameterizationRow& r : study.rows) {
            csv.cell(report.probes[study.probe].name)
                .cell(describe(study.lobe))
                .cell(name(r.layout.kind))
                .cell(r.layout.width())
                .cell(r.layout.height());
            csv.cell(r.used).cell(r.mirrorError).cell(r.mirrorP99).cell(r.filteredError).cell(r.densityRatio);
            csv.cell(r.anisotropyMedian).cell(r.anisotropyP99).cell(r.lookupSeconds).cell(r.drawSeconds.value_or(absent)).endRow();
        }
    return std::move(csv).text();
}

std::string stabilityCsv(const Report& report)
{
    Csv csv({"case", "method", "outcome", "finite", "promised", "rel_rms", "max_abs", "median_rel", "p99_rel", "predicted_error", "energy",
             "lowest", "constant_error", "seconds", "why"});
    for (const StabilityRow& r : report.stability) {
        csv.cell(r.name)
            .cell(name(r.method))
            .cell(!r.refused.empty() ? "refused"
                  : !r.holds()       ? "fails"
                  : r.promised       ? "holds"
                                     : "as foretold");
        if (!r.refused.empty()) {
            csv.empty(11).cell(r.refused).endRow();
            continue;
        }
        csv.cell(r.finite ? "yes" : "no")
            .cell(r.promised ? "yes" : "no")
            .cell(r.error.relRms)
            .cell(r.error.maxAbs)
            .cell(r.error.medianRel)
            .cell(r.error.p99Rel)
            .cell(r.predictedError)
            .cell(r.energy);
        csv.cell(r.lowest).cell(r.constantError).cell(r.seconds);
        std::string why;
        for (const std::string& failure : r.failures)
            why += (why.empty() ? "" : "; ") + failure;
        csv.cell(why).endRow();
    }
    return std::move(csv).text();
}

std::string shadingCsv(const Report& report)
{
    Csv csv({"family", "case", "outcome", "places", "error", "bound", "why"});
    for (const ShadingRow& r : report.shading) {
        csv.cell(r.family).cell(r.name).cell(r.holds() ? "holds" : "fails").cell(static_cast<double>(r.places));
        csv.cell(r.largestError).cell(r.bound).cell(r.holds() ? "" : r.failures.front()).endRow();
    }
    return std::move(csv).text();
}

std::string kernelsCsv(const KernelTable& table)
{
    Csv csv({"exponent", "small", "large", "small_shrink", "large_shrink", "published_small", "published_large", "published_small_shrink",
             "published_large_shrink", "published_frames_a_second", "blended_frames_a_second", "exact_frames_a_second",
             "auto_frames_a_second", "auto_ran"});
    for (const KernelTableRow& r : table.rows) {
        csv.cell(r.exponent);
        for (const KernelSizes& sizes : {r.sizes, r.publishedSizes})
            csv.cell(sizes.small).cell(sizes.large).cell(sizes.smallShrink).cell(sizes.largeShrink);
        csv.cell(r.publishedFrames).cell(1.0 / r.blendedSeconds).cell(1.0 / r.exactSeconds).cell(1.0 / r.autoSeconds);
        csv.cell(name(r.autoRan)).endRow();
    }
    return std::move(csv).text();
}

std::string distortionCsv(const std::vector<DistortionCurve>& curves)
{
    std::vector<std::string> titles{"distance"};
    for (const DistortionCurve& curve : curves)
        titles.push_back("radius_" + shortNumber(curve.radius));
    Csv csv({titles.begin(), titles.end()});
    const size_t steps = curves.front().distortion.size();
    for (size_t i = 0; i < steps; ++i) {
        csv.cell(static_cast<double>(i) / static_cast<double>(steps - 1));
        for (const DistortionCurve& curve : curves)
            csv.cell(curve.distortion[i]);
        csv.endRow();
    }
    return std::move(csv).text();
}

} // namespace mirrorball
