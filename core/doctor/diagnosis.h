#pragma once

#include "law_fit.h"
#include "lobe_fit.h"
#include "orientation.h"
#include "sample_shift.h"
#include "stored_map.h"
#include "transfer_fit.h"

#include "core/report/error_metrics.h"

#include <optional>
#include <string>
#include <vector>

/// What a prefiltered map of anyone is, measured.
namespace mirrorball {

struct LevelDiagnosis {
    MapLayout layout{};
    RepairReport repaired{};
    double largest = 0.0, smallest = 0.0; ///< of any channel, as stored
    glm::dvec3 mean{0.0};                 ///< weighted by solid angle, as stored
    double seam = 0.0;                    ///< seam_ratio.h, faces moved to our convention
    LobeFit fit{};
    double energy = 0.0;           ///< mean luminance over that of the truth, of the map once its scale and curve are undone
    std::optional<double> asked{}; ///< alpha that the law asks of it; else what was measured is the truth's
    double storedRelRms = 0.0;     ///< rel_rms against the truth, as stored
    ErrorMetrics mended{};         ///< once orientation, scale and curve are undone
    double truthSeam = 0.0;
    SampleShift shift{};
};

/// Light that the map cannot hold.
struct Clipping {
    double value = 0.0;    ///< the largest that level 0 holds, as stored
    double lost = 0.0;     ///< share of the probe's light that is above it
    int texels = 0;        ///< of level 0 that should be brighter
    bool filtered = false; ///< the levels were filtered from the clipped environment
};

enum class Severity { Note, Fault };

/// One thing to know about the map.
struct Finding {
    Severity severity = Severity::Note;
    std::string
        kind{}; ///< a word: "orientation", "face", "law", "order", "lobe", "scale", "curve", "clipped", "seam", "energy", "shift", ...
    std::string text{}; ///< what was found
    std::string cure{}; ///< what to do about it; may be empty
};

struct Diagnosis {
    std::string map{}, probe{}; ///< names, for the record
    // The file.
    std::string container{}, texels{}, shape{};
    Parameterization kind = Parameterization::Cube;
    bool certain = true;
    size_t files = 1;
    bool hasSphericalHarmonics = false; ///< the container holds nine coefficients beside the levels

    bool withProbe = false;
    bool levelZeroIsProbe = false; ///< without a probe: level 0 is sharp and serves as one
    std::optional<Orientation> orientation{};
    TransferFit transfer{};
    bool curveBeforeFiltering = false;
    std::optional<Clipping> clipping{};
    double scale = 1.0; ///< of the levels once the curve is undone
    std::vector<LevelDiagnosis> levels{};
    std::vector<LawFit> laws{}; ///< the best first; of the levels that are filtered ever more
    size_t chain = 0;           ///< how many those are; a last level may be the diffuse light
    bool lawFound() const { return !laws.empty() && laws.front().error < lawTolerance; }
    std::vector<std::string> engines{}; ///< titles of those that take orientation and law as they are
    std::vector<Finding> findings{};

    bool clean() const;
};

struct DiagnoseOptions {
    double tolerance = 1e-3; ///< of the truth that levels are compared with
};

/// Examines a map. With `probe`, what it was made from (any parameterization): orientation, curve, scale, lobe, law, and the error of every
/// level against the truth of our own filters. Without: what the levels tell of each other.
/// @throws InvalidArgument; Cancelled
Diagnosis diagnose(const StoredMap& map, const std::optional<EnvironmentMap>& probe, const DiagnoseOptions& options = {},
                   const JobControl& job = {});

/// Fills `findings` and `engines` from what was measured.
void concludeDiagnosis(Diagnosis& diagnosis);

/// For people, and for programs.
std::string diagnosisText(const Diagnosis& diagnosis);
std::string diagnosisJson(const Diagnosis& diagnosis);

} // namespace mirrorball
