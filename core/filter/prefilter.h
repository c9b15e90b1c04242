#pragma once

#include "bright_texels.h"
#include "lobe.h"
#include "ring_grid.h"
#include "spectrum.h"

#include "../image/environment_map.h"
#include "../job.h"
#include "../stage.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Prefiltering: the one interface over the methods. Each method has a file of its own; `Auto` chooses among them.
namespace mirrorball {

enum class Method { Auto, Reference, Spectral, Direct };

inline constexpr std::array allMethods{Method::Auto, Method::Reference, Method::Spectral, Method::Direct};

/// "auto", "reference", "spectral", "direct"
std::string_view name(Method method);
std::optional<Method> methodFromName(std::string_view word);

/// Height of the latlong form that a probe of this layout is resampled to: its smallest texels stay apart.
int latlongHeight(const MapLayout& layout);

/// A probe made ready for filtering. Holds its latlong form, and its spectrum once a method has asked for it: many lobes share both.
/// A probe too large to hold is streamed through a SpectrumBuilder instead and has a spectrum only. Cheap to copy; the spectrum is
/// kept for later calls, so one thread at a time may filter through one object.
class FilterSource {
public:
    /// A probe in memory. Another parameterization than latlong is resampled to one, finely enough to keep its texels apart.
    explicit FilterSource(EnvironmentMap probe, const JobControl& job = {});
    /// A probe that was streamed.
    explicit FilterSource(Spectrum spectrum);

    /// Size of the latlong form that the reference sum runs over.
    int width() const { return m_width; }
    int height() const { return m_height; }
    /// rel_rms of the latlong form, read at the texels of a probe that came in another parameterization; 0 when it came as latlong.
    double resamplingError() const { return m_resamplingError; }
    /// Null when the probe was streamed.
    const EnvironmentMap* latlong() const { return m_latlong.get(); }
    /// A spectrum known at least to `bandLimit`, computed when there is none yet. @throws WorkError when the probe was streamed with less
    const Spectrum& spectrum(int bandLimit, const JobControl& job = {});
    /// Band limit known so far; -1: none.
    int knownBandLimit() const { return m_spectrum ? m_spectrum->bandLimit : -1; }

    /// The same for the probe without its bright texels. Not for a streamed probe.
    const Spectrum& calmSpectrum(int bandLimit, const JobControl& job = {});
    int knownCalmBandLimit() const { return m_calmSpectrum ? m_calmSpectrum->bandLimit : -1; }
    /// What calmSpectrum() leaves out; filled by its first call.
    const BrightTexels& brightTexels() const { return m_bright; }

    /// Where the texels of a layout lie on the sphere; kept for the next lobe in the same layout.
    std::span<const SpherePoint> points(const MapLayout& target, const JobControl& job = {});

private:
    int m_width = 0;
    int m_height = 0;
    double m_resamplingError = 0.0;
    std::shared_ptr<const EnvironmentMap> m_latlong{};
    std::shared_ptr<const Spectrum> m_spectrum{};
    std::shared_ptr<const EnvironmentMap> m_calm{};
    std::shared_ptr<const Spectrum> m_calmSpectrum{};
    BrightTexels m_bright{};
    MapLayout m_pointsLayout{};
    std::shared_ptr<const std::vector<SpherePoint>> m_points{};
};

struct PrefilterOptions {
    Lobe lobe{};
    MapLayout target{.kind = Parameterization::Cube, .size = 128};
    Method method = Method::Auto;
    double tolerance = 1e-5; ///< rel_rms, (0, 1]
    double yaw = 0.0;        ///< radians about +Y, see direction.h
    bool operator==(const PrefilterOptions&) const = default;
};

/// What was done, and how well.
struct PrefilterOutcome {
    EnvironmentMap map{};
    Method method = Method::Auto;  ///< the one that ran
    bool filtered = true;          ///< false: mirror or unresolved lobe, the map is a lookup of the probe
    int bandLimit = 0;             ///< spectral only
    double predictedError = 0.0;   ///< rel_rms against the reference sum
    std::string why{};             ///< why this method
    std::vector<Stage> stages{};
};

/// What prefilter() would do, decided without doing it.
struct PrefilterPlan {
    Method method = Method::Auto;
    bool filtered = true;
    int bandLimit = 0;           ///< spectral: from the lobe alone; a probe's own spectrum may lower it
    double predictedError = 0.0;
    double predictedSeconds = 0.0;
    std::string why{};
};

/// @param width  columns of the probe's latlong form
/// @param streamed  true: the texels are not in memory, so that only the spectral method can run
/// @param knownBandLimit  of a spectrum of the probe that is there already and costs nothing; -1: none
PrefilterPlan planPrefilter(const PrefilterOptions& options, int width, bool streamed = false, int knownBandLimit = -1);

/// The filtered map of a probe, in the chosen parameterization.
/// @throws InvalidArgument naming the field; Cancelled
PrefilterOutcome prefilter(FilterSource& source, const PrefilterOptions& options, const JobControl& job = {});

/// Roughness of level i of a ggx chain of n levels: i/(n-1), so that the base is a mirror and the last level is fully rough.
/// alpha is its square.
double chainRoughness(int level, int levels);

} // namespace mirrorball
