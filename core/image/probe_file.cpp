#include "probe_file.h"

#include "builtin_probes.h"

namespace mirrorball {

namespace {

constexpr std::string_view builtinPrefix = "builtin:";

} // namespace

ProbeFile::ProbeFile(std::string probe, const ReadProbeOptions& options) : m_probe(std::move(probe)), m_options(options)
{
    if (m_probe.starts_with(builtinPrefix)) {
        builtinProbe(std::string_view(m_probe).substr(builtinPrefix.size())); // says when there is none of that name
        m_detection = {.layout = builtinProbeLayout, .reason = "built in"};
        return;
    }
    m_reader = openImage(m_probe);
    m_detection = detectLayout(m_reader->info(), options.from);
}

Probe ProbeFile::read(const JobControl& job)
{
    Probe result{.origin = m_detection.reason, .certain = m_detection.certain};
    if (isBuiltin()) {
        result.map = timedStage(result.stages, "compute probe",
                                [&] { return renderBuiltinProbe(m_probe.substr(builtinPrefix.size()), builtinProbeLayout, job); });
        return result;
    }
    Image image = timedStage(result.stages, "read probe", [&] { return readImage(*m_reader, job); });
    result.repaired = timedStage(result.stages, "repair", [&] { return repair(image, m_options.negatives); });
    result.stages.back().why = describe(result.repaired);
    result.map = toEnvironmentMap(std::move(image), m_detection, job);
    return result;
}

Probe readProbe(const std::string& probe, const ReadProbeOptions& options, const JobControl& job)
{
    return ProbeFile(probe, options).read(job);
}

} // namespace mirrorball
