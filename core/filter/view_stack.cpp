#include "view_stack.h"

#include "prefilter.h"

#include "core/base/error.h"
#include "core/image/reproject.h"
#include "core/sphere/latlong.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace mirrorball {

namespace {

using Complex = std::complex<double>;

/// Surfaces that are seen at a larger angle fill less than half a per cent of a ball.
constexpr double lastView = 87.0 * pi / 180.0;
constexpr size_t albedoViews = ViewStack::albedoViews, mostNodes = 32, mostLayers = 2048;
constexpr int narrowestMap = 64, widestMap = 4096;
/// A linear lookup at a random place between samples h apart misses of a wave of degree l this share times (l h)^2, root mean square.
constexpr double betweenSamples = 0.0913;

double kernelAt(const KernelSpectrum& kernel, int l, int m, int channel)
{
    return l <= kernel.bandLimit && m <= kernel.orders ? kernel.order(m, channel)[static_cast<size_t>(l)] : 0.0;
}

/// Plans the views, orders, degrees and texels of one BRDF in one probe's light.
class StackPlanner {
public:
    StackPlanner(FilterSource& source, const Brdf& brdf, const ViewStackOptions& options, JobControl job)
        : m_source(source), m_brdf(brdf), m_options(options), m_job(std::move(job)), m_tolerance(options.tolerance)
    {
    }

    void plan()
    {
        for (;; m_tolerance *= 2.0) {
            nodes.clear();
            nodes.push_back(planAt(0.0));
            m_worst = 0.0;
            for (const double degrees : {30.0, 55.0, 75.0})
                addUpTo(planAt(degrees * pi / 180.0), 5);
            addUpTo(planAt(lastView), 5);
            width = narrowestMap;
            while (width < widestMap && texelError() > 0.5 * m_tolerance)
                width *= 2;
            const auto texels = static_cast<std::int64_t>(layers()) * width * (width / 2);
            if (m_tolerance >= 0.5 || (texels <= m_options.mostTexels && layers() <= mostLayers && nodes.size() <= mostNodes))
                return;
        }
    }

    double tolerance() const { return m_tolerance; }
    double predictedError() const
    {
        double left = 0.0;
        for (const StackPlan& node : nodes)
            left = std::max(left, node.predictedError / stackMargin);
        return std::sqrt(left * left + m_worst * m_worst + texelError() * texelError());
    }
    size_t layers() const
    {
        size_t count = 0;
        for (const StackPlan& node : nodes)
            count += 2 * static_cast<size_t>(node.kernel.orders) + 1;
        return count;
    }

    std::vector<StackPlan> nodes{};
    int width = narrowestMap;

private:
    /// Of the whole probe: bright texels do not go through the harmonics, but what they send asks for views, orders and texels, too.
    std::vector<double> power(int bandLimit) { return m_source.spectrum(bandLimit, m_job).powerAboutMean(); }
    StackPlan planAt(double view)
    {
        m_job.checkStop();
        StackPlan plan = planStack(m_brdf, view, m_tolerance, largestStackOrder, [this](int bandLimit) { return power(bandLimit); });
        if (m_power.size() <= static_cast<size_t>(plan.kernel.bandLimit))
            m_power = power(plan.kernel.bandLimit);
        return plan;
    }
    /// The share of a response's power, over all frames and in the worst channel, that `error` has of it in each degree and order.
    template <typename Error>
    double share(const KernelSpectrum& kernel, int bandLimit, int orders, const Error& error) const
    {
        double worst = 0.0;
        for (int c = 0; c < (kernel.isGray ? 1 : 3); ++c) {
            double wrong = 0.0, right = 0.0;
            for (int m = 0; m <= orders; ++m)
                for (int l = m; l <= bandLimit; ++l) {
                    const double weight = (m == 0 ? 1.0 : 0.5) * m_power[static_cast<size_t>(l)], k = kernelAt(kernel, l, m, c);
                    const double e = error(l, m, c, k);
                    wrong += weight * e * e;
                    right += weight * k * k;
                }
            worst = std::max(worst, right > 0.0 ? wrong / right : 0.0);
        }
        return std::sqrt(worst);
    }
    /// Nodes behind the last one up to this one, so many that half way between two of them their mean is near enough.
    void addUpTo(StackPlan to, int depth)
    {
        const KernelSpectrum &a = nodes.back().kernel, &b = to.kernel;
        StackPlan half = planAt(0.5 * (a.view + b.view));
        const double wrong = share(half.kernel, std::max({a.bandLimit, b.bandLimit, half.kernel.bandLimit}),
                                   std::max({a.orders, b.orders, half.kernel.orders}),
                                   [&](int l, int m, int c, double k) { return k - 0.5 * (kernelAt(a, l, m, c) + kernelAt(b, l, m, c)); });
        if (wrong > 0.5 * m_tolerance && depth > 0 && nodes.size() <= mostNodes) {
            addUpTo(std::move(half), depth - 1);
            addUpTo(std::move(to), depth - 1);
            return;
        }
        m_worst = std::max(m_worst, wrong);
        nodes.push_back(std::move(to));
    }
    double texelError() const
    {
        const double h = 2.0 * pi / width;
        double worst = 0.0;
        for (const StackPlan& node : nodes)
            worst = std::max(worst, share(node.kernel, node.kernel.bandLimit, node.kernel.orders,
                                          [&](int l, int, int, double k) { return k * std::min(betweenSamples * l * l * h * h, 1.0); }));
        return worst;
    }

