#include "lobe_fit.h"

#include "core/image/reproject.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace mirrorball {

namespace {

using Complex = std::complex<double>;

constexpr int smallLevel = 16; ///< texels a quarter turn up to which texels are compared one by one

/// Analyzed into degrees: they are orthogonal, so G is diagonal.
LobeProblem spectralProblem(const EnvironmentMap& level, const Spectrum& probe, int size, const JobControl& job)
{
    LobeProblem problem;
    problem.bandLimit = std::min({lobeBandLimit, probe.bandLimit, 3 * size / 4});
    const int height = 4 * problem.bandLimit;
    const bool asItIs = level.layout.kind == Parameterization::Latlong;
    const EnvironmentMap latlong = asItIs ? level : reproject(level, {.target = {Parameterization::Latlong, height, 0}}, job);
    const Spectrum map = analyze(latlong, problem.bandLimit, job);
    const auto degrees = static_cast<size_t>(problem.bandLimit) + 1;
    problem.gram.assign(degrees, 0.0);
    problem.cross.assign(degrees, 0.0);
    for (size_t c = 0; c < 3; ++c)
        for (int m = 0; m <= problem.bandLimit; ++m)
            for (int l = m; l <= problem.bandLimit; ++l) {
                const Complex a = probe.coefficients[c][probe.index(l, m)], b = map.coefficients[c][map.index(l, m)];
                const double weight = m == 0 ? 1.0 : 2.0;
                problem.gram[static_cast<size_t>(l)] += weight * std::norm(a);
                problem.cross[static_cast<size_t>(l)] += weight * std::real(a * std::conj(b));
                problem.power += weight * std::norm(b);
            }
    // Bilinear interpolation between texels of width t takes t^2/6 of variance, averaging over texels t^2/12, along each axis.
    const double texel = 0.5 * pi / size, ring = pi / height;
    const double variance = asItIs ? 0.0 : texel * texel / 6.0 + ring * ring / 12.0;
    for (int l = 0; l <= problem.bandLimit; ++l)
        problem.sampling.push_back(std::exp(-0.5 * l * (l + 1.0) * variance));
    return problem;
}

LobeProblem texelProblem(const EnvironmentMap& level, const Spectrum& probe)
{
    LobeProblem problem;
    problem.bandLimit = std::min(48, probe.bandLimit);
    const auto degrees = static_cast<size_t>(problem.bandLimit) + 1;
    problem.gram.assign(degrees * degrees, 0.0);
    problem.cross.assign(degrees, 0.0);
    problem.sampling.assign(degrees, 1.0);
    for (int y = 0; y < level.image.height; ++y)
        for (int x = 0; x < level.image.width; ++x) {
            const double weight = texelSolidAngle(level.layout, x, y);
            if (weight <= 0.0)
                continue;
            const std::vector<glm::dvec3> parts = degreeParts(probe, texelDirection(level.layout, x, y), problem.bandLimit);
            const float* t = level.image.texel(x, y);
            const glm::dvec3 value(t[0], t[1], t[2]);
            problem.power += weight * glm::dot(value, value);
            for (size_t l = 0; l < degrees; ++l) {
                const glm::dvec3 part = weight * parts[l];
                problem.cross[l] += glm::dot(part, value);
                for (size_t j = 0; j <= l; ++j)
                    problem.gram[l * degrees + j] += glm::dot(part, parts[j]);
            }
        }
    for (size_t l = 0; l < degrees; ++l)
        for (size_t j = l + 1; j < degrees; ++j)
            problem.gram[l * degrees + j] = problem.gram[j * degrees + l];
    return problem;
}

struct Fitted {
    double scale = 0.0, residual = 1.0;
};

/// The best scale of a lobe, and what is left.
Fitted fitted(const LobeProblem& problem, const std::vector<double>& k)
{
    const size_t degrees = problem.cross.size();
    const bool diagonal = problem.gram.size() == degrees;
    double kGk = 0.0, hk = 0.0;
    for (size_t l = 0; l < degrees; ++l) {
        const double kl = k[l] * problem.sampling[l];
        hk += problem.cross[l] * kl;
        if (diagonal) {
            kGk += problem.gram[l] * kl * kl;
            continue;
        }
        double sum = 0.0;
        for (size_t j = 0; j < degrees; ++j)
            sum += problem.gram[l * degrees + j] * k[j] * problem.sampling[j];
        kGk += sum * kl;
    }
    if (kGk <= 0.0 || problem.power <= 0.0)
        return {};
    const double scale = hk / kGk;
    return {scale, std::sqrt(std::max(0.0, problem.power - scale * hk) / problem.power)};
}

/// The least residual over log(parameter) in [low, high]: a grid, then golden sections about its best.
double bestParameter(double low, double high, const std::function<double(double)>& residual)
{
    constexpr int steps = 24;
    const double from = std::log(low), step = (std::log(high) - from) / steps;
    int best = 0;
    double least = HUGE_VAL;
    for (int i = 0; i <= steps; ++i)
        if (const double r = residual(std::exp(from + i * step)); r < least) {
            least = r;
            best = i;
        }
    double a = from + std::max(best - 1, 0) * step, b = from + std::min(best + 1, steps) * step;
    constexpr double golden = 0.6180339887498949;
    double c = b - golden * (b - a), d = a + golden * (b - a);
    double fc = residual(std::exp(c)), fd = residual(std::exp(d));
    for (int i = 0; i < 14; ++i)
        if (fc < fd) {
            b = std::exchange(d, c);
            fd = fc;
            c = b - golden * (b - a);
            fc = residual(std::exp(c));
        } else {
            a = std::exchange(c, d);
            fc = fd;
            d = a + golden * (b - a);
            fd = residual(std::exp(d));
        }
    const double found = std::exp(0.5 * (a + b));
    return residual(high) <= residual(found) ? high : found;
}

} // namespace

