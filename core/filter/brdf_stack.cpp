#include "brdf_stack.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// The worst channel of a kernel: orders and degrees that are left out as a share of the response.
class Shares {
public:
    Shares(const KernelSpectrum& kernel, const std::vector<double>& power) : m_kernel(kernel)
    {
        const auto degrees = static_cast<size_t>(kernel.bandLimit) + 1, ms = static_cast<size_t>(kernel.orders) + 1;
        for (int c = 0; c < (kernel.isGray ? 1 : 3); ++c) {
            double total = 0.0;
            std::vector<double> byOrder(ms * degrees);
            double held = 0.0;
            for (int m = 0; m <= kernel.orders; ++m)
                for (int l = m; l <= kernel.bandLimit; ++l) {
                    const double term = kernel.term(l, m, c);
                    held += term;
                    const double part = term * power[static_cast<size_t>(l)] / (2.0 * l + 1.0);
                    byOrder[static_cast<size_t>(m) * degrees + static_cast<size_t>(l)] = part;
                    total += part;
                }
            // What neither degrees nor orders hold meets the probe where its last degrees stand.
            double last = 0.0;
            for (int l = kernel.bandLimit * 7 / 10; l <= kernel.bandLimit; ++l)
                last = std::max(last, power[static_cast<size_t>(l)] / (2.0 * l + 1.0));
            const double rest = std::max(kernel.power[static_cast<size_t>(c)] - held, 0.0) * last;
            total += rest;
            if (total <= 0.0)
                continue;
            for (double& part : byOrder)
                part /= total;
            m_channels.push_back({std::move(byOrder), rest / total});
        }
    }

    /// Square of the error when degrees above `bandLimit` and orders above `orders` are left out.
    double leftOut(int bandLimit, int orders) const
    {
        const auto degrees = static_cast<size_t>(m_kernel.bandLimit) + 1;
        double worst = 0.0;
        for (const Channel& channel : m_channels) {
            double sum = channel.rest;
            for (int m = 0; m <= m_kernel.orders; ++m)
                for (int l = m <= orders ? bandLimit + 1 : m; l <= m_kernel.bandLimit; ++l)
                    sum += channel.parts[static_cast<size_t>(m) * degrees + static_cast<size_t>(l)];
            worst = std::max(worst, sum);
        }
        return worst;
    }

private:
    struct Channel {
        std::vector<double> parts;
        double rest;
    };
    const KernelSpectrum& m_kernel;
    std::vector<Channel> m_channels{};
};

KernelSpectrum cut(const KernelSpectrum& kernel, int bandLimit, int orders)
{
    KernelSpectrum result = kernel;
    result.bandLimit = bandLimit;
    result.orders = orders;
    for (int c = 0; c < (kernel.isGray ? 1 : 3); ++c) {
        auto& k = result.k[static_cast<size_t>(c)];
        k.clear();
        for (int m = 0; m <= orders; ++m) {
            const auto from = kernel.order(m, c).first(static_cast<size_t>(bandLimit) + 1);
            k.insert(k.end(), from.begin(), from.end());
        }
    }
    return result;
}

/// Re sum_m e^(-i m psi) A_m of a channel of light through a channel of the kernel.
std::vector<double> response(const Spectrum& spectrum, const KernelSpectrum& kernel, int kernelChannel, int channel, double azimuth,
                             const RingSet& rings, const JobControl& job)
{
    std::vector<double> sum;
    for (int m = 0; m <= kernel.orders; ++m) {
        const OrderMap order = synthesizeOrder(spectrum, channel, m, kernel.order(m, kernelChannel), rings, job);
        if (m == 0) {
            sum = order.real;
            continue;
        }
        const double cosine = std::cos(m * azimuth), sine = std::sin(m * azimuth);
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += cosine * order.real[i] + sine * order.imaginary[i];
    }
    return sum;
}

/// What the bright texels send to every texel of the map, not yet normalized; empty where there are none.
std::vector<glm::dvec3> brightResponse(FilterSource& source, const StackPlan& plan, double azimuth, const MapLayout& target, double yaw,
                                       const JobControl& job)
{
    const BrightTexels& bright = source.brightTexels(1, job);
    const size_t count = bright.directions.size(), width = static_cast<size_t>(target.width());
    if (!source.latlong() || count == 0)
        return {};
    const ReflectionKernel kernel(plan.brdf, plan.kernel.view);
    std::vector<glm::dvec3> result(width * static_cast<size_t>(target.height()));
    parallelRows(target.height(), job, [&](int first, int last) {
        std::vector<double> nl(count), lv(count);
        std::array<std::vector<double>, 3> k;
        for (auto& channel : k)
            channel.resize(count);
        for (int y = first; y < last; ++y)
            for (size_t x = 0; x < width; ++x) {
                const glm::dvec3 r = yawed(texelDirection(target, static_cast<int>(x), y), -yaw);
                const glm::dvec3 n = normalAt(r, {plan.kernel.view, azimuth}), v = 2.0 * glm::dot(n, r) * n - r;
                for (size_t i = 0; i < count; ++i) {
                    nl[i] = glm::dot(n, bright.directions[i]);
                    lv[i] = glm::dot(v, bright.directions[i]);
                }
                kernel.evaluate(nl, lv, {k[0].data(), k[1].data(), k[2].data()});
                glm::dvec3 sum(0.0);
                for (size_t i = 0; i < count; ++i)
                    for (size_t c = 0; c < 3; ++c)
                        sum[static_cast<int>(c)] += k[kernel.isGray() ? 0 : c][i] * bright.flux[i][static_cast<int>(c)];
                result[static_cast<size_t>(y) * width + x] = sum;
            }
    });
    return result;
}

} // namespace

