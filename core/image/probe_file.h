#pragma once

#include "environment_map.h"
#include "image_io.h"
#include "layout_detection.h"
#include "repair.h"
#include "repaired_reader.h"

#include "core/base/job.h"
#include "core/base/stage.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Probes as files: what the command line, scenes and the studio read alike.
namespace mirrorball {

struct ReadProbeOptions {
    ProbeReading reading{};
    NegativePolicy negatives = NegativePolicy::Keep;
};

struct Probe {
    EnvironmentMap map{};
    RepairReport repaired{};
    std::string origin{};              ///< how the parameterization was found, in words
    bool certain = true;               ///< false: a guess by shape alone (a square may be angular, sphere or octahedral)
    std::vector<Stage> stages{};       ///< what reading it took: "read probe" or "compute probe", "repair"
    std::vector<Assumption> assumed{}; ///< all that was decided about the file
    std::vector<std::string> notes{};  ///< what of it a user should know, a clause each
};

/// What was decided about a probe by its file's header and by its layout, together.
std::vector<Assumption> allAssumed(const ImageFileInfo& info, const Detection& detection);
/// Their notes, too, and where the file is one of six faces that lie beside it, a word about that.
std::vector<std::string> allNotes(const ImageFileInfo& info, const Detection& detection);
/// Whether nothing of it is a guess.
bool isCertain(const std::vector<Assumption>& assumed);

/// A probe that is opened once: its header goes to the plan, its rows to the filter or into memory. Movable.
class ProbeFile {
public:
    /// Opens `probe`, a path, six or two with a `%s` (probe_picture.h), or `builtin:NAME`, and finds out what it is (layout_detection.h).
    /// @throws FileError, InvalidArgument
    ProbeFile(std::string probe, const ReadProbeOptions& options);

    bool isBuiltin() const { return !m_reader; }
    /// Of the map that read() gives.
    const MapLayout& layout() const { return m_detection.layout; }
    const Detection& detection() const { return m_detection; }
    NegativePolicy negatives() const { return m_options.negatives; }

    /// The rows of the file, repaired (repair.h), for who needs no more than one pass. Not for a built-in probe.
    RepairedReader& rows() { return *m_reader; }
    /// The whole of it, repaired (repair.h). Once; not after rows() was read. @throws FileError, Cancelled
    Probe read(const JobControl& job);

private:
    std::string m_probe;
    ReadProbeOptions m_options;
    std::unique_ptr<RepairedReader> m_reader{}; ///< null: built in
    Detection m_detection{};
};

/// ProbeFile(probe, options).read(job)
Probe readProbe(const std::string& probe, const ReadProbeOptions& options = {}, const JobControl& job = {});

} // namespace mirrorball