    FilterSource& m_source;
    const Brdf& m_brdf;
    ViewStackOptions m_options;
    JobControl m_job;
    double m_tolerance;
    double m_worst = 0.0; ///< between nodes
    std::vector<double> m_power{};
};

/// kappa_m(gamma) of a kernel as a table, even in the root of sin(gamma/2): fine where lobes are narrow.
class AzimuthalOrders {
public:
    AzimuthalOrders(const StackPlan& plan) : m_orders(static_cast<size_t>(plan.kernel.orders) + 1)
    {
        const ReflectionKernel kernel(plan.brdf, plan.kernel.view);
        m_channels = kernel.channels();
        m_table.resize((places + 1) * m_orders * m_channels);
        constexpr size_t samples = 256;
        std::vector<double> nl(samples), lv(samples);
        std::array<std::vector<double>, 3> k;
        for (auto& channel : k)
            channel.resize(samples);
        const double t = kernel.view();
        for (size_t p = 0; p <= places; ++p) {
            const double gamma = 2.0 * std::asin(std::pow(static_cast<double>(p) / places, 2.0));
            for (size_t i = 0; i < samples; ++i) {
                const double across = std::sin(gamma) * std::cos(pi * (static_cast<double>(i) + 0.5) / samples);
                nl[i] = std::cos(gamma) * std::cos(t) + across * std::sin(t);
                lv[i] = std::cos(gamma) * std::cos(2.0 * t) + across * std::sin(2.0 * t);
            }
            kernel.evaluate(nl, lv, {k[0].data(), k[1].data(), k[2].data()});
            for (size_t c = 0; c < m_channels; ++c)
                for (size_t m = 0; m < m_orders; ++m) {
                    double sum = 0.0;
                    for (size_t i = 0; i < samples; ++i)
                        sum +=
                            nl[i] > 0.0 ? k[c][i] * std::cos(static_cast<double>(m) * pi * (static_cast<double>(i) + 0.5) / samples) : 0.0;
                    const double albedo = plan.kernel.albedo[static_cast<int>(c)];
                    m_table[(p * m_orders + m) * m_channels + c] = albedo > 0.0 ? (m == 0 ? 1.0 : 2.0) * sum / (samples * albedo) : 0.0;
                }
        }
    }

