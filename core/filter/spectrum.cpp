#include "spectrum.h"

#include "core/base/error.h"

#include <fftw3.h>
#include <libsharp/sharp.h>
#include <libsharp/sharp_almhelpers.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <utility>

namespace mirrorball {

namespace {

using Complex = std::complex<double>;

struct GeometryDeleter {
    void operator()(sharp_geom_info* p) const { sharp_destroy_geom_info(p); }
};
struct CoefficientsDeleter {
    void operator()(sharp_alm_info* p) const { sharp_destroy_alm_info(p); }
};
using Geometry = std::unique_ptr<sharp_geom_info, GeometryDeleter>;
using Coefficients = std::unique_ptr<sharp_alm_info, CoefficientsDeleter>;

/// Rings of one length, stored one after the other.
Geometry ringGeometry(const std::vector<double>& theta, const std::vector<double>& weight, int ringLength, double phi0)
{
    const size_t n = theta.size();
    const std::vector<int> lengths(n, ringLength), strides(n, 1);
    const std::vector<double> starts(n, phi0);
    std::vector<ptrdiff_t> offsets(n);
    for (size_t i = 0; i < n; ++i)
        offsets[i] = static_cast<ptrdiff_t>(i) * ringLength;
    sharp_geom_info* info = nullptr;
    sharp_make_geom_info(static_cast<int>(n), lengths.data(), offsets.data(), strides.data(), starts.data(), theta.data(),
                         weight.empty() ? nullptr : weight.data(), &info);
    return Geometry(info);
}

Coefficients triangle(int bandLimit)
{
    sharp_alm_info* info = nullptr;
    sharp_make_triangular_alm_info(bandLimit, bandLimit, 1, &info);
    return Coefficients(info);
}

/// libsharp takes its number of threads from OpenMP's setting for the calling thread; this sets it for a scope.
class OpenMpThreads {
public:
    explicit OpenMpThreads(int threads) : m_before(omp_get_max_threads())
    {
        needThreads(threads);
        omp_set_num_threads(threads);
    }
    ~OpenMpThreads() { omp_set_num_threads(m_before); }
    OpenMpThreads(const OpenMpThreads&) = delete;
    OpenMpThreads& operator=(const OpenMpThreads&) = delete;

private:
    int m_before;
};

void transform(sharp_jobtype type, std::vector<Complex>& coefficients, std::vector<double>& map, const Geometry& geometry,
               const Coefficients& triangle, const JobControl& job)
{
    job.checkStop();
    const OpenMpThreads threads(job.threadCount());
    Complex* alm = coefficients.data();
    double* texels = map.data();
    sharp_execute(type, 0, &alm, &texels, geometry.get(), triangle.get(), SHARP_DP, nullptr, nullptr);
}

/// Smallest number >= n whose only prime factors are 2, 3 and 5, and that is even: lengths FFTs like.
int goodLength(int n)
{
    for (int length = std::max(2, n + n % 2);; length += 2) {
        int rest = length;
        for (const int p : {2, 3, 5})
            while (rest % p == 0)
                rest /= p;
        if (rest == 1)
            return length;
    }
}

std::vector<double> ringColatitudes(int rings)
{
    std::vector<double> theta(static_cast<size_t>(rings));
    for (int j = 0; j < rings; ++j)
        theta[static_cast<size_t>(j)] = pi * (j + 0.5) / rings;
    return theta;
}

/// Solid angle of the band of colatitudes that row j of a latlong map covers, over 2 pi: cos(a) - cos(b) without cancellation.
double bandHeight(int j, int rings) { return 2.0 * std::sin(pi * (j + 0.5) / rings) * std::sin(0.5 * pi / rings); }

/// FFTW's planner is not thread-safe; its executors are.
std::mutex& plannerMutex()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace

std::vector<double> Spectrum::powerAboutMean() const
{
    std::vector<double> result(static_cast<size_t>(bandLimit) + 1);
    for (const auto& channel : coefficients) {
        const double mean = channel[0].real() / unit[0].real();
        const auto add = [&](int l, int m, bool zonal) {
            const size_t i = index(l, m);
            const Complex a = zonal ? channel[i] - mean * unit[i] : channel[i];
            result[static_cast<size_t>(l)] += (m == 0 ? 1.0 : 2.0) * std::norm(a);
        };
        result[0] += std::norm(channel[0]);
        for (int m = 0; m <= bandLimit; ++m)
            for (int l = std::max(m, 1); l <= bandLimit; ++l)
                add(l, m, m % ringLength == 0);
    }
    return result;
}

/// Transforms of one row: to its Fourier coefficients, and back at the kept length.
struct SpectrumBuilder::Plans {
    fftw_plan forward = nullptr;
    fftw_plan inverse = nullptr;

