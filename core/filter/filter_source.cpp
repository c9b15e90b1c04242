#include "filter_source.h"

#include "spectral.h"

#include "core/base/error.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <cmath>
#include <string>

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

} // namespace

int latlongHeight(const MapLayout& layout)
{
    switch (layout.kind) {
    case Parameterization::Latlong:
        return layout.size;
    case Parameterization::Cube:
        return 3 * layout.size;
    case Parameterization::Sphere:
        return 2 * layout.size;
    case Parameterization::Angular:
        return layout.size;
    case Parameterization::Paraboloid:
        return 2 * layout.size;
    case Parameterization::Octahedral:
        return 2 * layout.size;
    }
    return layout.size;
}

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
    m_latlong = std::make_shared<const EnvironmentMap>(std::move(probe));
}

FilterSource::FilterSource(Spectrum spectrum) : m_width(spectrum.ringLength), m_height(spectrum.rings)
{
    m_spectrum = std::make_shared<const Spectrum>(std::move(spectrum));
}

const Spectrum& FilterSource::spectrum(int bandLimit, const JobControl& job)
{
    if (!m_spectrum || m_spectrum->bandLimit < bandLimit) {
        if (!m_latlong)
            throw WorkError("spectrum: the probe was read up to band limit " + std::to_string(m_spectrum->bandLimit) + ", but " +
                            std::to_string(bandLimit) + " is needed; load it whole");
        m_spectrum = std::make_shared<const Spectrum>(analyse(*m_latlong, roundedUp(bandLimit), job));
    }
    return *m_spectrum;
}

const Spectrum& FilterSource::calmSpectrum(int bandLimit, const JobControl& job)
{
    if (!m_calm) {
        auto calm = std::make_shared<EnvironmentMap>(*m_latlong);
        m_bright = takeBrightTexels(*calm);
        m_calm = std::move(calm);
    }
    if (!m_calmSpectrum || m_calmSpectrum->bandLimit < bandLimit)
        m_calmSpectrum = std::make_shared<const Spectrum>(analyse(*m_calm, roundedUp(bandLimit), job));
    return *m_calmSpectrum;
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