    /// Adds flux kappa_m(gamma) e^(i m phi) to the layers of a texel. @param around  e^(i phi)
    void add(const glm::dvec3& flux, double cosGamma, const Complex& around, std::span<glm::dvec3> layers) const
    {
        const double at = static_cast<double>(places) * std::sqrt(std::sqrt(std::max(0.5 - 0.5 * cosGamma, 0.0)));
        const size_t p = std::min(static_cast<size_t>(at), places - 1);
        const double t = at - static_cast<double>(p);
        const double *a = m_table.data() + p * m_orders * m_channels, *b = a + m_orders * m_channels;
        if (a[0] == 0.0 && b[0] == 0.0) // below the horizon all around
            return;
        Complex turn(1.0);
        for (size_t m = 0; m < m_orders; ++m, turn *= around)
            for (size_t c = 0; c < 3; ++c) {
                const size_t i = m * m_channels + (m_channels == 1 ? 0 : c);
                const double value = flux[static_cast<int>(c)] * (a[i] + t * (b[i] - a[i]));
                layers[m == 0 ? 0 : 2 * m - 1][static_cast<int>(c)] += value * turn.real();
                if (m > 0)
                    layers[2 * m][static_cast<int>(c)] += value * turn.imag();
            }
    }

private:
    static constexpr size_t places = 2048;
    size_t m_orders, m_channels = 1;
    std::vector<double> m_table{}; ///< [place][order][channel]
};

/// The harmonics of what differs from the mean, and the mean: a constant probe is then exact.
Spectrum withoutMean(Spectrum spectrum, glm::dvec3& mean)
{
    for (int c = 0; c < 3; ++c) {
        std::vector<Complex>& a = spectrum.coefficients[static_cast<size_t>(c)];
        mean[c] = a[0].real() / spectrum.unit[0].real();
        for (size_t i = 0; i < a.size(); ++i)
            a[i] -= mean[c] * spectrum.unit[i];
    }
    return spectrum;
}

void store(const std::vector<double>& values, size_t channel, double more, Image& layer)
{
    for (size_t i = 0; i < values.size(); ++i)
        layer.texels[3 * i + channel] = static_cast<float>(values[i] + more);
}

void addBright(ViewStack& stack, const std::vector<StackPlan>& plans, const BrightTexels& bright, double yaw, const JobControl& job)
{
    std::vector<AzimuthalOrders> tables;
    for (const StackPlan& plan : plans) {
        job.checkStop();
        tables.emplace_back(plan);
    }
    const MapLayout layout{Parameterization::Latlong, stack.layers.front().height, 0};
    parallelRows(layout.height(), job, [&](int first, int last) {
        std::vector<glm::dvec3> sums(stack.layers.size());
        for (int y = first; y < last; ++y)
            for (int x = 0; x < layout.width(); ++x) {
                std::fill(sums.begin(), sums.end(), glm::dvec3(0.0));
                const glm::dvec3 r = yawed(texelDirection(layout, x, y), -yaw);
                const Tangents frame = tangentsAt(r);
                for (size_t i = 0; i < bright.directions.size(); ++i) {
                    const glm::dvec3& d = bright.directions[i];
                    const Complex across(glm::dot(d, frame.north), glm::dot(d, frame.east));
                    const double length = std::abs(across);
                    for (size_t n = 0; n < tables.size(); ++n)
                        tables[n].add(bright.flux[i], glm::dot(r, d), length > 1e-9 ? across / length : Complex(1.0),
                                      std::span(sums).subspan(static_cast<size_t>(stack.nodes[n].firstLayer)));
                }
                for (size_t i = 0; i < sums.size(); ++i)
                    for (int c = 0; c < 3; ++c)
                        stack.layers[i].texel(x, y)[c] += static_cast<float>(sums[i][c]);
            }
    });
}

double albedoView(size_t i) { return std::min(0.5 * pi * static_cast<double>(i) / (albedoViews - 1), 89.8 * pi / 180.0); }

} // namespace

