#include "brdf_lookups.h"

#include "brdf_stack.h"
#include "spectral.h"
#include "spin_transform.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirrorball {

namespace {

// Where a lookup's axis lies about r: the angle between them and its azimuth from the plane of incidence, 0 towards the normal.
struct AboutR {
    double angle, azimuth;
};
AboutR aboutR(const BrdfLookup& lookup)
{
    const double out = std::sin(lookup.turn), along = std::sin(lookup.offset) * std::cos(lookup.turn);
    return {std::atan2(std::hypot(along, out), std::cos(lookup.offset) * std::cos(lookup.turn)), std::atan2(out, along)};
}

// Where the axis lies on the sphere, from r's place: a turn by `angle` in the direction whose azimuth about r is psi. All places of one
// colatitude move alike.
struct Moved {
    double colatitude, azimuth; ///< the azimuth is what is added
};
Moved moved(double colatitude, double angle, double psi)
{
    const double c = std::cos(colatitude), s = std::sin(colatitude), co = std::cos(angle), so = std::sin(angle);
    const double up = c * co + s * so * std::cos(psi), out = s * co - c * so * std::cos(psi), east = so * std::sin(psi);
    return {std::atan2(std::hypot(out, east), up), std::atan2(east, out)};
}

/// The bright texels as the lookup of every texel of the map finds them; empty where there are none.
std::vector<glm::dvec3> brightAlong(const BrightLobe& bright, const MapLayout& target, double yaw, const AboutR& axis, double azimuth,
                                    const JobControl& job)
{
    if (bright.empty())
        return {};
    const auto width = static_cast<size_t>(target.width());
    std::vector<glm::dvec3> result(width * static_cast<size_t>(target.height()));
    parallelRows(target.height(), job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (size_t x = 0; x < width; ++x)
                result[static_cast<size_t>(y) * width + x] = bright.radiance(
                    normalAt(yawed(texelDirection(target, static_cast<int>(x), y), -yaw), {axis.angle, azimuth + axis.azimuth}));
    });
    return result;
}

} // namespace

EnvironmentMap filterBrdfLookups(FilterSource& source, const LookupFit& fit, double azimuth, const MapLayout& target, double yaw,
                                 double tolerance, const JobControl& job)
{
    EnvironmentMap map(target);
    const RingSet own = ringsOf(target, yaw);
    const size_t texels = map.image.texels.size() / 3;
    std::vector<double> sums(3 * texels);
    for (const BrdfLookup& lookup : fit.lookups) {
        const AboutR axis = aboutR(lookup);
        const Lobe lobe = ggxLobe(std::clamp(lookup.alpha, 1e-3, 1.0));
        // As far as the lobe's spectrum asks for in this probe; a longer list of coefficients where its end was met.
        BandLimitPlan plan;
        for (int length = 64;; length = std::min(2 * length, largestBandLimit)) {
            plan = planBandLimit(legendreCoefficients(lobe, length), tolerance, stackSpectrum(source, std::min(length, 512), job));
            if (2 * plan.bandLimit <= length || length == largestBandLimit)
                break;
        }
        const Spectrum& spectrum = stackSpectrum(source, plan.bandLimit, job);
        const BrightLobe bright(source.latlong() ? source.brightTexels(1, job) : BrightTexels{}, lobe);
        const std::vector<glm::dvec3> suns = brightAlong(bright, target, yaw, axis, azimuth, job);
        RingSet rings = own;
        for (size_t i = 0; i < rings.colatitude.size(); ++i) {
            const Moved to = moved(own.colatitude[i], axis.angle, azimuth + axis.azimuth);
            rings.colatitude[i] = to.colatitude;
            rings.azimuth[i] += to.azimuth;
        }
        const std::vector<double> norm = synthesizeOrder(spectrum, 3, 0, plan.k, rings, job).real;
        for (int c = 0; c < 3; ++c) {
            const std::vector<double> light = synthesizeOrder(spectrum, c, 0, plan.k, rings, job).real;
            const size_t perNorm = norm.size() == light.size() ? 1 : static_cast<size_t>(rings.length);
            for (size_t i = 0; i < texels; ++i)
                sums[3 * i + static_cast<size_t>(c)] +=
                    lookup.weight[c] * std::max((light[i] + (suns.empty() ? 0.0 : suns[i][c])) / norm[i / perNorm], 0.0);
        }
    }
    for (size_t i = 0; i < sums.size(); ++i)
        map.image.texels[i] = static_cast<float>(sums[i]);
    return map;
}

} // namespace mirrorball
