#include "probe_file.h"

#include "builtin_probes.h"
#include "cube_sheet.h"
#include "probe_picture.h"

#include "core/base/error.h"

#include <algorithm>

namespace mirrorball {

namespace {

constexpr std::string_view builtinPrefix = "builtin:";

} // namespace

ProbeFile::ProbeFile(std::string probe, const ReadProbeOptions& options) : m_probe(std::move(probe)), m_options(options)
{
    if (m_probe.starts_with(builtinPrefix)) {
        builtinProbe(std::string_view(m_probe).substr(builtinPrefix.size())); // says when there is none of that name
        checkFaceOrder(options.reading.faces);
        if (!options.reading.faces.empty())
            throw InvalidArgument("faces: belongs to cubes whose faces lie on a sheet or in six files, not to a built-in probe");
        m_detection = {.layout = builtinProbeLayout, .reason = "built in"};
        m_detection.orientation = orientation(options.reading);
        m_detection.assumed = {{"parameterization", std::string(name(builtinProbeLayout.kind)), "built in"},
                               {"encoding", "linear, Rec.709 primaries", "built in"},
                               {"handedness", "a picture from inside: +Z in the middle, +X left of it", "built in"}};
        return;
    }
    m_reader = openProbePicture(m_probe, options.reading, options.negatives);
    m_detection = detectLayout(m_reader->info(), options.reading);
}

Probe ProbeFile::read(const JobControl& job)
{
    Probe result{.origin = m_detection.reason, .certain = m_detection.certain};
    if (isBuiltin()) {
        result.map = timedStage(result.stages, "compute probe", [&] {
            result.assumed = m_detection.assumed;
            return toEnvironmentMap(renderBuiltinProbe(m_probe.substr(builtinPrefix.size()), builtinProbeLayout, job).image, m_detection,
                                    job);
        });
        return result;
    }
    Image image = timedStage(result.stages, "read probe", [&] { return readAll(*m_reader, job); });
    result.assumed = allAssumed(m_reader->info(), m_detection);
    result.notes = allNotes(m_reader->info(), m_detection);
    result.certain = result.certain && isCertain(result.assumed);
    result.stages.back().why = summary(result.assumed);
    result.repaired = m_reader->report();
    result.stages.push_back({.name = "repair", .why = describe(result.repaired)});
    result.map = toEnvironmentMap(std::move(image), m_detection, job);
    return result;
}

std::vector<Assumption> allAssumed(const ImageFileInfo& info, const Detection& detection)
{
    std::vector<Assumption> all = info.assumed;
    for (const Assumption& assumption : detection.assumed)
        assume(all, assumption);
    const auto unlessKnown = [&](Assumption assumption) {
        if (std::none_of(all.begin(), all.end(), [&](const Assumption& a) { return a.topic == assumption.topic; }))
            all.push_back(std::move(assumption));
    };
    unlessKnown({"part", "0", "the only one"});
    unlessKnown({"layer", "default", "the format has no layers"});
    unlessKnown({"windows", "the whole picture", "the format has no windows"});
    unlessKnown({"orientation", "upright", "the file says nothing of another"});
    unlessKnown({"alpha", "none", "the format has none, or its readers leave it out"});
    return all;
}

std::vector<std::string> allNotes(const ImageFileInfo& info, const Detection& detection)
{
    std::vector<std::string> all = info.notes;
    all.insert(all.end(), detection.notes.begin(), detection.notes.end());
    if (info.width == info.height)
        if (const auto family = faceFamily(info.path))
            all.push_back("it is one of six cube faces; " + *family + " reads them all");
    return all;
}

bool isCertain(const std::vector<Assumption>& assumed)
{
    return std::none_of(assumed.begin(), assumed.end(), [](const Assumption& a) { return a.certainty == Certainty::Guess; });
}

Probe readProbe(const std::string& probe, const ReadProbeOptions& options, const JobControl& job)
{
    return ProbeFile(probe, options).read(job);
}

} // namespace mirrorball
