#include "filter_source.h"

#include "spectral.h"

#include "core/base/error.h"
#include "core/base/weighted_quantiles.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace mirrorball {

namespace {

/// Band limits are rounded up to steps when a spectrum is made, so that the next lobe, a little narrower, finds what it needs.
int roundedUp(int bandLimit)
{
    int step = 32;
    while (step < bandLimit)
        step = step * 3 / 2 <= bandLimit || step * 3 / 2 % 16 != 0 ? step * 2 : step * 3 / 2;
    return std::min(step, std::max(bandLimit, largestBandLimit));
}

/// rel_rms of `copy`, looked up at the texels of `original`; over a part of them, which is enough for a figure.
double differenceAtTexels(const EnvironmentMap& original, const EnvironmentMap& copy)
{
    const int step = std::max(1, original.image.height / 128);
    double difference = 0.0, power = 0.0;
    for (int y = 0; y < original.image.height; y += step)
        for (int x = 0; x < original.image.width; x += step) {
            const double solidAngle = texelSolidAngle(original.layout, x, y);
            if (solidAngle <= 0.0)
                continue;
            const float* t = original.image.texel(x, y);
            const glm::dvec3 value(t[0], t[1], t[2]);
            const glm::dvec3 error = glm::dvec3(copy.radiance(texelDirection(original.layout, x, y))) - value;
            difference += solidAngle * glm::dot(error, error);
            power += solidAngle * glm::dot(value, value);
        }
    return power > 0.0 ? std::sqrt(difference / power) : 0.0;
}

/// The value that half a per cent of the sphere's is below, over all channels, relative to their mean; over a part of the texels.
double darkShare(const EnvironmentMap& latlong)
{
    std::vector<WeightedValue> values;
    const int step = std::max(1, latlong.image.height / 64);
    double mean = 0.0, total = 0.0;
    for (int y = step / 2; y < latlong.image.height; y += step) {
        const double weight = texelSolidAngle(latlong.layout, 0, y);
        for (int x = step / 2; x < latlong.image.width; x += step)
            for (int c = 0; c < 3; ++c) {
                const double value = latlong.image.texel(x, y)[c];
                values.push_back({value, weight});
                mean += weight * value;
                total += weight;
            }
    }
    const auto [dark] = weightedQuantiles(std::move(values), std::array{0.005});
    return mean > 0.0 ? std::clamp(dark * total / mean, 0.0, 1.0) : 1.0;
}

} // namespace

int latlongHeight(const MapLayout& layout) { return mapping(layout.kind).latlongRows * layout.size; }

FilterSource::FilterSource(EnvironmentMap probe, const JobControl& job)
{
    if (probe.layout.kind != Parameterization::Latlong) {
        EnvironmentMap latlong =
            reproject(probe, {.target = {.kind = Parameterization::Latlong, .size = latlongHeight(probe.layout)}}, job);
        m_resamplingError = differenceAtTexels(probe, latlong);
        probe = std::move(latlong);
    }
    m_width = probe.image.width;
    m_height = probe.image.height;
    m_dark = darkShare(probe);
    m_latlong = std::make_shared<const EnvironmentMap>(std::move(probe));
}

FilterSource::FilterSource(Spectrum spectrum) : m_width(spectrum.ringLength), m_height(spectrum.rings)
{
    m_spectrum = std::make_shared<const Spectrum>(std::move(spectrum));
}

FilterSource::FilterSource(Spectrum whole, Spectrum calm, BrightTexels taken) : FilterSource(std::move(whole))
{
    m_taken = true;
    m_bright[0] = std::make_shared<const BrightTexels>();
    m_bright[1] = std::make_shared<const BrightTexels>(std::move(taken));
    m_calmSpectra[1] = std::make_shared<const Spectrum>(std::move(calm));
    for (size_t split = 2; split < brightSplits.size(); ++split) {
        m_bright[split] = m_bright[1];
        m_calmSpectra[split] = m_calmSpectra[1];
    }
}

FilterSource::FilterSource(std::shared_ptr<SpectrumBuilder> rows, BrightTexelFinder brightest)
    : m_width(rows->width()), m_height(rows->height()), m_rows(std::move(rows)),
      m_brightest(std::make_shared<const BrightTexelFinder>(std::move(brightest)))
{
    m_spectrum = std::make_shared<const Spectrum>(m_rows->finish());
}

