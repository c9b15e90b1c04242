#include "spectrum.h"

#include "ring_transform.h"

#include "core/base/error.h"
#include "core/base/multiversion.h"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <mutex>
#include <span>
#include <utility>

namespace mirrorball {

namespace {

using namespace ring_transform;

using Complex = std::complex<double>;

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

/// Solid angle of the band of colatitudes that row j of a latlong map covers, over 2 pi: cos(a) - cos(b) without cancellation.
double bandHeight(int j, int rings) { return 2.0 * std::sin(pi * (j + 0.5) / rings) * std::sin(0.5 * pi / rings); }

/// FFTW's planner is not thread-safe; its executors are.
std::mutex& plannerMutex()
{
    static std::mutex mutex;
    return mutex;
}

/// Adds share |a - mean unit|^2 of coefficients in a row to a power for each. @param unit  null: none
MIRRORBALL_CLONES void addPower(const Complex* coefficients, const Complex* unit, double mean, double share, size_t count,
                                double* __restrict power)
{
    const auto* a = reinterpret_cast<const double*>(coefficients); // as the standard lays them out
    const auto* u = reinterpret_cast<const double*>(unit);
    for (size_t i = 0; i < count; ++i) {
        const double re = u ? a[2 * i] - mean * u[2 * i] : a[2 * i], im = u ? a[2 * i + 1] - mean * u[2 * i + 1] : a[2 * i + 1];
        power[i] += share * (re * re + im * im);
    }
}

/// Adds factor P_l at many places, and goes from P_(l-1), P_l to P_l, P_(l+1).
MIRRORBALL_CLONES void addLegendre(size_t l, double factor, const std::vector<double>& x, std::vector<double>& before,
                                   std::vector<double>& now, std::vector<double>& sum)
{
    const double d = static_cast<double>(l), a = (2.0 * d + 1.0) / (d + 1.0), b = d / (d + 1.0);
    const double* __restrict at = x.data();
    double* __restrict previous = before.data(), * __restrict p = now.data(), * __restrict norm = sum.data();
    for (size_t j = 0; j < x.size(); ++j) {
        norm[j] += factor * p[j];
        const double next = a * at[j] * p[j] - b * previous[j];
        previous[j] = p[j];
        p[j] = next;
    }
}

/// One channel of a row of RGB. @return the sum of its squares
MIRRORBALL_CLONES double takeChannel(const float* __restrict rgb, size_t width, double* __restrict values)
{
    std::array<double, 4> squares{}; // sums that do not wait for one another
    size_t x = 0;
    for (; x + 4 <= width; x += 4)
        for (size_t k = 0; k < 4; ++k) {
            const double value = rgb[3 * (x + k)];
            values[x + k] = value;
            squares[k] += value * value;
        }
    for (; x < width; ++x) {
        values[x] = rgb[3 * x];
        squares[x % 4] += values[x] * values[x];
    }
    return squares[0] + squares[1] + squares[2] + squares[3];
}

/// Takes the largest magnitude and the least value of some into account.
MIRRORBALL_CLONES void widen(const float* values, size_t count, float& peak, float& least)
{
    constexpr size_t lanes = 16;
    std::array<float, lanes> peaks, leasts;
    peaks.fill(peak);
    leasts.fill(least);
    size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (size_t k = 0; k < lanes; ++k) {
            peaks[k] = std::max(peaks[k], std::abs(values[i + k]));
            leasts[k] = std::min(leasts[k], values[i + k]);
        }
    for (; i < count; ++i) {
        peaks[0] = std::max(peaks[0], std::abs(values[i]));
        leasts[0] = std::min(leasts[0], values[i]);
    }
    peak = *std::max_element(peaks.begin(), peaks.end());
    least = *std::min_element(leasts.begin(), leasts.end());
}

} // namespace

std::vector<glm::dvec3> Spectrum::channelPowerAboutMean() const
{
    std::vector<glm::dvec3> result(static_cast<size_t>(bandLimit) + 1, glm::dvec3(0.0));
    for (int c = 0; c < 3; ++c) {
        const std::vector<Complex>& channel = coefficients[static_cast<size_t>(c)];
        const double mean = channel[0].real() / unit[0].real();
        std::vector<double> power(static_cast<size_t>(bandLimit) + 1, 0.0);
        for (int m = 0; m <= bandLimit; ++m) {
            const int first = std::max(m, 1);
            const auto count = static_cast<size_t>(bandLimit - first + 1);
            addPower(channel.data() + index(first, m), m % ringLength == 0 ? unit.data() + index(first, m) : nullptr, mean,
                     m == 0 ? 1.0 : 2.0, count, power.data() + first);
        }
        power[0] = std::norm(channel[0]);
        for (size_t l = 0; l < power.size(); ++l)
            result[l][c] = power[l];
    }
    return result;
}

std::vector<double> Spectrum::powerAboutMean() const
{
    std::vector<double> result;
    for (const glm::dvec3& p : channelPowerAboutMean())
        result.push_back(p.r + p.g + p.b);
    return result;
}

glm::dvec3 Spectrum::varianceAboutMean() const
{
    glm::dvec3 variance;
    for (int c = 0; c < 3; ++c) {
        const double mean = coefficients[static_cast<size_t>(c)][0].real() / unit[0].real(); // unit[0] is sqrt(4 pi)
        variance[c] = std::max(0.0, secondMoment[c] - mean * mean * 4.0 * pi);
    }
    return variance;
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

/// One texel's row truncated to |m| <= B: Dirichlet's kernel, sin((B + 1/2) t) / sin(t/2), at the kept samples.
struct SpectrumBuilder::Dirichlet {
    double order;                           ///< B + 1/2
    std::vector<glm::dvec2> fast{}, slow{}; ///< (cos, sin) of order t and of t/2 at each sample, t counted from the first

    Dirichlet(int keptLength, int bandLimit) : order(bandLimit + 0.5)
    {
        for (int s = 0; s < keptLength; ++s) {
            const double t = 2.0 * pi * s / keptLength;
            fast.emplace_back(std::cos(order * t), std::sin(order * t));
            slow.emplace_back(std::cos(0.5 * t), std::sin(0.5 * t));
        }
    }

    /// @param turn  where the texel is, in [0, 1) of the row
    void add(double* row, double turn, double amount) const
    {
        const double t = 2.0 * pi * turn;
        const double fastCos = std::cos(order * t), fastSin = std::sin(order * t), slowCos = std::cos(0.5 * t), slowSin = std::sin(0.5 * t);
        for (size_t s = 0; s < fast.size(); ++s) {
            const double half = slow[s].y * slowCos - slow[s].x * slowSin;
            const double kernel = std::abs(half) < 1e-9 ? 2.0 * order : (fast[s].y * fastCos - fast[s].x * fastSin) / half;
            row[s] += amount * kernel;
        }
    }
};

SpectrumBuilder::SpectrumBuilder(int width, int height, int bandLimit, RowRange rows)
    : m_width(width), m_height(height), m_bandLimit(bandLimit), m_range(rows)
{
    assert(width > 0 && bandLimit >= 0 && 0 <= rows.first && rows.first < rows.end && rows.end <= height);
    const int enough = goodLength(2 * bandLimit + 2);
    m_keptLength = enough < width ? enough : width;
    if (m_keptLength < width)
        m_plans = std::make_unique<Plans>(width, m_keptLength);
    for (auto& channel : m_rows)
        channel.resize(static_cast<size_t>(rows.end - rows.first) * static_cast<size_t>(m_keptLength));
    m_rowSquares.resize(static_cast<size_t>(rows.end - rows.first), glm::dvec3(0.0));
}

SpectrumBuilder::~SpectrumBuilder() = default;

void SpectrumBuilder::addRows(int firstRow, int rows, const float* rgb, const JobControl& job)
{
    const auto width = static_cast<size_t>(m_width), kept = static_cast<size_t>(m_keptLength);
    std::mutex peakMutex;
    parallelRows(rows, job, [&](int first, int last) {
        std::vector<double> row(width);
        std::vector<Complex> modes(width / 2 + 1);
        float peak = 0.0f, least = HUGE_VALF;
        for (int y = first; y < last; ++y) {
            const float* texels = rgb + static_cast<size_t>(y) * width * 3;
            widen(texels, 3 * width, peak, least);
            for (size_t c = 0; c < 3; ++c) {
                double* target = m_rows[c].data() + static_cast<size_t>(firstRow - m_range.first + y) * kept;
                double* input = m_plans ? row.data() : target;
                m_rowSquares[static_cast<size_t>(firstRow - m_range.first + y)][static_cast<int>(c)] =
                    takeChannel(texels + c, width, input);
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
        m_least = std::min(m_least, static_cast<double>(least));
    });
}

void SpectrumBuilder::replace(int x, int y, const glm::dvec3& before, const glm::dvec3& radiance)
{
    if (m_plans && !m_dirichlet)
        m_dirichlet = std::make_unique<Dirichlet>(m_keptLength, m_bandLimit);
    for (int c = 0; c < 3; ++c) {
        const auto at = static_cast<size_t>(y - m_range.first);
        double* row = m_rows[static_cast<size_t>(c)].data() + at * static_cast<size_t>(m_keptLength);
        const double change = radiance[c] - before[c];
        if (m_plans)
            m_dirichlet->add(row, static_cast<double>(x) / m_width, change / m_width);
        else
            row[x] = radiance[c];
        m_rowSquares[at][c] += change * (radiance[c] + before[c]);
    }
}

void setUnit(Spectrum& spectrum)
{
    const int height = spectrum.rings, width = spectrum.ringLength;
    const std::vector<double> theta = ringColatitudes(height);
    // A constant 1 on these rings holds orders that are multiples of the row's length only. Below the first of those it is zonal, and
    // its coefficients are a sum over the rows: of w_j P_l(cos theta_j), all rows at once, the northern half standing for both.
    constexpr int longest = 2048;
    const int zonalLimit = std::max(spectrum.bandLimit, std::min(width + width / 4, longest));
    std::vector<double> x, w;
    for (int j = 0; 2 * j < height; ++j) {
        x.push_back(std::cos(theta[static_cast<size_t>(j)]));
        w.push_back(2.0 * pi * bandHeight(j, height) * (2 * j + 1 == height ? 1.0 : 2.0));
    }
    std::vector<double> previous(x.size(), 0.0), p(x.size(), 1.0);
    for (int l = 0; l <= zonalLimit; ++l) {
        const double a = (2.0 * l + 1.0) / (l + 1.0), b = l / (l + 1.0);
        double sum = 0.0;
        for (size_t j = 0; j < x.size(); ++j) {
            sum += w[j] * p[j];
            const double next = a * x[j] * p[j] - b * previous[j];
            previous[j] = p[j];
            p[j] = next;
        }
        spectrum.zonalUnit.push_back(l % 2 == 0 ? std::sqrt((2.0 * l + 1.0) / (4.0 * pi)) * sum : 0.0); // odd ones cancel
    }
    spectrum.unit.assign(spectrum.index(spectrum.bandLimit, spectrum.bandLimit) + 1, Complex(0.0));
    for (int l = 0; l <= spectrum.bandLimit; ++l)
        spectrum.unit[spectrum.index(l, 0)] = spectrum.zonalUnit[static_cast<size_t>(l)];
}

Spectrum SpectrumBuilder::finish(const JobControl& job)
{
    const std::vector<double> theta = ringColatitudes(m_height);
    const std::vector<double> here(theta.begin() + m_range.first, theta.begin() + m_range.end);
    std::vector<double> weight;
    for (int j = m_range.first; j < m_range.end; ++j)
        weight.push_back(bandHeight(j, m_height) * 2.0 * pi / m_keptLength);

    Spectrum spectrum;
    spectrum.bandLimit = m_bandLimit;
    spectrum.rings = m_height;
    spectrum.ringLength = m_width;
    spectrum.peak = m_peak;
    spectrum.least = m_least;
    for (int j = m_range.first; j < m_range.end; ++j)
        spectrum.secondMoment += bandHeight(j, m_height) * 2.0 * pi / m_width * m_rowSquares[static_cast<size_t>(j - m_range.first)];
    const size_t count = spectrum.index(m_bandLimit, m_bandLimit) + 1;
    // The first sample of a truncated row keeps its texel's azimuth, half a texel of the full row.
    constexpr size_t largeCount = size_t{1} << 19;
    const std::vector<Geometry> blocks = ringBlocks(here, weight, m_keptLength, pi / m_width, count > largeCount ? 1 : 16);
    const Coefficients layout = triangle(m_bandLimit);
    for (auto& channel : spectrum.coefficients)
        channel.resize(count);
    fromRings(spectrum.coefficients, m_rows, blocks, layout, job);

    setUnit(spectrum);
    if (m_bandLimit >= m_width) { // what repeats along the rows
        assert(m_range == (RowRange{0, m_height}));
        const std::vector<Complex> zonal = std::exchange(spectrum.unit, std::vector<Complex>(count));
        std::vector<double> ones(m_rows[0].size(), 1.0);
        fromRings({&spectrum.unit, 1}, {&ones, 1}, blocks, layout, job);
        std::copy_n(zonal.begin(), m_bandLimit + 1, spectrum.unit.begin());
    }
    return spectrum;
}

Spectrum& Spectrum::operator+=(const Spectrum& other)
{
    assert(bandLimit == other.bandLimit && rings == other.rings && ringLength == other.ringLength);
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < coefficients[c].size(); ++i)
            coefficients[c][i] += other.coefficients[c][i];
    peak = std::max(peak, other.peak);
    least = std::min(least, other.least);
    secondMoment += other.secondMoment;
    return *this;
}

Spectrum analyze(const EnvironmentMap& latlong, int bandLimit, const JobControl& job)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("spectrum: the probe must be a latlong map; reproject it first");
    SpectrumBuilder builder(latlong.image.width, latlong.image.height, bandLimit);
    builder.addRows(0, latlong.image.height, latlong.image.texels.data(), job);
    return builder.finish(job);
}

FilteredRings synthesize(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& theta, int ringLength,
                         double phi0, const std::vector<Complex>& azimuthFactors, const JobControl& job, const std::vector<double>& longer)
{
    const int bandLimit = static_cast<int>(k.size()) - 1;
    assert(bandLimit <= spectrum.bandLimit && azimuthFactors.size() > static_cast<size_t>(bandLimit));
    const std::vector<Geometry> blocks = ringBlocks(theta, {}, ringLength, phi0);
    const Coefficients layout = triangle(bandLimit);
    Spectrum filtered; // only for its index
    filtered.bandLimit = bandLimit;
    std::vector<Complex> product(filtered.index(bandLimit, bandLimit) + 1);
    // @param mean  of the map: what is filtered is what differs from it
    const auto onRings = [&](const std::vector<Complex>& coefficients, double mean) {
        for (int m = 0; m <= bandLimit; ++m) {
            const Complex factor = azimuthFactors[static_cast<size_t>(m)];
            const Complex* from = coefficients.data() + spectrum.index(0, m);
            const Complex* unit = spectrum.unit.data() + spectrum.index(0, m);
            Complex* to = product.data() + filtered.index(0, m);
            if (m % spectrum.ringLength == 0)
                for (int l = m; l <= bandLimit; ++l)
                    to[l] = (from[l] - mean * unit[l]) * (factor * k[static_cast<size_t>(l)]);
            else
                for (int l = m; l <= bandLimit; ++l)
                    to[l] = from[l] * (factor * k[static_cast<size_t>(l)]);
        }
        product[0] = coefficients[0] * k[0];
        std::vector<double> map(theta.size() * static_cast<size_t>(ringLength));
        toRings(product, map, blocks, layout, job);
        return map;
    };

    FilteredRings rings;
    for (int c = 0; c < 3; ++c) {
        const std::vector<Complex>& channel = spectrum.coefficients[static_cast<size_t>(c)];
        rings.mean[c] = channel[0].real() / spectrum.unit[0].real();
        rings.rgb[static_cast<size_t>(c)] = onRings(channel, rings.mean[c]);
    }
    const std::vector<double> zonal = zonalNorm(spectrum, longer.empty() ? k : longer, theta);
    for (const double n : zonal)
        rings.norm.insert(rings.norm.end(), static_cast<size_t>(ringLength), n);
    if (bandLimit >= spectrum.ringLength) { // what repeats along the rows
        std::vector<Complex> repeating(spectrum.unit.size());
        for (int m = spectrum.ringLength; m <= bandLimit; m += spectrum.ringLength)
            for (int l = m; l <= bandLimit; ++l)
                repeating[spectrum.index(l, m)] = spectrum.unit[spectrum.index(l, m)];
        const std::vector<double> map = onRings(repeating, 0.0);
        for (size_t i = 0; i < map.size(); ++i)
            rings.norm[i] += map[i];
    }
    return rings;
}

int zonalNormLimit(const Spectrum& spectrum, const std::vector<double>& k)
{
    constexpr size_t cheap = 512;
    double rest = 0.0; // mean square of what is left out, relative to 1
    for (size_t l = std::min(k.size(), spectrum.zonalUnit.size()); l-- > 1;) {
        rest += k[l] * k[l] * spectrum.zonalUnit[l] * spectrum.zonalUnit[l] / (4.0 * pi);
        const double negligible = l <= cheap ? 1e-13 : negligibleNorm;
        if (rest > negligible * negligible)
            return static_cast<int>(l);
    }
    return 0;
}

std::vector<double> zonalNorm(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& theta)
{
    const auto last = static_cast<size_t>(zonalNormLimit(spectrum, k));
    std::vector<double> x, previous(theta.size(), 0.0), p(theta.size(), 1.0), norm(theta.size(), 0.0);
    for (const double t : theta)
        x.push_back(std::cos(t));
    for (size_t l = 0; l <= last; ++l)
        addLegendre(l, k[l] * std::sqrt((2.0 * static_cast<double>(l) + 1.0) / (4.0 * pi)) * spectrum.zonalUnit[l], x, previous, p, norm);
    return norm;
}

} // namespace mirrorball
