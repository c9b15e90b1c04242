#pragma once

#include "bright_texels.h"
#include "hierarchical.h"
#include "importance.h"
#include "mip_blur.h"
#include "paraboloid.h"
#include "ring_grid.h"
#include "spectrum.h"

#include "core/base/job.h"
#include "core/image/environment_map.h"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace mirrorball {

/// Height of the latlong form that a probe of this layout is resampled to: its smallest texels stay apart.
int latlongHeight(const MapLayout& layout);

/// A probe made ready for filtering. Holds its latlong form, and its spectrum once a method has asked for it: many lobes share both.
/// A probe too large to hold is streamed through a SpectrumBuilder instead and has a spectrum only. Cheap to copy; the spectrum is
/// kept for later calls, so one thread at a time may filter through one object.
class FilterSource {
public:
    /// A probe in memory. Another parameterization than latlong is resampled to one, finely enough to keep its texels apart.
    explicit FilterSource(EnvironmentMap probe, const JobControl& job = {});
    /// A probe that was streamed, as far as its spectrum goes.
    explicit FilterSource(Spectrum spectrum);
    /// The same with what is taken out of its brightest texels, however many those are, and the spectrum of the rest.
    FilterSource(Spectrum whole, Spectrum calm, BrightTexels taken);
    /// A probe that was streamed: its truncated rows, and its brightest texels, which can be taken out of them.
    FilterSource(std::shared_ptr<SpectrumBuilder> rows, BrightTexelFinder brightest);

    /// Size of the latlong form that the reference sum runs over.
    int width() const { return m_width; }
    int height() const { return m_height; }
    /// rel_rms of the latlong form, read at the texels of a probe that came in another parameterization; 0 when it came as latlong.
    double resamplingError() const { return m_resamplingError; }
    /// The darkest half per cent of the sphere is no darker than this, relative to the mean; of a streamed probe not known, 1e-6.
    double dark() const { return m_dark; }
    /// Null when the probe was streamed.
    const EnvironmentMap* latlong() const { return m_latlong.get(); }
    /// A spectrum known at least to `bandLimit`, computed when there is none yet. @throws WorkError when the probe was streamed with less
    const Spectrum& spectrum(int bandLimit, const JobControl& job = {});
    /// Band limit known so far; -1: none.
    int knownBandLimit() const { return m_spectrum ? m_spectrum->bandLimit : -1; }

    /// Whether bright texels can be taken out.
    bool canSplit() const { return m_latlong || m_rows || m_taken; }
    /// What is taken out by one of the brightSplits; none by the first. Found by the first call and kept.
    const BrightTexels& brightTexels(size_t split, const JobControl& job = {});
    /// The spectrum of the probe without those; for split 0 that of the whole probe. @throws as spectrum()
    const Spectrum& calmSpectrum(size_t split, int bandLimit, const JobControl& job = {});
    int knownCalmBandLimit(size_t split = 1) const;
    /// Sum over all of them: grows when one is made.
    int knownBandLimits() const;

    /// Those two as far as they are known; null: not at all.
    std::shared_ptr<const Spectrum> knownSpectrum() const { return m_spectrum; }
    std::shared_ptr<const Spectrum> knownCalmSpectrum() const { return m_calmSpectra[1]; }

    /// What importance, hierarchical and mip work on, made by the first call and kept. Not for a streamed probe.
    const LookupPyramid& lookupPyramid(const JobControl& job = {});
    const RadianceTree& radianceTree(const JobControl& job = {});
    const MipPyramid& blurPyramid(MipFiltering filtering, const JobControl& job = {});

    /// What the paraboloid method runs on; null: on the CPU.
    ParaboloidDevice* paraboloidDevice() const { return m_paraboloidDevice.get(); }
    void useParaboloidDevice(std::shared_ptr<ParaboloidDevice> device) { m_paraboloidDevice = std::move(device); }

    /// Where the texels of a layout lie on the sphere; kept for the next lobe in the same layout.
    std::span<const SpherePoint> points(const MapLayout& target, const JobControl& job = {});

private:
    int m_width = 0;
    int m_height = 0;
    double m_resamplingError = 0.0;
    double m_dark = 1e-6;
    std::shared_ptr<const EnvironmentMap> m_latlong{};
    std::shared_ptr<const Spectrum> m_spectrum{};
    std::shared_ptr<SpectrumBuilder> m_rows{}; ///< of a streamed probe
    std::shared_ptr<const BrightTexelFinder> m_brightest{};
    bool m_taken = false; ///< every split takes out the same, which was decided when the spectrum was made
    std::array<std::shared_ptr<const BrightTexels>, brightSplits.size()> m_bright{};
    std::array<std::shared_ptr<const Spectrum>, brightSplits.size()> m_calmSpectra{}; ///< [0] is not used: m_spectrum
    std::shared_ptr<const LookupPyramid> m_lookupPyramid{};
    std::shared_ptr<const RadianceTree> m_radianceTree{};
    std::array<std::shared_ptr<const MipPyramid>, 2> m_blurPyramids{}; ///< by MipFiltering
    std::shared_ptr<ParaboloidDevice> m_paraboloidDevice{};
    MapLayout m_pointsLayout{};
    std::shared_ptr<const std::vector<SpherePoint>> m_points{};
};

} // namespace mirrorball
