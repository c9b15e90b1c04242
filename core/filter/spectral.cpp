#include "spectral.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace mirrorball {

namespace {

/// Share of the tolerance spent on truncation; the rest is left to interpolation.
constexpr double truncationShare = 0.4;
constexpr double interpolationShare = 0.4;

/// What the terms beyond `last` add up to at most. The slowest spectrum, that of a lobe with a step at the horizon, has terms
/// (2l+1) k_l^2 ~ l^-2, whose sum beyond `last` equals that of the octave before it; a kink has l^-4 and a seventh of it.
double beyond(const std::function<double(int)>& term, int last)
{
    double octave = 0.0;
    for (int l = last / 2 + 1; l <= last; ++l)
        octave += term(l);
    return octave / 3.0;
}

/// Smallest band limit whose tail, the square root of the sum of term(l) over l > B, is within `limit`.
int limitForTail(const std::function<double(int)>& term, int last, double limit)
{
    double tail = beyond(term, last);
    if (tail > limit * limit)
        return last;
    for (int l = last; l > 0; --l) {
        tail += term(l);
        if (tail > limit * limit)
            return l;
    }
    return 0;
}

/// The error a degree can cost at most in a non-negative probe of mean 1.
std::function<double(int)> whiteTerm(const std::vector<double>& k)
{
    return [&k](int l) { return (2.0 * l + 1.0) * k[static_cast<size_t>(l)] * k[static_cast<size_t>(l)]; };
}

double tailFrom(const std::function<double(int)>& term, int first, int last)
{
    double tail = beyond(term, last);
    for (int l = last; l >= first; --l)
        tail += term(l);
    return std::sqrt(tail);
}

/// Follows a spectrum until its tail is small pointwise, where it decays fast enough to get there within twice what the root mean
/// square asks for: beside a sun the dark, taken as 1e-5 of the mean, shows an error that the root mean square hides. A lobe with a
/// kink at the horizon would gain little.
int extendForTheDark(const std::vector<double>& k, int bandLimit, double tolerance)
{
    const int last = std::min({static_cast<int>(k.size()) - 1, 2 * bandLimit + 4, largestBandLimit});
    double tail = 0.0;
    for (int l = last; l > bandLimit; --l) {
        tail += (2.0 * l + 1.0) * std::abs(k[static_cast<size_t>(l)]);
        if (tail > 1e-3 * tolerance)
            return l == last ? bandLimit : l;
    }
    return bandLimit;
}

BandLimitPlan finishPlan(const std::vector<double>& k, int bandLimit, double tolerance, const std::function<double(int)>& term,
                         double scale)
{
    const int last = static_cast<int>(k.size()) - 1;
    bandLimit = extendForTheDark(k, bandLimit, tolerance);
    const double error = tailFrom(term, bandLimit + 1, last) / scale;
    std::vector<double> share;
    for (int l = 0; l <= bandLimit; ++l)
        share.push_back(term(l) / (scale * scale));
    return {bandLimit, std::vector<double>(k.begin(), k.begin() + bandLimit + 1), std::move(share), error};
}

} // namespace

BandLimitPlan planBandLimit(const std::vector<double>& k, double tolerance)
{
    const auto term = whiteTerm(k);
    const int bandLimit = limitForTail(term, static_cast<int>(k.size()) - 1, truncationShare * tolerance);
    return finishPlan(k, std::min(bandLimit, largestBandLimit), tolerance, term, 1.0);
}

BandLimitPlan planBandLimit(const std::vector<double>& k, double tolerance, const Spectrum& spectrum, int least)
{
    return planBandLimit(k, tolerance, spectrum.powerAboutMean(), least);
}

double spectralError(const BandLimitPlan& plan, const MapLayout& target, double tolerance, const std::vector<double>& power)
{
    constexpr double floatRounding = 1e-7; // that of the ring grid's samples and of the map
    std::vector<double> share = plan.share;
    double truncation = plan.predictedError;
    if (!power.empty() && power.size() >= plan.k.size()) {
        double total = 0.0;
        for (size_t l = 0; l < share.size(); ++l)
            total += share[l] = power[l] * plan.k[l] * plan.k[l];
        if (total > 0.0)
            for (double& s : share)
                s /= total;
        // What lies beyond goes on as the last octave does, at the power that non-negative probes have at most in each.
        double last = 0.0, white = 0.0;
        for (size_t l = (share.size() + 1) / 2; l < share.size(); ++l) {
            last += share[l];
            white += plan.share[l];
        }
        if (white > 0.0)
            truncation *= std::sqrt(last / white);
    }
    double interpolation = 0.0;
    if (target.kind != Parameterization::Latlong)
        interpolation = RingGrid::interpolationError(share, RingGrid::ringsFor(plan.share, interpolationShare * tolerance));
    return std::sqrt(truncation * truncation + interpolation * interpolation + floatRounding * floatRounding);
}

