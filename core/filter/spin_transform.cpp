#include "spin_transform.h"

#include "core/base/multiversion.h"
#include "core/base/open_mp.h"
#include "core/sphere/direction.h"

#include <libsharp/sharp.h>
#include <libsharp/sharp_almhelpers.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorball {

namespace {

using Complex = std::complex<double>;

struct GeometryDeleter {
    void operator()(sharp_geom_info* p) const { sharp_destroy_geom_info(p); }
};
struct CoefficientsDeleter {
    void operator()(sharp_alm_info* p) const { sharp_destroy_alm_info(p); }
};

std::unique_ptr<sharp_geom_info, GeometryDeleter> geometryOf(const RingSet& rings, int length)
{
    const size_t n = rings.colatitude.size();
    const std::vector<int> lengths(n, length), strides(n, 1);
    std::vector<ptrdiff_t> offsets(n);
    std::vector<double> theta(n);
    for (size_t i = 0; i < n; ++i) {
        offsets[i] = static_cast<ptrdiff_t>(i) * length;
        theta[i] = std::clamp(rings.colatitude[i], 1e-9, pi - 1e-9); // the frame of the meridian is there up to the pole, not at it
    }
    sharp_geom_info* info = nullptr;
    sharp_make_geom_info(static_cast<int>(n), lengths.data(), offsets.data(), strides.data(), rings.azimuth.data(), theta.data(), nullptr,
                         &info);
    return std::unique_ptr<sharp_geom_info, GeometryDeleter>(info);
}

} // namespace

OrderHarmonics::OrderHarmonics(int m, int bandLimit) : m_order(m), m_diagonal(std::sqrt(1.0 / (4.0 * pi)))
{
    for (int i = 1; i <= m; ++i)
        m_diagonal *= std::sqrt((2.0 * i + 1.0) / (2.0 * i));
    m_a.resize(static_cast<size_t>(bandLimit) + 1);
    m_b.resize(m_a.size());
    const double m2 = static_cast<double>(m) * m;
    for (int l = m + 1; l <= bandLimit; ++l) {
        const double d = l, e = l - 1;
        m_a[static_cast<size_t>(l)] = std::sqrt((4.0 * d * d - 1.0) / (d * d - m2));
        m_b[static_cast<size_t>(l)] = std::sqrt((e * e - m2) / (4.0 * e * e - 1.0));
    }
}

// Upwards in l from lambda_mm, stable for every m. Far from the diagonal the values are below the smallest double and stay 0.
void OrderHarmonics::at(double gamma, std::span<double> lambda) const
{
    const double x = std::cos(gamma);
    const auto first = static_cast<size_t>(m_order);
    std::fill(lambda.begin(), lambda.end(), 0.0);
    if (first >= lambda.size())
        return;
    double before = 0.0, current = m_diagonal * std::pow(std::sin(gamma), m_order);
    lambda[first] = current;
    for (size_t l = first + 1; l < lambda.size(); ++l) {
        const double next = m_a[l] * (x * current - m_b[l] * before);
        before = current;
        current = next;
        lambda[l] = current;
    }
}

// Several angles at a time: one recurrence waits for itself.
MIRRORBALL_CLONES void OrderHarmonics::addSums(std::span<const double> gamma, std::span<const double> scale, std::span<double> sums) const
{
    constexpr size_t block = 16;
    const auto diagonal = static_cast<size_t>(m_order);
    for (size_t first = 0; first < gamma.size() && diagonal < sums.size(); first += block) {
        double x[block] = {}, before[block] = {}, now[block] = {}; // those past the end stay 0
        for (size_t j = 0; j < block && first + j < gamma.size(); ++j) {
            x[j] = std::cos(gamma[first + j]);
            now[j] = scale[first + j] * m_diagonal * std::pow(std::sin(gamma[first + j]), m_order);
        }
        for (size_t l = diagonal; l < sums.size(); ++l) {
            double sum = 0.0;
            const bool isLast = l + 1 == sums.size();
            const double a = isLast ? 0.0 : m_a[l + 1], b = isLast ? 0.0 : m_b[l + 1];
#pragma omp simd reduction(+ : sum)
            for (size_t j = 0; j < block; ++j) {
                sum += now[j];
                const double next = a * (x[j] * now[j] - b * before[j]);
                before[j] = now[j];
                now[j] = next;
            }
            sums[l] += sum;
        }
    }
}

OrderMap synthesizeOrder(const Spectrum& spectrum, int channel, int m, std::span<const double> k, const RingSet& rings,
                         const JobControl& job)
{
    job.checkStop();
    const int bandLimit = static_cast<int>(k.size()) - 1;
    assert(bandLimit <= spectrum.bandLimit);
    const auto& from = channel < 3 ? spectrum.coefficients[static_cast<size_t>(channel)] : spectrum.unit;
    const bool isZonal = channel == 3 && bandLimit < spectrum.ringLength;
    // Of a ring of one sample libsharp makes a wrong one where there are orders to alias: a single place is the first of two.
    const int length = isZonal ? 1 : std::max(rings.length, 2);

    // libsharp's pair of maps of spin m for a gradient alone, a_lm of the second component 0.
    std::vector<ptrdiff_t> starts;
    const int orders = isZonal ? 0 : bandLimit;
    ptrdiff_t count = 0;
    for (int order = 0; order <= orders; ++order) {
        starts.push_back(count - order);
        count += bandLimit - order + 1;
    }
    sharp_alm_info* info = nullptr;
    sharp_make_alm_info(bandLimit, orders, 1, starts.data(), &info);
    const std::unique_ptr<sharp_alm_info, CoefficientsDeleter> layout(info);
    std::vector<Complex> gradient(static_cast<size_t>(count)), curl(m > 0 ? static_cast<size_t>(count) : 0);
    for (int order = 0; order <= orders; ++order)
        for (int l = std::max(order, m); l <= bandLimit; ++l)
            gradient[static_cast<size_t>(starts[static_cast<size_t>(order)] + l)] =
                from[spectrum.index(l, order)] * k[static_cast<size_t>(l)];

    const auto geometry = geometryOf(rings, length);
    OrderMap map;
    map.real.resize(rings.colatitude.size() * static_cast<size_t>(length));
    map.imaginary.resize(m > 0 ? map.real.size() : 0);
    Complex* alm[] = {gradient.data(), curl.data()};
    double* texels[] = {map.real.data(), map.imaginary.data()};
    {
        const OpenMpThreads threads(job.threadCount());
        sharp_execute(SHARP_ALM2MAP, m, alm, texels, geometry.get(), layout.get(), SHARP_DP, nullptr, nullptr);
    }
    // libsharp's gradient is the negative one, and its second map runs with the rows of the map like phi does.
    if (m > 0)
        for (double& value : map.real)
            value = -value;
    if (!isZonal && rings.length == 1)
        for (auto* values : {&map.real, &map.imaginary}) {
            for (size_t i = 0; 2 * i < values->size(); ++i)
                (*values)[i] = (*values)[2 * i];
            values->resize(values->size() / 2);
        }
    return map;
}

} // namespace mirrorball
