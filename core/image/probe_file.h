#pragma once

#include "environment_map.h"
#include "image_io.h"
#include "layout_detection.h"
#include "repair.h"

#include "core/base/job.h"
#include "core/base/stage.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Probes as files: what the command line, scenes and the studio read alike.
namespace mirrorball {

struct ReadProbeOptions {
    std::optional<Parameterization> from{}; ///< forces the parameterization; empty: found out from the file
    NegativePolicy negatives = NegativePolicy::Keep;
};

struct Probe {
    EnvironmentMap map{};
    RepairReport repaired{};
    std::string origin{};        ///< how the parameterization was found, in words
    bool certain = true;         ///< false: a guess by shape alone (a square may be angular, sphere or octahedral)
    std::vector<Stage> stages{}; ///< what reading it took: "read probe" or "compute probe", "repair"
};

/// A probe that is opened once: its header goes to the plan, its rows to the filter or into memory. Movable.
class ProbeFile {
public:
    /// Opens `probe`, a path or `builtin:NAME`, and finds out its parameterization (layout_detection.h).
    /// @throws FileError, InvalidArgument
    ProbeFile(std::string probe, const ReadProbeOptions& options);

    bool isBuiltin() const { return !m_reader; }
    /// Of the map that read() gives.
    const MapLayout& layout() const { return m_detection.layout; }
    const Detection& detection() const { return m_detection; }
    NegativePolicy negatives() const { return m_options.negatives; }

    /// The rows of the file, for who needs no more than one pass. Not for a built-in probe.
    ImageReader& rows() { return *m_reader; }
    /// The whole of it, repaired (repair.h). Once; not after rows() was read. @throws FileError, Cancelled
    Probe read(const JobControl& job);

private:
    std::string m_probe;
    ReadProbeOptions m_options;
    std::unique_ptr<ImageReader> m_reader{}; ///< null: built in
    Detection m_detection{};
};

/// ProbeFile(probe, options).read(job)
Probe readProbe(const std::string& probe, const ReadProbeOptions& options = {}, const JobControl& job = {});

} // namespace mirrorball