StackPlan planStack(const Brdf& brdf, double view, double tolerance, int orders, FilterSource& source, const JobControl& job)
{
    return planStack(brdf, view, tolerance, orders, [&](int bandLimit) { return stackSpectrum(source, bandLimit, job).powerAboutMean(); });
}

StackPlan planStack(const Brdf& brdf, double view, double tolerance, int orders, const PowerByDegree& powerOf)
{
    if (!(tolerance > 0.0 && tolerance <= 1.0))
        throw InvalidArgument("tolerance: must lie in (0, 1]");
    const ReflectionKernel kernel(brdf, view);
    const double wanted = tolerance / stackMargin, squared = wanted * wanted;
    // Doubled until what is left out is small enough, then cut back to what that needs.
    int bandLimit = 32, looked = std::min(orders, 12);
    for (;;) {
        const KernelSpectrum spectrum = kernelSpectrum(kernel, bandLimit, std::min(looked, bandLimit));
        const std::vector<double> power = powerOf(bandLimit);
        const Shares shares(spectrum, power);
        const bool isLast = bandLimit >= largestStackDegree && looked >= orders;
        if (shares.leftOut(spectrum.bandLimit, spectrum.orders) > 0.25 * squared && !isLast) {
            bandLimit = std::min(2 * bandLimit, largestStackDegree);
            looked = std::min(2 * looked, orders);
            continue;
        }
        int m = spectrum.orders, l = spectrum.bandLimit;
        while (m > 0 && shares.leftOut(l, m - 1) <= 0.7 * squared)
            --m;
        while (l > m && shares.leftOut(l - 1, m) <= squared)
            --l;
        return {brdf, cut(spectrum, l, m), stackMargin * std::sqrt(shares.leftOut(l, m))};
    }
}

StackPlan planStack(const Brdf& brdf, double view, double tolerance, FilterSource& source, const JobControl& job)
{
    return planStack(brdf, view, tolerance, largestStackOrder, source, job);
}

const Spectrum& stackSpectrum(FilterSource& source, int bandLimit, const JobControl& job)
{
    return source.latlong() ? source.calmSpectrum(1, bandLimit, job) : source.spectrum(bandLimit, job);
}

RingSet ringsOf(const MapLayout& layout, double yaw)
{
    RingSet rings;
    const int width = layout.width(), height = layout.height();
    if (layout.kind == Parameterization::Latlong) {
        rings.length = width;
        for (int y = 0; y < height; ++y) {
            rings.colatitude.push_back(pi * (y + 0.5) / height);
            rings.azimuth.push_back(pi / width + yaw); // azimuth runs against longitude
        }
        return rings;
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 d = yawed(texelDirection(layout, x, y), -yaw);
            rings.colatitude.push_back(std::acos(std::clamp(d.y, -1.0, 1.0)));
            rings.azimuth.push_back(pi - std::atan2(d.x, d.z));
        }
    return rings;
}

EnvironmentMap filterBrdfStack(FilterSource& source, const StackPlan& plan, double azimuth, const MapLayout& target, double yaw,
                               const JobControl& job)
{
    const KernelSpectrum& kernel = plan.kernel;
    const Spectrum& spectrum = stackSpectrum(source, kernel.bandLimit, job);
    const RingSet rings = ringsOf(target, yaw);
    const auto length = static_cast<size_t>(rings.length);
    EnvironmentMap map(target);
    const size_t texels = map.image.texels.size() / 3;
    const bool isLight = source.latlong() == nullptr ||
                         *std::min_element(source.latlong()->image.texels.begin(), source.latlong()->image.texels.end()) >= 0.0f;
    const std::vector<glm::dvec3> bright = brightResponse(source, plan, azimuth, target, yaw, job);
    std::vector<double> norm;
    for (int c = 0; c < 3; ++c) {
        const std::vector<double> light = response(spectrum, kernel, c, c, azimuth, rings, job);
        if (c == 0 || !kernel.isGray)
            norm = response(spectrum, kernel, c, 3, azimuth, rings, job);
        const size_t perNorm = norm.size() == light.size() ? 1 : length;
        for (size_t i = 0; i < texels; ++i) {
            const double sum = kernel.albedo[c] * light[i] + (bright.empty() ? 0.0 : bright[i][c]), value = sum / norm[i / perNorm];
            map.image.texels[3 * i + static_cast<size_t>(c)] = static_cast<float>(isLight ? std::max(value, 0.0) : value);
        }
    }
    return map;
}

} // namespace mirrorball