const Spectrum& FilterSource::spectrum(int bandLimit, const JobControl& job)
{
    if (!m_spectrum || m_spectrum->bandLimit < bandLimit) {
        if (!m_latlong)
            throw WorkError("spectrum: the probe was read up to band limit " + std::to_string(m_spectrum->bandLimit) + ", but " +
                            std::to_string(bandLimit) + " is needed; load it whole");
        m_spectrum = std::make_shared<const Spectrum>(analyze(*m_latlong, roundedUp(bandLimit), job));
    }
    return *m_spectrum;
}

const BrightTexels& FilterSource::brightTexels(size_t split, const JobControl& job)
{
    auto& bright = m_bright[split];
    if (bright)
        return *bright;
    if (split > 0 && (!m_brightest || m_brightest->deepest() < split)) {
        job.checkStop();
        BrightTexelFinder finder(m_latlong->layout, split == 1 ? 1 : brightSplits.size() - 1);
        finder.addRows(0, m_height, m_latlong->image.texels.data());
        m_brightest = std::make_shared<const BrightTexelFinder>(std::move(finder));
    }
    bright = std::make_shared<const BrightTexels>(split > 0 ? m_brightest->take(split) : BrightTexels{});
    return *bright;
}

int FilterSource::knownCalmBandLimit(size_t split) const
{
    if (split == 0)
        return knownBandLimit();
    return m_calmSpectra[split] ? m_calmSpectra[split]->bandLimit : -1;
}

int FilterSource::knownBandLimits() const
{
    int sum = 0;
    for (size_t split = 0; split < brightSplits.size(); ++split)
        sum += knownCalmBandLimit(split);
    return sum;
}

const Spectrum& FilterSource::calmSpectrum(size_t split, int bandLimit, const JobControl& job)
{
    if (split == 0)
        return spectrum(bandLimit, job);
    auto& known = m_calmSpectra[split];
    if (known && known->bandLimit >= bandLimit)
        return *known;
    if (!m_latlong)
        spectrum(bandLimit, job); // says when the rows do not hold that much
    const BrightTexels& bright = brightTexels(split, job);
    std::shared_ptr<SpectrumBuilder> rows = m_rows;
    if (!rows) {
        rows = std::make_shared<SpectrumBuilder>(m_width, m_height, roundedUp(bandLimit));
        rows->addRows(0, m_height, m_latlong->image.texels.data(), job);
    }
    for (const BrightTexels::Change& change : bright.changes)
        rows->replace(change.x, change.y, change.before, change.calm);
    known = std::make_shared<const Spectrum>(rows->finish(job));
    if (m_rows) // kept for the next split
        for (const BrightTexels::Change& change : bright.changes)
            rows->replace(change.x, change.y, change.calm, change.before);
    return *known;
}

const LookupPyramid& FilterSource::lookupPyramid(const JobControl& job)
{
    if (!m_lookupPyramid)
        m_lookupPyramid = std::make_shared<const LookupPyramid>(*m_latlong, job);
    return *m_lookupPyramid;
}

const RadianceTree& FilterSource::radianceTree(const JobControl& job)
{
    if (!m_radianceTree)
        m_radianceTree = std::make_shared<const RadianceTree>(*m_latlong, job);
    return *m_radianceTree;
}

const MipPyramid& FilterSource::blurPyramid(MipFiltering filtering, const JobControl& job)
{
    auto& pyramid = m_blurPyramids[static_cast<size_t>(filtering)];
    if (!pyramid)
        pyramid = std::make_shared<const MipPyramid>(
            mirrorball::blurPyramid(reproject(*m_latlong, {.target = environmentCube(m_width)}, job), filtering, job));
    return *pyramid;
}

std::span<const SpherePoint> FilterSource::points(const MapLayout& target, const JobControl& job)
{
    if (!m_points || m_pointsLayout != target) {
        m_points = std::make_shared<const std::vector<SpherePoint>>(spherePoints(target, job));
        m_pointsLayout = target;
    }
    return *m_points;
}

} // namespace mirrorball
