#include "conclusions.h"

#include "verdicts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace mirrorball {

namespace {

double median(std::vector<double> values) { return RunTimes{std::move(values)}.median(); }

std::string times(double ratio)
{
    if (ratio < 100.0)
        return shortNumber(ratio) + " times";
    const double unit = std::pow(10.0, std::floor(std::log10(ratio)) - 1.0); // two digits
    return std::to_string(std::llround(ratio / unit) * std::llround(unit)) + " times";
}

std::string milliseconds(double seconds) { return seconds >= 1.0 ? shortNumber(seconds, 3) + " s" : shortNumber(1e3 * seconds, 3) + " ms"; }

std::string nanoseconds(double seconds) { return shortNumber(1e9 * seconds, 2) + " ns"; }

std::string megabytes(double bytes) { return std::to_string(std::lround(bytes / 1e6)) + " MB"; }

std::string list(const std::vector<std::string>& items)
{
    std::string text;
    for (size_t i = 0; i < items.size(); ++i)
        text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    return text;
}

std::string plural(size_t count, const std::string& noun) { return std::to_string(count) + " " + noun + (count == 1 ? "" : "s"); }

/// Which method is fastest at a tolerance, lobe by lobe.
void fastestMethods(const Report& report, std::vector<std::string>& sentences)
{
    std::map<std::string, std::map<Method, int>> wins;
    std::map<std::string, std::vector<double>> seconds, lead;
    std::vector<std::string> lobes;
    for (const Verdict& v : report.verdicts) {
        const std::string lobe = describe(v.lobe);
        if (!v.fastest)
            continue;
        if (!wins.contains(lobe))
            lobes.push_back(lobe);
        ++wins[lobe][*v.fastest];
        seconds[lobe].push_back(v.fastestSeconds);
    }
    for (const std::string& lobe : lobes) {
        const auto best =
            std::max_element(wins[lobe].begin(), wins[lobe].end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        std::string sentence = "For " + lobe + " at rel_rms " + shortNumber(report.tolerance) + " the fastest method is " +
                               std::string(name(best->first)) + " (" + milliseconds(median(seconds[lobe])) + ")";
        if (seconds[lobe].size() > 1)
            sentence += ", on " + std::to_string(best->second) + " of " + plural(seconds[lobe].size(), "probe");
        // What the next best method pays.
        std::map<Method, std::vector<double>> others;
        for (const ReportCase& c : report.cases)
            if (describe(c.lobe) == lobe) {
                const Measurement* winner = workingSetting(c.measurements, best->first, report.tolerance);
                for (const Method method : allMethods) {
                    if (method == Method::Auto || method == Method::Reference || method == best->first || !winner)
                        continue;
                    const auto other = timeForError(c.measurements, method, report.tolerance);
                    if (other && other->reached && winner->times.median() > 0.0)
                        others[method].push_back(other->seconds / winner->times.median());
                }
            }
        const auto next = std::min_element(others.begin(), others.end(),
                                           [](const auto& a, const auto& b) { return median(a.second) < median(b.second); });
        if (next != others.end())
            sentence += "; next comes " + std::string(name(next->first)) + " at " + times(median(next->second)) + " that";
        sentences.push_back(sentence + ".");
    }
}

/// Methods that reach the tolerance nowhere, with the best they do.
void methodsThatMiss(const Report& report, std::vector<std::string>& sentences)
{
    std::map<Method, double> best;
    std::map<Method, std::set<std::string>> where;
    for (const ReportCase& c : report.cases)
        for (const Measurement& m : c.measurements)
            if (m.state == MeasurementState::Measured && m.setting.method != Method::Auto && m.setting.method != Method::Reference) {
                const auto [entry, first] = best.try_emplace(m.setting.method, m.error.relRms);
                if (!first)
                    entry->second = std::min(entry->second, m.error.relRms);
            }
    std::vector<std::string> missing;
    for (const auto& [method, error] : best)
        if (error > report.tolerance)
            missing.push_back(std::string(name(method)) + " (best " + shortNumber(error, 2) + ")");
    if (!missing.empty())
        sentences.push_back("Within the knobs and the time tried, " + list(missing) + " never " +
                            (missing.size() == 1 ? "reaches" : "reach") + " rel_rms " + shortNumber(report.tolerance) + ".");
}

void autoVerdicts(const Report& report, std::vector<std::string>& sentences)
{
    if (report.verdicts.empty())
        return;
    size_t met = 0, near = 0, compared = 0;
    double worst = 0.0;
    for (const Verdict& v : report.verdicts) {
        met += v.meetsTolerance();
        if (v.fastest) {
            ++compared;
            near += v.autoOverFastest() <= 1.3;
            worst = std::max(worst, v.autoOverFastest());
        }
    }
    std::string sentence = "auto meets rel_rms " + shortNumber(report.tolerance) + " in " + std::to_string(met) + " of " +
                           plural(report.verdicts.size(), "case");
    if (compared > 0)
        sentence += " and is within 1.3 times the fastest method that meets it in " + std::to_string(near) + " of " +
                    std::to_string(compared) + " (at worst " + times(worst) + ")";
    sentences.push_back(sentence + ".");
}

void spectralAgainst(const Report& report, std::vector<std::string>& sentences)
{
    std::vector<double> importance, reference;
    bool bound = false;
    for (const Verdict& v : report.verdicts) {
        if (v.importanceRatio) {
            importance.push_back(*v.importanceRatio);
            bound = bound || v.importanceRatioIsBound;
        }
        if (v.referenceRatio)
            reference.push_back(*v.referenceRatio);
    }
    std::vector<std::string> parts;
    if (!importance.empty())
        parts.push_back(
            (bound ? "at least " : "") + times(median(importance)) + " faster than importance sampling at equal error" +
            (importance.size() > 1 ? " (lowest " + shortNumber(*std::min_element(importance.begin(), importance.end())) + ")" : ""));
    if (!reference.empty())
        parts.push_back(
            times(median(reference)) + " faster than the reference sum" +
            (reference.size() > 1 ? " (lowest " + shortNumber(*std::min_element(reference.begin(), reference.end())) + ")" : ""));
    if (!parts.empty())
        sentences.push_back("At rel_rms " + shortNumber(report.tolerance) + ", median over " +
                            plural(std::max(importance.size(), reference.size()), "case") + ", spectral is " + list(parts) + ".");
}

/// How far predictions are from what was measured.
void predictions(const Report& report, std::vector<std::string>& sentences)
{
    size_t count = 0, optimistic = 0;
    std::vector<double> timeFactors;
    for (const ReportCase& c : report.cases)
        for (const Measurement& m : c.measurements) {
            if (m.state != MeasurementState::Measured || m.setting.method == Method::Reference || !m.filtered)
                continue;
            if (m.predictedError > 0.0) {
                ++count;
                optimistic += m.error.relRms > m.predictedError;
            }
            if (const double taken = m.times.cpuMedian(); m.predictedSeconds > 0.0 && taken > 0.0)
                timeFactors.push_back(std::abs(std::log(taken / m.predictedSeconds)));
        }
    if (count > 0 && !timeFactors.empty())
        sentences.push_back("The measured error stays below the predicted one in " + std::to_string(count - optimistic) + " of " +
                            plural(count, "setting") + "; predicted CPU times are off by a factor of " +
                            shortNumber(std::exp(median(timeFactors)), 2) + " in the median.");
}

void seams(const Report& report, std::vector<std::string>& sentences)
{
    std::map<std::string, double> worst;
    for (const ReportCase& c : report.cases)
        for (const Measurement& m : c.measurements)
            if (m.state == MeasurementState::Measured)
                for (const double ratio : m.seamRatios)
                    if (std::isfinite(ratio)) {
                        const std::string who =
                            std::string(name(m.setting.method)) + (m.setting.method == Method::Mip ? " (" + m.setting.label + ")" : "");
                        worst[who] = std::max(worst[who], ratio);
                    }
    const auto most = std::max_element(worst.begin(), worst.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == worst.end() || most->second < 1.1)
        return;
    const auto least = std::min_element(worst.begin(), worst.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    constexpr double tellable = 1000.0; // beyond it there is hardly a step inside, as in a level of a few texels
    sentences.push_back("Seams show most in maps by " + most->first + ", which change " +
                        (most->second > tellable ? "over " + times(tellable) : "up to " + times(most->second)) +
                        " as much across a seam as beside it; least in those by " + least->first + " (" + shortNumber(least->second) +
                        ").");
}

void parameterizations(const Report& report, std::vector<std::string>& sentences)
{
    for (const ParameterizationStudy& study : report.parameterizations) {
        if (study.rows.empty())
            continue;
        const auto ordered = [&](auto member) {
            std::vector<const ParameterizationRow*> rows;
            for (const ParameterizationRow& row : study.rows)
                rows.push_back(&row);
            std::stable_sort(rows.begin(), rows.end(), [&](auto a, auto b) { return a->*member < b->*member; });
            return rows;
        };
        const auto kind = [](const ParameterizationRow* row) { return std::string(name(row->layout.kind)); };
        const auto mirror = ordered(&ParameterizationRow::mirrorError), filtered = ordered(&ParameterizationRow::filteredError),
                   lookup = ordered(&ParameterizationRow::lookupSeconds), draw = ordered(&ParameterizationRow::drawSeconds);
        const ParameterizationRow *least = filtered.front(), *most = filtered.back(),
                                  *even = ordered(&ParameterizationRow::densityRatio).front();
        sentences.push_back("At about " + std::to_string(study.rows.front().texels) + " texels, mirror lookups lose least in the " +
                            kind(mirror.front()) + " map (rel_rms " + shortNumber(mirror.front()->mirrorError, 2) +
                            "), lookups of the filtered map (" + describe(study.lobe) + ") least in the " + kind(least) + " map (" +
                            shortNumber(least->filteredError, 2) + ") and most in the " + kind(most) + " map (" +
                            shortNumber(most->filteredError, 2) + ").");
        std::string costs = "A lookup takes " + nanoseconds(lookup.front()->lookupSeconds) + " in the " + kind(lookup.front()) +
                            " map to " + nanoseconds(lookup.back()->lookupSeconds) + " in the " + kind(lookup.back()) + " map";
        if (draw.front()->drawSeconds)
            costs += ", a picture with one a pixel " + milliseconds(*draw.front()->drawSeconds) + " (" + kind(draw.front()) + ") to " +
                     milliseconds(*draw.back()->drawSeconds) + " (" + kind(draw.back()) + ")";
        sentences.push_back(costs + ".");
        std::string evenness = "Texels are most even in area in the " + kind(even) + " map (" + shortNumber(even->densityRatio, 3) +
                               " to 1), where on a hundredth of the sphere they are stretched by " + shortNumber(even->anisotropyP99) +
                               " to 1 and more";
        evenness += even == least ? "; its filtered lookups lose least, too."
                                  : ", and its filtered lookups lose " + times(even->filteredError / least->filteredError) +
                                        " what those of the " + kind(least) + " map do: evenness of area alone is no reason to choose it.";
        sentences.push_back(evenness);
    }
}

/// Slope of the logarithms over the last doublings.
void growth(const Report& report, std::vector<std::string>& sentences)
{
    std::vector<const GrowthPoint*> spectral;
    for (const GrowthPoint& p : report.growth)
        if (p.axis == GrowthAxis::ProbeWidth && p.method == Method::Spectral && p.state == MeasurementState::Measured)
            spectral.push_back(&p);
    if (spectral.size() >= 2) {
        const GrowthPoint &first = *spectral.front(), &last = *spectral.back();
        const double power = std::log(last.times.median() / first.times.median()) / std::log(last.at / first.at);
        std::string sentence = "From " + shortNumber(first.at, 5) + " to " + shortNumber(last.at, 5) +
                               " columns of the probe, spectral grows as the width to the power " + shortNumber(power, 2) + ", to " +
                               milliseconds(last.times.median());
        if (last.peakBytes)
            sentence += " and " + megabytes(static_cast<double>(*last.peakBytes)) +
                        (last.streamed ? " in all, the probe streamed" : " beside the probe");
        sentences.push_back(sentence + ".");
    }
}

void stability(const Report& report, std::vector<std::string>& sentences)
{
    if (report.stability.empty())
        return;
    size_t holds = 0, foretold = 0, refused = 0;
    std::vector<std::string> failing;
    for (const StabilityRow& row : report.stability) {
        refused += !row.refused.empty();
        (row.promised ? holds : foretold) += row.refused.empty() && row.holds();
        if (row.refused.empty() && !row.holds() && failing.size() < 5)
            failing.push_back(std::string(name(row.method)) + " on " + row.name);
    }
    std::string sentence = "Of " + plural(report.stability.size(), "extreme case") + " (a case and a method each), " +
                           std::to_string(holds) + " hold what they promise, " + std::to_string(foretold) +
                           " promise nothing and err as foretold, and " + std::to_string(refused) + " are refused with a reason";
    if (const size_t kept = holds + foretold + refused; kept < report.stability.size())
        sentence += "; " + std::to_string(report.stability.size() - kept) + " do not hold, among them " + list(failing);
    sentences.push_back(sentence + ".");

    std::vector<std::string> wrong;
    for (const ShadingRow& row : report.shading)
        if (!row.holds())
            wrong.push_back(row.family + ", " + row.name);
    if (!report.shading.empty())
        sentences.push_back("Of " + plural(report.shading.size(), "extreme case") + " of shading " +
                            (wrong.empty() ? "all hold" : std::to_string(wrong.size()) + " do not hold: " + list(wrong)) + ".");
}

} // namespace

std::vector<std::string> conclusions(const Report& report)
{
    std::vector<std::string> sentences;
    fastestMethods(report, sentences);
    spectralAgainst(report, sentences);
    autoVerdicts(report, sentences);
    methodsThatMiss(report, sentences);
    predictions(report, sentences);
    seams(report, sentences);
    parameterizations(report, sentences);
    growth(report, sentences);
    stability(report, sentences);
    const double load = std::max(report.machine.load, report.loadAtEnd);
    if (load > report.threads + 0.5)
        sentences.push_back("The machine was busy while this was measured (up to " + shortNumber(load) + " processes wanted its " +
                            plural(static_cast<size_t>(report.machine.cores), "core") +
                            "): compare times within the report, and repeat it on a quiet one.");
    return sentences;
}

} // namespace mirrorball
