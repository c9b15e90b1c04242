#pragma once

#include "core/filter/lobe.h"
#include "core/image/image.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <thread>
#include <vector>

/// A filtered map by the definition alone, for judging the library from outside: nothing of its filters, its lobes' values or its geometry
/// is used, only the formulas as the design states them. In double, one texel after the other.
namespace mirrorball::test {

/// k(c)/k(1) of a lobe, c the cosine of the angle from its axis.
inline double plainKernel(const Lobe& lobe, double c)
{
    if (c <= 0.0)
        return 0.0;
    c = std::min(c, 1.0);
    switch (lobe.kind) {
    case LobeKind::Phong:
        return std::exp(lobe.exponent * std::log(c));
    case LobeKind::Diffuse:
        return c;
    case LobeKind::Ggx: { // D(t/2) cos t: cos^2(t/2) = (1 + c)/2; D ~ 1/(cos^2 (alpha^2 - 1) + 1)^2
        const double a2 = lobe.alpha * lobe.alpha, h2 = 0.5 * (1.0 + c);
        const double d = (1.0 - h2) + a2 * h2;
        return c * (a2 / d) * (a2 / d);
    }
    case LobeKind::Tabulated: {
        const double p = c * static_cast<double>(lobe.samples.size() - 1);
        const size_t i = std::min(static_cast<size_t>(p), lobe.samples.size() - 2);
        const double f = p - static_cast<double>(i);
        return (1.0 - f) * lobe.samples[i] + f * lobe.samples[i + 1];
    }
    }
    return 0.0;
}

/// Angle across the lobe at half its peak.
inline double plainWidth(const Lobe& lobe)
{
    double low = 0.0, high = std::acos(0.0);
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (low + high);
        (plainKernel(lobe, std::cos(t)) > 0.5 * plainKernel(lobe, 1.0) ? low : high) = t;
    }
    return 2.0 * high;
}

/// A lobe narrower than 1.5 texels has the bilinear lookup for its truth.
inline bool plainlyUnresolved(const Lobe& lobe, int width) { return plainWidth(lobe) < 1.5 * 4.0 * std::acos(0.0) / width; }

/// Where the brightest places and the darkest lie does not matter: every texel is summed, but for those that weigh less than e^-60 of the
/// nearest one, which is 1e-26.
/// @param latlong  3 floats a texel, center-sampled: row 0 on top, lon = pi - 2 pi u, lat = pi/2 - pi v, d = (sin lon cos lat, sin lat,
///                 cos lon cos lat)
inline std::vector<glm::dvec3> plainSum(const Image& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions)
{
    const int width = latlong.width, height = latlong.height;
    const double pi = 2.0 * std::acos(0.0);
    std::vector<double> sinLon, cosLon;
    for (int x = 0; x < width; ++x) {
        const double lon = pi - 2.0 * pi * (x + 0.5) / width;
        sinLon.push_back(std::sin(lon));
        cosLon.push_back(std::cos(lon));
    }
    const double n = lobe.kind == LobeKind::Phong ? lobe.exponent : 0.0;
    const auto one = [&](const glm::dvec3& r) {
        const double across = std::sqrt(r.x * r.x + r.z * r.z);
        double nearest = 0.0; // upper bound of c over the texels, but for the offset within a texel
        for (int y = 0; y < height; ++y) {
            const double lat = 0.5 * pi - pi * (y + 0.5) / height;
            for (int x = 0; n > 100.0 && x < width; ++x)
                nearest = std::max(nearest, r.y * std::sin(lat) + std::cos(lat) * (r.x * sinLon[static_cast<size_t>(x)] +
                                                                                   r.z * cosLon[static_cast<size_t>(x)]));
        }
        glm::dvec3 sum(0.0);
        double norm = 0.0;
        for (int y = 0; y < height; ++y) {
            const double lat = 0.5 * pi - pi * (y + 0.5) / height;
            const double a = r.y * std::sin(lat), b = std::cos(lat);
            // ln c <= c - 1
            if (a + b * across <= 0.0 || (n > 100.0 && n * (a + b * across - 1.0) < n * std::log(std::max(nearest, 1e-300)) - 60.0))
                continue;
            const float* t = latlong.row(y);
            for (int x = 0; x < width; ++x, t += 3) {
                const double c = a + b * (r.x * sinLon[static_cast<size_t>(x)] + r.z * cosLon[static_cast<size_t>(x)]);
                if (c <= 0.0 || (n > 100.0 && n * (c - 1.0) < n * std::log(nearest) - 60.0))
                    continue;
                // Relative to the nearest texel, so that no exponent underflows all of them.
                const double k = n > 100.0 ? std::exp(n * (std::log(std::min(c, 1.0)) - std::log(nearest))) : plainKernel(lobe, c);
                const double w = k * b; // the texel's solid angle is cos(lat) up to a factor that cancels
                sum += w * glm::dvec3(t[0], t[1], t[2]);
                norm += w;
            }
        }
        return sum / norm;
    };
    std::vector<glm::dvec3> result(directions.size());
    const auto share = [&](size_t part, size_t parts) {
        for (size_t i = part; i < directions.size(); i += parts)
            result[i] = one(directions[i]);
    };
    std::thread other(share, 1, 2);
    share(0, 2);
    other.join();
    return result;
}