BandLimitPlan planBandLimit(const std::vector<double>& k, double tolerance, const std::vector<double>& power, int least)
{
    const int length = static_cast<int>(k.size()) - 1, known = std::min(static_cast<int>(power.size()) - 1, length);
    double strongest = 0.0; // power per coefficient among the last degrees known
    for (int l = known * 7 / 10; l <= known; ++l)
        strongest = std::max(strongest, power[static_cast<size_t>(l)] / (2.0 * l + 1.0));
    const auto term = [&](int l) {
        const auto i = static_cast<size_t>(l);
        return k[i] * k[i] * (l <= known ? power[i] : (2.0 * l + 1.0) * strongest);
    };
    double total = 0.0;
    for (int l = 0; l <= known; ++l)
        total += term(l);
    const double scale = std::sqrt(total);
    if (scale <= 0.0) // a black probe
        return {0, {1.0}, {1.0}, 0.0};
    const int bandLimit =
        std::min({std::max(least, limitForTail(term, length, truncationShare * tolerance * scale)), length, largestBandLimit});
    return finishPlan(k, bandLimit, tolerance, term, scale);
}

EnvironmentMap filterSpectral(const Spectrum& spectrum, const std::vector<double>& k, int rings, const BrightLobe& bright,
                              const MapLayout& target, std::span<const SpherePoint> points, double yaw, const JobControl& job,
                              const std::vector<double>& longer)
{
    assert(static_cast<int>(k.size()) <= spectrum.bandLimit + 1);
    EnvironmentMap map(target);
    const int width = map.image.width, height = map.image.height;
    const auto w = static_cast<size_t>(width);

    const auto brightAt = [&](int x, int y) {
        return bright.empty() ? glm::dvec3(0.0) : bright.radiance(yawed(texelDirection(target, x, y), -yaw));
    };
    if (target.kind == Parameterization::Latlong) {
        std::vector<double> theta;
        for (int y = 0; y < height; ++y)
            theta.push_back(pi * (y + 0.5) / height);
        std::vector<std::complex<double>> turn;
        for (size_t m = 0; m < k.size(); ++m)
            turn.push_back(std::polar(1.0, static_cast<double>(m) * yaw)); // azimuth runs against longitude, see RingGrid
        const FilteredRings rows = synthesize(spectrum, k, theta, width, pi / width, turn, job, longer);
        parallelRows(height, job, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < width; ++x) {
                    const glm::vec3 value(rows.radiance(static_cast<size_t>(y) * w + static_cast<size_t>(x), brightAt(x, y)));
                    std::copy_n(&value.x, 3, map.image.texel(x, y));
                }
        });
        return map;
    }

    assert(points.size() == w * static_cast<size_t>(height));
    const RingGrid grid(spectrum, k, rings, yaw, job, longer);
    const auto finishRow = [&](int y, const float* from) {
        float* to = map.image.row(y);
        for (int x = 0; x < width; ++x, from += 4, to += 3) {
            glm::dvec3 sum(from[0], from[1], from[2]);
            if (!bright.empty())
                sum += brightAt(x, y);
            const double inverse = 1.0 / (1.0 + static_cast<double>(from[3]));
            for (int c = 0; c < 3; ++c)
                to[c] = static_cast<float>(sum[c] * inverse);
        }
    };
    const auto readRows = [&](int first, int last) {
        std::vector<float> rgbn(4 * w); // of one row, which stays in the cache
        for (int y = first; y < last; ++y) {
            grid.read(points.subspan(static_cast<size_t>(y) * w, w), rgbn.data());
            finishRow(y, rgbn.data());
        }
    };
    if (target.kind != Parameterization::Cube) {
        parallelRows(height, job, readRows);
        return map;
    }
    // Rows of all four sides at a time, then those of the faces +Y and -Y, which follow +X and -X.
    const int edge = target.size;
    const auto readSides = [&](int first, int last) {
        std::vector<float> rgbn(4 * 4 * static_cast<size_t>(last - first) * w);
        grid.readSides(edge, first, last, points, rgbn.data());
        const float* from = rgbn.data();
        for (const int face : {0, 1, 4, 5})
            for (int row = first; row < last; ++row, from += 4 * w)
                finishRow(face * edge + row, from);
    };
    parallelRows(
        3 * edge, job,
        [&](int first, int last) {
            if (first < edge)
                readSides(first, std::min(last, edge));
            if (last > edge)
                readRows(2 * edge + std::max(first - edge, 0), 2 * edge + last - edge);
        },
        std::clamp(edge / 8, 8, 64)); // so many that the meridians pay, so few that they stay in the cache
    return map;
}

} // namespace mirrorball