ViewStack makeViewStack(FilterSource& source, const Brdf& brdf, const ViewStackOptions& options, const JobControl& job)
{
    if (!source.latlong())
        throw InvalidArgument("exact reflection: the probe must be held whole");
    if (!(options.tolerance > 0.0 && options.tolerance <= 1.0))
        throw InvalidArgument("tolerance: must lie in (0, 1]");
    ViewStack stack;
    stack.albedo.resize(albedoViews);
    parallelRows(
        static_cast<int>(albedoViews), job,
        [&](int first, int last) {
            for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i)
                stack.albedo[i] = directionalAlbedo(brdf, albedoView(i));
        },
        1);
    stack.tolerance = options.tolerance;
    if (isUnresolved(ggxLobe(equivalentAlpha(brdf)), source.width())) {
        const MapLayout target{Parameterization::Latlong, std::min(source.height(), widestMap / 2), 0};
        stack.nodes.emplace_back();
        stack.layers.push_back(reproject(*source.latlong(), {.target = target, .yaw = options.yaw}, job).image);
        return stack;
    }

    StackPlanner planner(source, brdf, options, partOf(job, 0.0f, 0.2f));
    planner.plan();
    stack.tolerance = planner.tolerance();
    stack.predictedError = planner.predictedError();
    int bandLimit = 0;
    for (const StackPlan& node : planner.nodes)
        bandLimit = std::max(bandLimit, node.kernel.bandLimit);
    glm::dvec3 mean;
    const Spectrum spectrum = withoutMean(stackSpectrum(source, bandLimit, job), mean);
    const int width = planner.width, height = width / 2;
    const RingSet rings = ringsOf({Parameterization::Latlong, height, 0}, options.yaw);
    stack.layers.assign(planner.layers(), Image(width, height));
    size_t layer = 0;
    for (const StackPlan& node : planner.nodes) {
        const KernelSpectrum& kernel = node.kernel;
        stack.nodes.push_back({.view = kernel.view, .orders = kernel.orders, .firstLayer = static_cast<int>(layer)});
        for (int m = 0; m <= kernel.orders; ++m) {
            for (size_t c = 0; c < 3; ++c) {
                const OrderMap order = synthesizeOrder(spectrum, static_cast<int>(c), m, kernel.order(m, static_cast<int>(c)), rings, job);
                store(order.real, c, m == 0 ? mean[static_cast<int>(c)] : 0.0, stack.layers[layer]);
                if (m > 0)
                    store(order.imaginary, c, 0.0, stack.layers[layer + 1]);
            }
            layer += m == 0 ? 1 : 2;
        }
        if (job.progress)
            job.progress(0.2f + 0.6f * static_cast<float>(layer) / static_cast<float>(stack.layers.size()));
    }
    if (const BrightTexels& bright = source.brightTexels(1, job); !bright.directions.empty())
        addBright(stack, planner.nodes, bright, options.yaw, partOf(job, 0.8f, 1.0f));
    return stack;
}

glm::dvec3 reflected(const ViewStack& stack, const glm::dvec3& n, const glm::dvec3& r)
{
    const double t = std::acos(std::clamp(glm::dot(n, r), 0.0, 1.0));
    size_t i = 0;
    while (i + 2 < stack.nodes.size() && stack.nodes[i + 1].view <= t)
        ++i;
    const size_t next = std::min(i + 1, stack.nodes.size() - 1);
    const double apart = stack.nodes[next].view - stack.nodes[i].view;
    const double between = apart > 0.0 ? std::clamp((t - stack.nodes[i].view) / apart, 0.0, 1.0) : 0.0;

    const Tangents frame = tangentsAt(r);
    const Complex across(glm::dot(n, frame.north), glm::dot(n, frame.east));
    const double length = std::abs(across);
    const Complex azimuth = length > 1e-6 ? across / length : Complex(1.0);
    const int height = stack.layers.front().height;
    const glm::dvec2 p = coordinate({Parameterization::Latlong, height, 0}, r) - 0.5, corner = glm::floor(p), f = p - corner;
    const auto lookup = [&](int layer, double sign) {
        glm::dvec3 sum(0.0);
        for (int k = 0; k < 4; ++k) {
            const int x = static_cast<int>(corner.x) + k % 2, y = static_cast<int>(corner.y) + k / 2;
            const Texel texel = latlong::acrossSeam(height, x, y);
            const float* value = stack.layers[static_cast<size_t>(layer)].texel(texel.x, texel.y);
            const double weight = (k % 2 ? f.x : 1.0 - f.x) * (k / 2 ? f.y : 1.0 - f.y) * (y < 0 || y >= height ? sign : 1.0);
            sum += weight * glm::dvec3(value[0], value[1], value[2]);
        }
        return sum;
    };
    const auto at = [&](const ViewStack::Node& node) {
        glm::dvec3 sum = lookup(node.firstLayer, 1.0);
        Complex turn(1.0);
        for (int m = 1; m <= node.orders; ++m) {
            turn *= azimuth;
            const double sign = m % 2 ? -1.0 : 1.0;
            sum += turn.real() * lookup(node.firstLayer + 2 * m - 1, sign) + turn.imag() * lookup(node.firstLayer + 2 * m, sign);
        }
        return sum;
    };
    const double x = t / (0.5 * pi) * static_cast<double>(stack.albedo.size() - 1);
    const size_t left = std::min(static_cast<size_t>(x), stack.albedo.size() - 2);
    const glm::dvec3 albedo = glm::mix(stack.albedo[left], stack.albedo[left + 1], x - static_cast<double>(left));
    return albedo * glm::max(glm::mix(at(stack.nodes[i]), at(stack.nodes[next]), between), 0.0);
}

} // namespace mirrorball