int quarterTexels(const MapLayout& layout) { return std::max(1, layout.size / mapping(layout.kind).leastQuarter); }

double unresolvedAlpha(int size) { return 0.3 * (0.5 * pi) / size; }

LobeProblem lobeProblem(const EnvironmentMap& level, const Spectrum& probe, const JobControl& job)
{
    const int size = quarterTexels(level.layout);
    return size > smallLevel ? spectralProblem(level, probe, size, job) : texelProblem(level, probe);
}

LobeFit fitLobe(const LobeProblem& problem, int size)
{
    const auto of = [&](const Lobe& lobe) { return fitted(problem, legendreCoefficients(lobe, problem.bandLimit)); };
    LobeFit fit;
    const double least = unresolvedAlpha(size) / 3.0;
    fit.alpha = least >= 1.0 ? 1.0 : bestParameter(least, 1.0, [&](double a) { return of(ggxLobe(std::min(a, 1.0))).residual; });
    fit.alpha = std::min(fit.alpha, 1.0);
    const Fitted ggx = of(ggxLobe(fit.alpha)), mirror = of(ggxLobe(0.0));
    fit.ggxResidual = ggx.residual;
    fit.unfiltered = mirror.residual <= ggx.residual * 1.02 || fit.alpha < unresolvedAlpha(size);
    fit.phongExponent = bestParameter(0.5, std::max(1.0, 2.0 / (least * least)), [&](double n) { return of(phongLobe(n)).residual; });
    const Fitted phong = of(phongLobe(fit.phongExponent));
    fit.phongResidual = phong.residual;
    if (fit.unfiltered && size > 2) {
        fit.alpha = 0.0;
        fit.scale = mirror.scale;
        fit.residual = fit.ggxResidual = mirror.residual;
        return fit;
    }
    fit.unfiltered = false;
    // Phong of exponent 1 is the diffuse lobe, which is ggx of alpha 1 too.
    const bool phongWins = phong.residual < 0.6 * ggx.residual && ggx.residual > 0.004 && fit.phongExponent > 1.05;
    fit.lobe = phongWins ? phongLobe(fit.phongExponent) : ggxLobe(fit.alpha);
    fit.scale = phongWins ? phong.scale : ggx.scale;
    fit.residual = phongWins ? phong.residual : ggx.residual;
    return fit;
}

std::vector<glm::dvec3> degreeParts(const Spectrum& probe, const glm::dvec3& d, int bandLimit)
{
    // Spherical harmonics with the phase of Condon and Shortley, normalized, by the recursion over l for each m. Azimuth runs along the
    // rows of a latlong: against the longitude, from -Z.
    std::vector<glm::dvec3> parts(static_cast<size_t>(bandLimit) + 1, glm::dvec3(0.0));
    const double x = d.y, sine = std::hypot(d.x, d.z), azimuth = pi - std::atan2(d.x, d.z);
    double diagonal = std::sqrt(1.0 / (4.0 * pi)); // P_mm
    for (int m = 0; m <= bandLimit; ++m) {
        if (m > 0)
            diagonal *= -std::sqrt((2.0 * m + 1.0) / (2.0 * m)) * sine;
        const Complex turn = std::polar(m == 0 ? 1.0 : 2.0, m * azimuth);
        double previous = 0.0, p = diagonal, before = 0.0;
        for (int l = m; l <= bandLimit; ++l) {
            const size_t i = probe.index(l, m);
            for (size_t c = 0; c < 3; ++c)
                parts[static_cast<size_t>(l)][static_cast<int>(c)] += p * std::real(probe.coefficients[c][i] * turn);
            const double next = std::sqrt((4.0 * (l + 1) * (l + 1) - 1.0) / ((l + 1.0) * (l + 1.0) - static_cast<double>(m) * m));
            const double following = next * (x * p - (before > 0.0 ? previous / before : 0.0));
            previous = std::exchange(p, following);
            before = next;
        }
    }
    return parts;
}

} // namespace mirrorball
