#pragma once

#include "error_metrics.h"
#include "machine.h"
#include "method_settings.h"
#include "report_parts.h"
#include "run_times.h"
#include "shading_stability.h"
#include "stability.h"

#include "core/filter/paraboloid.h"
#include "core/image/repair.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What a report holds: plain values, filled by makeReport() and written by report_files.h. Times are seconds of wall time, memory is
/// bytes, pictures are the bytes of a .png.
namespace mirrorball {

enum class MeasurementState {
    Measured,
    Refused, ///< the method cannot do this case
    LeftOut, ///< it would take longer than a report may, or the report was stopped
    Failed
};
std::span<const std::string_view> words(MeasurementState); // measured refused left-out failed

/// One setting of one method on one probe with one lobe.
struct Measurement {
    MethodSetting setting{};
    MeasurementState state = MeasurementState::Measured;
    std::string why{};         ///< why refused or left out; why auto chose what it chose
    Method ran = Method::Auto; ///< what auto chose
    bool filtered = true;      ///< false: the lobe is unresolved, the map is a lookup
    int bandLimit = 0;
    RunTimes times{};                        ///< of the first lobe of a probe: spectrum or pyramid included
    RunTimes nextLobe{};                     ///< of a further one, which finds them made
    bool scaled = false;                     ///< the times were measured at a part of the texels and scaled to all
    std::optional<std::int64_t> peakBytes{}; ///< beside the probe
    ErrorMetrics error{};
    double energy = 1.0;              ///< mean of the map over mean of the probe
    std::vector<double> seamRatios{}; ///< (seam_ratio.h) of the map, and of the maps of half the size, a quarter, ...
    double predictedError = 0.0;
    double predictedSeconds = 0.0;
    bool onFront = false; ///< no other method was both faster and more accurate
    std::string command{};
    std::string errorPicture{};     ///< signed error; empty but for one setting a method
    double errorPictureLimit = 0.0; ///< its full colors, over the reference's root mean square
};

/// One probe with one lobe.
struct ReportCase {
    size_t probe = 0; ///< index into Report::probes
    Lobe lobe{};
    int referenceDirections = 0;    ///< weighted texels at which the error is measured
    bool referenceComplete = false; ///< all texels of the map
    double standInError = 0.0;      ///< rel_rms of the map that error pictures are taken against
    std::string standIn{};          ///< how that map was made
    std::string picture{};          ///< the filtered map, tone-mapped
    std::vector<Measurement> measurements{};
};

struct ReportProbe {
    std::string name{};        ///< as given
    std::string origin{};      ///< how its parameterization was found
    int width = 0, height = 0; ///< of its latlong form
    double resamplingError = 0.0;
    double sunShare = 0.0; ///< of the energy, in the brightest 0.01 % of the texels
    double meanLuminance = 0.0, maxLuminance = 0.0;
    RepairReport repaired{};
    std::string picture{};
};

/// One parameterization at about as many texels as the others.
struct ParameterizationRow {
    MapLayout layout{};
    int texels = 0; ///< of the image; `used` of them lie on the map
    int used = 0;
    double mirrorError = 0.0;            ///< rel_rms of bilinear lookups of the probe resampled to it
    double mirrorP99 = 0.0;              ///< p99_rel of them, in which a sun does not drown the rest
    double filteredError = 0.0;          ///< rel_rms of bilinear lookups of the filtered map
    double densityRatio = 0.0;           ///< largest solid angle of a texel over the smallest
    double anisotropyMedian = 1.0;       ///< longer over shorter axis of what a texel stands for (distortion.h), by solid angle
    double anisotropyP99 = 1.0;          ///< no more than 1 % of the sphere is stretched by more
    double lookupSeconds = 0.0;          ///< one bilinear lookup on one thread
    std::optional<double> drawSeconds{}; ///< a picture of a sphere that mirrors the map; empty without something to draw with
    std::vector<double> solidAngle{};    ///< of a texel over its mean, at angles 0 .. 180 degrees from +Z towards +Y, equally spaced
};

struct ParameterizationStudy {
    size_t probe = 0;
    Lobe lobe{};
    int directions = 0;
    int referenceDirections = 0;
    std::string drawnBy{}; ///< empty: drawing was not timed
    std::vector<ParameterizationRow> rows{};
};

/// One exponent of the table of kernel sizes in 000 section 3.2.5. A frame is: the probe filtered anew, and a sphere drawn that mirrors it.
struct KernelTableRow {
    double exponent = 0.0;
    KernelSizes sizes{};           ///< of the two kernels, and how far the map shrinks for each
    KernelSizes publishedSizes{};  ///< as the paper prints them
    double publishedFrames = 0.0;  ///< frames a second on an SGI O2, of 1996
    double blendedSeconds = 0.0;   ///< a frame by the paper's two kernels
    double exactSeconds = 0.0;     ///< by kernels that are exact at every place
    double autoSeconds = 0.0;      ///< by what `auto` chooses at the report's tolerance
    Method autoRan = Method::Auto; ///< what that is
};

struct KernelTable {
    std::vector<KernelTableRow> rows{};
    ParaboloidKnobs knobs{}; ///< of the paper's method
    MapLayout target{};
    std::string drawnBy{}; ///< empty: nothing was drawn, a frame is the filter alone
};

/// 000 figure 12 for one radius: what happens to a circle of the paraboloid map on the sphere, at equally spaced distances 0 .. 1 of its
/// middle from the map's.
struct DistortionCurve {
    double radius = 0.0;              ///< 1: from the map's middle to its rim
    std::vector<double> distortion{}; ///< circleDistortion()
};

/// One picture of 000 figure 13.
struct ComparedMap {
    std::string label{};        ///< "unfiltered", "classic", "hierarchical", "hardware"
    std::string how{};          ///< method and knobs, in words
    double seconds = 0.0;       ///< wall time; 0: nothing was filtered
    ErrorMetrics error{};       ///< against the classic method
    std::string picture{};      ///< both halves, front on the left
    std::string errorPicture{}; ///< signed; empty for the first two
    double errorPictureLimit = 0.0;
};

struct MethodComparison {
    size_t probe = 0;
    Lobe lobe{};
    MapLayout target{};
    std::vector<ComparedMap> maps{};
};

/// How the cost of one method grows.
enum class GrowthAxis { ProbeWidth, Exponent };
std::span<const std::string_view> words(GrowthAxis); // probe-width exponent

struct GrowthPoint {
    GrowthAxis axis = GrowthAxis::ProbeWidth;
    double at = 0.0; ///< columns of the probe, or exponent
    Method method = Method::Auto;
    MeasurementState state = MeasurementState::Measured;
    std::string why{};
    Method ran = Method::Auto;
    bool filtered = true;
    bool streamed = false; ///< the probe's rows were made on the fly and never held
    RunTimes times{};
    std::optional<std::int64_t> peakBytes{}; ///< beside the probe in memory
    std::int64_t probeBytes = 0;             ///< of the probe in memory
};

/// What is asked of `auto`, for one probe and lobe (verdicts.h).
struct Verdict {
    size_t probe = 0;
    Lobe lobe{};
    double tolerance = 0.0;
    double autoError = 0.0, autoSeconds = 0.0;
    Method autoRan = Method::Auto;
    std::optional<Method> fastest{}; ///< the fastest method that meets the tolerance
    std::string fastestSetting{};
    double fastestSeconds = 0.0;
    std::optional<double> importanceRatio{}; ///< time of importance over that of spectral at equal error
    bool importanceRatioIsBound = false;     ///< importance did not reach it in the time a report has: at least so much
    std::optional<double> referenceRatio{};  ///< time of the reference over that of spectral

