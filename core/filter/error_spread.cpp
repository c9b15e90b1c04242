#include "error_spread.h"

#include "core/base/weighted_quantiles.h"
#include "core/image/reproject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace mirrorball {

namespace {

/// The lobe and what a method's kernel differs from it by, over the angle from the axis.
class Kernels {
public:
    Kernels(const Lobe& lobe, const TransferModel& model)
        : m_lobe(entries + 2), m_bias(model.blurs.empty() ? fromDegrees(model.bias) : fromBlurs(model.blurs))
    {
        const LobeShape shape(lobe);
        double lobePeak = 0.0, biasPeak = 0.0;
        for (size_t i = 0; i < m_lobe.size(); ++i) {
            m_lobe[i] = shape.relative(std::cos(angle(i))) / shape.integral();
            if (!model.blurs.empty())
                m_bias[i] -= m_lobe[i];
            lobePeak = std::max(lobePeak, m_lobe[i]);
            biasPeak = std::max(biasPeak, std::abs(m_bias[i]));
        }
        m_felt = feltOf(model);
        constexpr double negligible = 1e-6;
        size_t last = m_lobe.size() - 1;
        while (last > 1 && m_lobe[last] <= negligible * lobePeak && std::abs(m_bias[last]) <= negligible * biasPeak)
            --last;
        m_leastCosine = std::cos(angle(last));
    }

    struct Weights {
        double lobe, bias, felt;
    };
    bool reaches(double cosine) const { return cosine >= m_leastCosine; }
    Weights at(double cosine) const
    {
        const double place = std::acos(std::clamp(cosine, -1.0, 1.0)) / step;
        const auto i = std::min(static_cast<size_t>(place), entries);
        const double t = place - static_cast<double>(i);
        const auto between = [&](const std::vector<double>& kernel) { return kernel[i] + t * (kernel[i + 1] - kernel[i]); };
        return {between(m_lobe), between(m_bias), between(m_felt)};
    }

private:
    static constexpr size_t entries = 8192;
    static constexpr double step = pi / entries;
    static double angle(size_t i) { return std::min(pi, static_cast<double>(i) * step); }

    /// The kernel sum of (2l+1)/(4 pi) h_l P_l. A series that ends at once rings, and beside a sun that would be all there is: it fades.
    static std::vector<double> fromDegrees(std::vector<double> h)
    {
        while (!h.empty() && h.back() == 0.0)
            h.pop_back();
        const double degrees = static_cast<double>(h.size());
        for (size_t l = h.size() / 2; l < h.size(); ++l) {
            const double c = std::cos(0.5 * pi * (2.0 * static_cast<double>(l) / degrees - 1.0));
            h[l] *= c * c;
        }
        std::vector<double> kernel(entries + 2, 0.0);
        for (size_t i = 0; i < kernel.size(); ++i) {
            const double x = std::cos(angle(i));
            double previous = 0.0, p = 1.0;
            for (size_t l = 0; l < h.size(); ++l) {
                const double d = static_cast<double>(l);
                kernel[i] += (2.0 * d + 1.0) / (4.0 * pi) * h[l] * p;
                const double next = ((2.0 * d + 1.0) * x * p - d * previous) / (d + 1.0);
                previous = p;
                p = next;
            }
        }
        return kernel;
    }

    /// From how far away detail is felt, integral 1. A level's texels stand where they stand: what one of them adds errs in proportion, so
    /// that squares add up as h^2. Random samples would add up as h; those of a spiral, which shun each other, lie between. What
    /// interpolation misses lies where the model says, but for a tenth.
    std::vector<double> feltOf(const TransferModel& model) const
    {
        std::vector<double> kernel(m_lobe.size()), felt = fromDegrees(model.felt);
        for (size_t i = 0; i < kernel.size(); ++i) {
            const double h = std::max(0.0, m_lobe[i] + m_bias[i]);
            kernel[i] = model.blurs.empty() ? h * std::sqrt(h) : h * h;
            felt[i] *= felt[i];
        }
        normalize(kernel);
        normalize(felt);
        for (size_t i = 0; i < kernel.size() && !model.felt.empty(); ++i)
            kernel[i] = 0.1 * kernel[i] + 0.9 * felt[i];
        return kernel;
    }