    Plans(int width, int keptLength)
    {
        std::vector<double> row(static_cast<size_t>(width)), kept(static_cast<size_t>(keptLength));
        std::vector<Complex> modes(static_cast<size_t>(std::max(width, keptLength)) / 2 + 1);
        auto* m = reinterpret_cast<fftw_complex*>(modes.data());
        // The vectors that the plans run on later are aligned like these (16 bytes; rows of even length keep it), so the SIMD
        // kernels apply.
        const std::lock_guard lock(plannerMutex());
        forward = fftw_plan_dft_r2c_1d(width, row.data(), m, FFTW_ESTIMATE);
        inverse = fftw_plan_dft_c2r_1d(keptLength, m, kept.data(), FFTW_ESTIMATE);
    }
    ~Plans()
    {
        const std::lock_guard lock(plannerMutex());
        fftw_destroy_plan(forward);
        fftw_destroy_plan(inverse);
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;
};

SpectrumBuilder::SpectrumBuilder(int width, int height, int bandLimit) : m_width(width), m_height(height), m_bandLimit(bandLimit)
{
    assert(width > 0 && height > 0 && bandLimit >= 0);
    const int enough = goodLength(2 * bandLimit + 2);
    m_keptLength = enough < width ? enough : width;
    if (m_keptLength < width)
        m_plans = std::make_unique<Plans>(width, m_keptLength);
    for (auto& channel : m_rows)
        channel.resize(static_cast<size_t>(height) * static_cast<size_t>(m_keptLength));
}

SpectrumBuilder::~SpectrumBuilder() = default;

void SpectrumBuilder::addRows(int firstRow, int rows, const float* rgb, const JobControl& job)
{
    const auto width = static_cast<size_t>(m_width), kept = static_cast<size_t>(m_keptLength);
    std::mutex peakMutex;
    parallelRows(rows, job, [&](int first, int last) {
        std::vector<double> row(width);
        std::vector<Complex> modes(width / 2 + 1);
        float peak = 0.0f;
        for (int y = first; y < last; ++y) {
            const float* texels = rgb + static_cast<size_t>(y) * width * 3;
            for (size_t c = 0; c < 3; ++c) {
                double* target = m_rows[c].data() + static_cast<size_t>(firstRow + y) * kept;
                double* input = m_plans ? row.data() : target;
                for (size_t x = 0; x < width; ++x) {
                    const float value = texels[3 * x + c];
                    peak = std::max(peak, std::abs(value));
                    input[x] = value;
                }
                if (!m_plans)
                    continue;
                fftw_execute_dft_r2c(m_plans->forward, row.data(), reinterpret_cast<fftw_complex*>(modes.data()));
                // Keep |m| <= bandLimit. The last mode of the kept length (its Nyquist frequency) is above that and stays empty.
                std::fill(modes.begin() + m_bandLimit + 1, modes.begin() + static_cast<ptrdiff_t>(kept / 2 + 1), Complex(0.0));
                fftw_execute_dft_c2r(m_plans->inverse, reinterpret_cast<fftw_complex*>(modes.data()), target);
                // FFTW's pair multiplies by the length; dividing by the row's own length keeps the values those of the texels.
                for (size_t x = 0; x < kept; ++x)
                    target[x] /= static_cast<double>(width);
            }
        }
        const std::lock_guard lock(peakMutex);
        m_peak = std::max(m_peak, static_cast<double>(peak));
    });
}

Spectrum SpectrumBuilder::finish(const JobControl& job)
{
    const std::vector<double> theta = ringColatitudes(m_height);
    std::vector<double> weight(theta.size());
    for (int j = 0; j < m_height; ++j)
        weight[static_cast<size_t>(j)] = bandHeight(j, m_height) * 2.0 * pi / m_keptLength;

    Spectrum spectrum;
    spectrum.bandLimit = m_bandLimit;
    spectrum.rings = m_height;
    spectrum.ringLength = m_width;
    spectrum.peak = m_peak;
    const size_t count = spectrum.index(m_bandLimit, m_bandLimit) + 1;
    // The first sample of a truncated row keeps its texel's azimuth, half a texel of the full row.
    const Geometry geometry = ringGeometry(theta, weight, m_keptLength, pi / m_width);
    const Coefficients layout = triangle(m_bandLimit);
    for (size_t c = 0; c < 3; ++c) {
        spectrum.coefficients[c].resize(count);
        transform(SHARP_MAP2ALM, spectrum.coefficients[c], m_rows[c], geometry, layout, job);
    }

    // A constant 1 on these rings holds orders that are multiples of the row's length only. Below the first of those it is zonal, and
    // its coefficients are a sum over the rows.
    spectrum.unit.resize(count);
    if (m_bandLimit >= m_width) {
        std::fill(m_rows[0].begin(), m_rows[0].end(), 1.0);
        transform(SHARP_MAP2ALM, spectrum.unit, m_rows[0], geometry, layout, job);
        return spectrum;
    }
    std::vector<double> sums(static_cast<size_t>(m_bandLimit) + 1); // of w_j P_l(cos theta_j)
    for (int j = 0; j < m_height; ++j) {
        const double x = std::cos(theta[static_cast<size_t>(j)]);
        double previous = 0.0, p = 1.0;
        for (int l = 0; l <= m_bandLimit; ++l) {
            sums[static_cast<size_t>(l)] += 2.0 * pi * bandHeight(j, m_height) * p;
            previous = std::exchange(p, ((2.0 * l + 1.0) * x * p - l * previous) / (l + 1.0));
        }
    }
    for (int l = 0; l <= m_bandLimit; ++l)
        spectrum.unit[spectrum.index(l, 0)] = std::sqrt((2.0 * l + 1.0) / (4.0 * pi)) * sums[static_cast<size_t>(l)];
    return spectrum;
}

Spectrum analyse(const EnvironmentMap& latlong, int bandLimit, const JobControl& job)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("spectrum: the probe must be a latlong map; reproject it first");
    SpectrumBuilder builder(latlong.image.width, latlong.image.height, bandLimit);
    builder.addRows(0, latlong.image.height, latlong.image.texels.data(), job);
    return builder.finish(job);
}

FilteredRings synthesise(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& theta, int ringLength,
                         double phi0, const std::vector<Complex>& azimuthFactors, const JobControl& job)
{
    const int bandLimit = static_cast<int>(k.size()) - 1;
    assert(bandLimit <= spectrum.bandLimit && azimuthFactors.size() > static_cast<size_t>(bandLimit));
    const Geometry geometry = ringGeometry(theta, {}, ringLength, phi0);
    const Coefficients layout = triangle(bandLimit);
    Spectrum filtered; // only for its index
    filtered.bandLimit = bandLimit;
    std::vector<Complex> product(filtered.index(bandLimit, bandLimit) + 1);
    const auto onRings = [&](const std::vector<Complex>& coefficients) {
        for (int m = 0; m <= bandLimit; ++m) {
            const Complex factor = azimuthFactors[static_cast<size_t>(m)];
            const Complex* from = coefficients.data() + spectrum.index(0, m);
            Complex* to = product.data() + filtered.index(0, m);
            for (int l = m; l <= bandLimit; ++l)
                to[l] = from[l] * (factor * k[static_cast<size_t>(l)]);
        }
        std::vector<double> map(theta.size() * static_cast<size_t>(ringLength));
        transform(SHARP_ALM2MAP, product, map, geometry, layout, job);
        return map;
    };

    FilteredRings rings;
    for (size_t c = 0; c < 3; ++c)
        rings.rgb[c] = onRings(spectrum.coefficients[c]);
    if (bandLimit >= spectrum.ringLength) {
        rings.norm = onRings(spectrum.unit);
        return rings;
    }
    for (const double t : theta) { // zonal: one value a ring
        const double x = std::cos(t);
        double previous = 0.0, p = 1.0, sum = 0.0;
        for (int l = 0; l <= bandLimit; ++l) {
            sum += k[static_cast<size_t>(l)] * std::sqrt((2.0 * l + 1.0) / (4.0 * pi)) * spectrum.unit[spectrum.index(l, 0)].real() * p;
            previous = std::exchange(p, ((2.0 * l + 1.0) * x * p - l * previous) / (l + 1.0));
        }
        rings.norm.insert(rings.norm.end(), static_cast<size_t>(ringLength), sum);
    }
    return rings;
}

} // namespace mirrorball