    bool meetsTolerance() const { return autoError <= tolerance; }
    double autoOverFastest() const { return fastest ? autoSeconds / fastestSeconds : 0.0; }
};

/// What a part of the report was expected to take, and took.
struct PartTime {
    ReportPart part = ReportPart::Methods;
    double foretold = 0.0;
    double seconds = 0.0;
};

struct Report {
    std::string version{};
    std::string command{}; ///< as typed
    Machine machine{};
    double loadAtEnd = 0.0;
    int threads = 0;
    std::string device{}; ///< of the paraboloid method; empty: none
    bool complete = true; ///< false: it was stopped
    double seconds = 0.0; ///< the whole report
    std::vector<PartTime> parts{};
    MapLayout target{};
    double tolerance = 1e-3;
    int repeats = 0;
    double longest = 0.0;
    std::vector<ReportProbe> probes{};
    std::vector<ReportCase> cases{};
    std::vector<ParameterizationStudy> parameterizations{};
    std::vector<GrowthPoint> growth{};
    Lobe growthLobe{};
    std::vector<StabilityRow> stability{};
    std::vector<ShadingRow> shading{}; ///< with the table of extreme cases
    std::optional<KernelTable> kernelTable{};
    std::vector<DistortionCurve> distortion{};
    std::optional<MethodComparison> comparison{};
    std::vector<Verdict> verdicts{};
    std::vector<std::string> conclusions{};
};

} // namespace mirrorball