    static void normalize(std::vector<double>& kernel)
    {
        double integral = 0.0;
        for (size_t i = 0; i < kernel.size(); ++i)
            integral += 2.0 * pi * kernel[i] * std::sin(angle(i)) * step;
        for (double& value : kernel)
            value = integral > 0.0 ? value / integral : 0.0;
    }

    /// Gauss functions, which end where those that box filters make of themselves do.
    static std::vector<double> fromBlurs(const std::vector<TransferModel::Blur>& blurs)
    {
        constexpr double reach = 3.0; // standard deviations
        std::vector<double> kernel(entries + 2, 0.0);
        for (const TransferModel::Blur& blur : blurs) {
            const auto gauss = [&](size_t i) {
                const double t = angle(i);
                return t * t < reach * reach * blur.variance ? std::exp(-0.5 * t * t / blur.variance) : 0.0;
            };
            double integral = 0.0;
            for (size_t i = 0; i < kernel.size(); ++i)
                integral += 2.0 * pi * gauss(i) * std::sin(angle(i)) * step;
            for (size_t i = 0; i < kernel.size(); ++i)
                kernel[i] += integral > 0.0 ? blur.share * gauss(i) / integral : 0.0;
        }
        return kernel;
    }

    std::vector<double> m_lobe, m_bias, m_felt;
    double m_leastCosine = -1.0;
};

/// A texel of the averaged probe.
struct Cell {
    glm::dvec3 direction;
    double solidAngle;
    glm::dvec3 mean;
    glm::dvec3 detail; ///< mean square of what neither the mean nor its slope tells
};

glm::dvec3 texelAt(const EnvironmentMap& map, int x, int y)
{
    const float* t = map.image.texel(x, y);
    return {t[0], t[1], t[2]};
}

std::vector<Cell> cellsOf(const EnvironmentMap& latlong, const Lobe& lobe, const JobControl& job)
{
    constexpr int fewest = 64;
    const int wanted = std::max(fewest, static_cast<int>(std::ceil(pi / LobeShape(lobe).halfWidth())));
    const MapLayout coarse{Parameterization::Latlong, std::min(latlong.layout.size, wanted), 0};
    float peak = 0.0f; // squares are taken relative to it, since those of the largest floats are none
    for (const float value : latlong.image.texels)
        peak = std::max(peak, std::abs(value));
    EnvironmentMap squares = latlong;
    for (float& value : squares.image.texels)
        value = peak > 0.0f ? (value / peak) * (value / peak) : 0.0f;
    const EnvironmentMap means = reproject(latlong, {.target = coarse}, job), meanSquares = reproject(squares, {.target = coarse}, job);
    const double scale = static_cast<double>(peak) * static_cast<double>(peak);
    const int width = coarse.width(), height = coarse.height();
    std::vector<Cell> cells;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 here = texelAt(means, x, y), left = texelAt(means, (x + width - 1) % width, y),
                             right = texelAt(means, (x + 1) % width, y), above = texelAt(means, x, std::max(y - 1, 0)),
                             below = texelAt(means, x, std::min(y + 1, height - 1));
            const glm::dvec3 across = 0.5 * (right - left), down = 0.5 * (below - above),
                             bend = here - 0.25 * (left + right + above + below);
            const glm::dvec3 within = scale * texelAt(meanSquares, x, y) - here * here - (across * across + down * down) / 12.0;
            cells.push_back(
                {texelDirection(coarse, x, y), texelSolidAngle(coarse, x, y), here, glm::max(within, glm::dvec3(0.0)) + bend * bend});
        }
    return cells;
}

/// The filtered map at a place, what is systematically wrong with it, and how much detail the light has under the method's kernel.
struct Place {
    double solidAngle = 0.0;
    glm::dvec3 value{0.0}, bias{0.0}, detail{0.0};
};

