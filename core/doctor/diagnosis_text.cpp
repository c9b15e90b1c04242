#include "diagnosis.h"

#include "core/sphere/direction.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace mirrorball {

namespace {

template <typename... Values>
std::string text(const char* format, Values... values)
{
    std::array<char, 512> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

std::string lobeText(const LobeFit& fit)
{
    if (fit.unfiltered)
        return "none";
    return fit.lobe.kind == LobeKind::Phong ? text("phong:%.3g", fit.lobe.exponent) : fit.alpha > 0.97 ? "diffuse" : "ggx";
}

std::string sizeText(const MapLayout& layout)
{
    return layout.kind == Parameterization::Cube ? text("%d", layout.size) : text("%dx%d", layout.width(), layout.height());
}

nlohmann::json errorJson(const ErrorMetrics& e) { return {{"rel_rms", e.relRms}, {"max_abs", e.maxAbs}, {"p99_rel", e.p99Rel}}; }

nlohmann::json levelJson(const Diagnosis& d, size_t index)
{
    const LevelDiagnosis& level = d.levels[index];
    nlohmann::json json{{"level", index},
                        {"size", level.layout.size},
                        {"largest", level.largest},
                        {"smallest", level.smallest},
                        {"mean", {level.mean.r, level.mean.g, level.mean.b}},
                        {"nan", level.repaired.nan},
                        {"inf", level.repaired.positiveInfinity + level.repaired.negativeInfinity},
                        {"negative", level.repaired.negative},
                        {"seam", std::isfinite(level.seam) ? nlohmann::json(level.seam) : nlohmann::json()}};
    if (!d.withProbe && !d.levelZeroIsProbe)
        return json;
    json["lobe"] = lobeText(level.fit);
    json["alpha"] = level.fit.alpha;
    json["roughness"] = std::sqrt(level.fit.alpha);
    if (level.fit.lobe.kind == LobeKind::Phong)
        json["exponent"] = level.fit.lobe.exponent;
    json["scale"] = level.fit.scale;
    json["residual"] = level.fit.residual;
    json["energy"] = level.energy;
    if (level.asked)
        json["law_alpha"] = *level.asked;
    json["rel_rms_as_stored"] = level.storedRelRms;
    json["error"] = errorJson(level.mended);
    if (level.shift.known)
        json["shift"] = {{"right", level.shift.right}, {"down", level.shift.down}, {"spread", level.shift.spread}};
    return json;
}

nlohmann::json orientationJson(const Orientation& o)
{
    nlohmann::json faces = nlohmann::json::array();
    for (const FacePlace& place : o.places)
        faces.push_back({{"shows", faceName(place.face)}, {"turned", describeTurn(place.turn)}});
    nlohmann::json axes = nlohmann::json::array();
    for (int row = 0; row < 3; ++row)
        axes.push_back({o.storage.axes[0][row], o.storage.axes[1][row], o.storage.axes[2][row]});
    nlohmann::json stray = nlohmann::json::array();
    for (const int face : o.strayFaces)
        stray.push_back(faceName(face));
    return {{"is", describe(o)},
            {"certain", o.certain()},
            {"match", o.match},
            {"next_match", o.nextMatch},
            {"mirrored", o.mirrored()},
            {"axes", axes},
            {"rows_bottom_up", o.storage.turn == rowsBottomUp},
            {"yaw_deg", o.yaw * 180.0 / pi},
            {"faces", faces},
            {"stray_faces", stray}};
}

} // namespace

std::string diagnosisText(const Diagnosis& d)
{
    std::string out;
    const LevelDiagnosis& first = d.levels.front();
    out += text("file         %s, %s texels", d.container.c_str(), d.texels.c_str()) + (d.files > 1 ? text(", %zu files", d.files) : "") +
           (d.hasSphericalHarmonics ? ", with nine coefficients of the diffuse light" : "") + "\n";
    out += "layout       " + std::string(name(d.kind)) + (d.certain ? "" : ", a guess") + " of " + sizeText(first.layout) + ", " +
           text("%zu level%s", d.levels.size(), d.levels.size() == 1 ? "" : "s") + (d.shape.empty() ? "" : " (" + d.shape + ")") + "\n";
    if (d.orientation)
        out += "orientation  " + describe(*d.orientation) +
               text(" (match %.3f, next best %.3f%s)", d.orientation->match, d.orientation->nextMatch,
                    d.orientation->certain() ? "" : ": not certain") +
               "\n";
    const bool measured = d.withProbe || d.levelZeroIsProbe;
    if (measured && d.lawFound() && d.chain > 1)
        out += "law          " + d.laws.front().formula + "\n";
    if (d.withProbe)
        out += text("scale        %.4g\n", d.scale) + "curve        " + std::string(name(d.transfer.transfer)) + "\n";
    if (d.levelZeroIsProbe)
        out += "compared     with level 0, taken for the unfiltered environment\n";
    out += measured ? "\nlevel   size  lobe       roughness  alpha    law alpha  energy  seam   rel_rms   as stored  shift x,y    largest\n"
                    : "\nlevel   size  seam   largest\n";
    for (size_t l = 0; l < d.levels.size(); ++l) {
        const LevelDiagnosis& level = d.levels[l];
        if (!measured) {
            out += text("%5zu  %5s  %5.2f  %8.5g\n", l, sizeText(level.layout).c_str(), level.seam, level.largest);
            continue;
        }
        out +=
            text("%5zu  %5s  %-9s  %9.3f  %7.4f  %9s  %6.3f  %5.2f  %8.4f  %9.4f  %-11s  %8.5g\n", l, sizeText(level.layout).c_str(),
                 lobeText(level.fit).c_str(), std::sqrt(level.fit.alpha), level.fit.alpha,
                 level.asked ? text("%.4f", *level.asked).c_str() : "-", level.energy, level.seam, level.mended.relRms, level.storedRelRms,
                 level.shift.known ? text("%+.2f,%+.2f", level.shift.right, level.shift.down).c_str() : "-", level.largest);
    }
    out += "\n";
    for (const Severity severity : {Severity::Fault, Severity::Note})
        for (const Finding& finding : d.findings)
            if (finding.severity == severity)
                out += (severity == Severity::Fault ? "FAULT  " : "note   ") + finding.kind + ": " + finding.text +
                       (finding.cure.empty() ? "" : "\n       -> " + finding.cure) + "\n";
    out += d.clean() ? "verdict: no fault found\n" : "verdict: faults found\n";
    return out;
}

std::string diagnosisJson(const Diagnosis& d)
{
    nlohmann::json levels = nlohmann::json::array(), findings = nlohmann::json::array(), laws = nlohmann::json::array();
    for (size_t l = 0; l < d.levels.size(); ++l)
        levels.push_back(levelJson(d, l));
    for (const Finding& f : d.findings)
        findings.push_back(
            {{"severity", f.severity == Severity::Fault ? "fault" : "note"}, {"kind", f.kind}, {"text", f.text}, {"cure", f.cure}});
    for (const LawFit& law : d.laws)
        laws.push_back({{"name", law.name}, {"formula", law.formula}, {"error", law.error}, {"roughness", law.roughness}});
    nlohmann::json json{{"map", d.map},
                        {"probe", d.probe.empty() ? nlohmann::json() : nlohmann::json(d.probe)},
                        {"container", d.container},
                        {"texels", d.texels},
                        {"parameterization", name(d.kind)},
                        {"certain", d.certain},
                        {"size", d.levels.front().layout.size},
                        {"with_probe", d.withProbe},
                        {"spherical_harmonics", d.hasSphericalHarmonics},
                        {"orientation", d.orientation ? orientationJson(*d.orientation) : nlohmann::json()},
                        {"curve", name(d.transfer.transfer)},
                        {"curve_before_filtering", d.curveBeforeFiltering},
                        {"scale", d.scale},
                        {"law", d.lawFound() && d.chain > 1 ? nlohmann::json(d.laws.front().name) : nlohmann::json()},
                        {"laws", laws},
                        {"chain", d.chain},
                        {"engines", d.engines},
                        {"levels", levels},
                        {"findings", findings},
                        {"verdict", d.clean() ? "clean" : "faults"}};
    if (d.clipping)
        json["clipping"] = {{"value", d.clipping->value},
                            {"lost", d.clipping->lost},
                            {"texels", d.clipping->texels},
                            {"before_filtering", d.clipping->filtered}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace mirrorball
