#include "truncation.h"

#include "ring_grid.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

TruncationModel::TruncationModel(const Spectrum& spectrum, const std::vector<double>& k)
    : m_variance(spectrum.varianceAboutMean()), m_rowLength(spectrum.ringLength)
{
    const std::vector<glm::dvec3> power = spectrum.channelPowerAboutMean();
    const int length = static_cast<int>(k.size()) - 1, known = std::min(spectrum.bandLimit, length);
    const double largest = std::max({m_variance.r, m_variance.g, m_variance.b});
    if (largest > 0.0)
        m_shape = glm::dvec3(std::sqrt(m_variance.r / largest), std::sqrt(m_variance.g / largest), std::sqrt(m_variance.b / largest));
    m_shape = glm::max(m_shape, glm::dvec3(1e-3)); // a channel without light of its own still has rounding

    m_largest.resize(k.size());
    for (int l = length; l >= 0; --l) { // every other coefficient of a kinked lobe is 0: its neighbor stands for it, at the end above all
        const auto i = static_cast<size_t>(l);
        m_largest[i] = std::max({std::abs(k[i]), l > 0 ? std::abs(k[i - 1]) : 0.0, l < length ? m_largest[i + 1] : 0.0});
    }

    glm::dvec3 strongest(0.0), rest = m_variance; // per coefficient among the last degrees known; what is left for those beyond
    for (int l = 1; l <= known; ++l)
        rest -= power[static_cast<size_t>(l)];
    rest = glm::max(rest, glm::dvec3(0.0));
    for (int l = std::max(1, known * 7 / 10); l <= known; ++l)
        strongest = glm::max(strongest, power[static_cast<size_t>(l)] / (2.0 * l + 1.0));
    m_power.resize(k.size());
    for (int l = 1; l <= length; ++l) {
        const auto i = static_cast<size_t>(l);
        m_power[i] = k[i] * k[i] / (4.0 * pi) * (l <= known ? power[i] : (2.0 * l + 1.0) * strongest);
    }
    m_power[0] = power[0] / (4.0 * pi);

    // What lies beyond the list goes on as its last octave does; see spectral.cpp.
    glm::dvec3 octave(0.0);
    for (int l = length / 2 + 1; l <= length; ++l)
        octave += m_power[static_cast<size_t>(l)];
    glm::dvec3 tail = octave / 3.0;
    m_tail.resize(k.size());
    for (int l = length; l >= 0; --l) {
        const double next = m_largest[static_cast<size_t>(std::min(l + 1, length))];
        if (l >= known) // not more than the texels have
            m_tail[static_cast<size_t>(l)] = glm::min(tail, next * next / (4.0 * pi) * rest);
        else
            m_tail[static_cast<size_t>(l)] = m_tail[static_cast<size_t>(l) + 1] + m_power[static_cast<size_t>(l) + 1];
        tail += m_power[static_cast<size_t>(l)];
    }
}

double TruncationModel::repetitions(int bandLimit) const
{
    const int first = static_cast<int>(bandLimit / (1.2 * m_rowLength)) + 1; // the spectrum holds those before
    double sum = 0.0, term = 0.0;
    int z = first;
    for (; z < first + 16; ++z) {
        const int l = std::max(bandLimit + 1, static_cast<int>(0.8 * z * m_rowLength));
        const double k = m_largest[static_cast<size_t>(std::min(l, longest()))];
        term = 8.0 * z * k * k;
        sum += term;
        if (term < 1e-3 * sum)
            return sum;
    }
    return sum + z * term; // those of a step fall like z^-2, of a kink faster
}

double TruncationModel::normError(int bandLimit) const
{
    constexpr double reserve = 1.5;                                       // for where the rows meet the horizon
    const double zonal = m_largest.back() > 1e-12 ? negligibleNorm : 0.0; // a spectrum that ends is followed to its end
    return reserve * std::sqrt(repetitions(bandLimit)) + zonal;
}

int TruncationModel::bandLimitForNorm(double relative) const
{
    for (int z = 0;; ++z) {
        const int l = z == 0 ? 0 : static_cast<int>(1.2 * z * m_rowLength) + 1;
        if (l >= longest() || normError(l) <= relative)
            return std::min(l, longest());
    }
}

glm::dvec3 TruncationModel::truncation(int bandLimit) const
{
    const glm::dvec3 square =
        m_tail[static_cast<size_t>(std::min(bandLimit, longest()))] + repetitions(bandLimit) / (4.0 * pi) * m_variance;
    return {std::sqrt(square.r), std::sqrt(square.g), std::sqrt(square.b)};
}

glm::dvec3 TruncationModel::interpolation(int bandLimit, int rings) const
{
    glm::dvec3 square(0.0);
    for (int l = 1; l <= std::min(bandLimit, longest()); ++l)
        square += RingGrid::leakage(l, rings) * m_power[static_cast<size_t>(l)];
    return {std::sqrt(square.r), std::sqrt(square.g), std::sqrt(square.b)};
}

namespace {

bool within(const glm::dvec3& rms, double s, const glm::dvec3& shape)
{
    return rms.r <= s * shape.r && rms.g <= s * shape.g && rms.b <= s * shape.b;
}

} // namespace

int TruncationModel::bandLimitFor(double s, const glm::dvec3& shape) const
{
    if (!within(truncation(longest()), s, shape))
        return -1;
    int low = -1, high = longest(); // truncation falls with the band limit
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (within(truncation(middle), s, shape) ? high : low) = middle;
    }
    return high;
}

int TruncationModel::ringsFor(int bandLimit, double s, const glm::dvec3& shape) const
{
    int rings = RingGrid::leastRings(bandLimit);
    while (!within(interpolation(bandLimit, rings), s, shape))
        rings = RingGrid::leastRings(rings + rings / 16);
    return rings;
}

} // namespace mirrorball