Place lookAt(const glm::dvec3& r, double solidAngle, const std::vector<Cell>& cells, const Kernels& kernels)
{
    double weight = 0.0, biasWeight = 0.0;
    glm::dvec3 sum(0.0), detail(0.0), bias(0.0);
    for (const Cell& cell : cells) {
        const double cosine = glm::dot(r, cell.direction);
        if (!kernels.reaches(cosine))
            continue;
        const Kernels::Weights k = kernels.at(cosine);
        const double w = cell.solidAngle * k.lobe, b = cell.solidAngle * k.bias;
        weight += w;
        biasWeight += b;
        sum += w * cell.mean;
        detail += cell.solidAngle * k.felt * cell.detail;
        bias += b * cell.mean;
    }
    if (weight <= 0.0)
        return {.solidAngle = solidAngle};
    const glm::dvec3 value = sum / weight;
    return {.solidAngle = solidAngle,
            .value = value,
            .bias = bias - biasWeight * value, // a constant is kept
            .detail = detail};
}

std::vector<Place> lookAround(const std::vector<Cell>& cells, const Kernels& kernels, const JobControl& job)
{
    constexpr MapLayout places{Parameterization::Latlong, 16, 0};
    std::vector<Place> found(static_cast<size_t>(places.width()) * static_cast<size_t>(places.height()));
    parallelRows(places.height(), job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < places.width(); ++x)
                found[static_cast<size_t>(y) * static_cast<size_t>(places.width()) + static_cast<size_t>(x)] =
                    lookAt(texelDirection(places, x, y), texelSolidAngle(places, x, y), cells, kernels);
    });
    return found;
}

/// Over the places, of a normal error's eighths.
PredictedErrors quantiles(const std::vector<Place>& places, double scatter, double relRms)
{
    constexpr std::array eighths{-1.534, -0.887, -0.489, -0.157, 0.157, 0.489, 0.887, 1.534}; // of the normal distribution, at (j + 1/2)/8
    double mean = 0.0, total = 0.0;
    for (const Place& p : places) {
        mean += p.solidAngle * (p.value.r + p.value.g + p.value.b) / 3.0;
        total += p.solidAngle;
    }
    const double least = std::max(1e-6 * std::abs(mean) / total, std::numeric_limits<double>::min());
    std::vector<WeightedValue> errors;
    for (const Place& p : places)
        for (int c = 0; c < 3; ++c)
            for (const double g : eighths)
                errors.push_back({std::abs(p.bias[c] + scatter * std::sqrt(p.detail[c]) * g) / std::max(p.value[c], least), p.solidAngle});
    const auto [median, p99] = weightedQuantiles(std::move(errors), std::array{0.5, 0.99});
    return {.relRms = relRms, .medianRel = median, .p99Rel = p99};
}

} // namespace

PredictedErrors spreadErrors(const EnvironmentMap& latlong, const Spectrum& spectrum, const Lobe& lobe, const TransferModel& model,
                             double relRms, const JobControl& job)
{
    // Integrals over the sphere, from all of it: the directions may miss the sun.
    const std::vector<double> power = spectrum.powerAboutMean();
    const std::vector<double> k = legendreCoefficients(lobe, spectrum.bandLimit);
    double mapSquare = 0.0, biasSquare = 0.0;
    for (size_t l = 0; l < power.size(); ++l) {
        mapSquare += power[l] * k[l] * k[l];
        biasSquare += l < model.bias.size() ? power[l] * model.bias[l] * model.bias[l] : 0.0;
    }
    const std::vector<Cell> cells = cellsOf(latlong, lobe, job);
    double detail = 0.0;
    for (const Cell& cell : cells)
        detail += cell.solidAngle * (cell.detail.r + cell.detail.g + cell.detail.b);
    const double rest = std::max(0.0, relRms * relRms * mapSquare - biasSquare);
    const double scatter = detail > 0.0 ? std::sqrt(rest / detail) : 0.0;
    return quantiles(lookAround(cells, Kernels(lobe, model), job), scatter, relRms);
}

} // namespace mirrorball