/// The bilinear lookup between texel centers; above the first row's centers and below the last's it goes on across the pole.
inline std::vector<glm::dvec3> plainLookups(const Image& latlong, std::span<const glm::dvec3> directions)
{
    const double pi = 2.0 * std::acos(0.0);
    const int width = latlong.width, height = latlong.height;
    const auto at = [&](int x, int y) {
        if (y < 0 || y >= height) {
            y = y < 0 ? -1 - y : 2 * height - 1 - y;
            x += width / 2;
        }
        const float* t = latlong.texel((x % width + width) % width, y);
        return glm::dvec3(t[0], t[1], t[2]);
    };
    std::vector<glm::dvec3> result;
    for (const glm::dvec3& d : directions) {
        const double u = (pi - std::atan2(d.x, d.z)) / (2.0 * pi) * width - 0.5;
        const double v = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / pi * height - 0.5;
        const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
        const double fx = u - x, fy = v - y;
        result.push_back((1 - fy) * ((1 - fx) * at(x, y) + fx * at(x + 1, y)) + fy * ((1 - fx) * at(x, y + 1) + fx * at(x + 1, y + 1)));
    }
    return result;
}

/// The four figures that a tolerance promises, over all channels and directions that stand for equal solid angles.
struct PlainError {
    double relRms = 0.0, medianRel = 0.0, p99Rel = 0.0;
    double least = 0.0; ///< the smallest value over the mean

    /// Of a probe without negative texels.
    bool keeps(double t) const
    {
        return relRms <= t && medianRel <= t && p99Rel <= std::max(5.0 * t, 1e-3) && least >= -std::max(1e-3 * t, 1e-7);
    }
};

inline PlainError plainError(std::span<const glm::dvec3> values, std::span<const glm::dvec3> truth)
{
    double power = 0.0, difference = 0.0, mean = 0.0, least = HUGE_VAL;
    for (size_t i = 0; i < truth.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            power += truth[i][c] * truth[i][c];
            difference += (values[i][c] - truth[i][c]) * (values[i][c] - truth[i][c]);
            mean += truth[i][c] / (3.0 * static_cast<double>(truth.size()));
            least = std::min(least, values[i][c]);
        }
    std::vector<double> relative;
    for (size_t i = 0; i < truth.size(); ++i)
        for (int c = 0; c < 3; ++c)
            relative.push_back(std::abs(values[i][c] - truth[i][c]) / std::max(truth[i][c], 1e-6 * mean));
    std::sort(relative.begin(), relative.end());
    if (power <= 0.0) // black
        return {difference > 0.0 ? HUGE_VAL : 0.0, relative.back() > 0.0 ? HUGE_VAL : 0.0, relative.back() > 0.0 ? HUGE_VAL : 0.0, least};
    return {std::sqrt(difference / power), relative[relative.size() / 2], relative[relative.size() * 99 / 100], least / mean};
}

} // namespace mirrorball::test
