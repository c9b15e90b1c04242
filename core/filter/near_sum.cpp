#include "near_sum.h"

#include "core/base/multiversion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

constexpr int lanes = floatLanes;
using Lanes = FloatLanes;
using Wholes = IntLanes;
using Sums = LaneSums;
using Tables = NearSum::Tables;

/// What is the same for all texels of a row, as the loop over them takes it.
struct Row {
    float least = 0.0f, slope = 0.0f;             ///< u = least + slope sin^2
    float offsetSine = 0.0f, offsetCosine = 1.0f; ///< of d/2
    std::ptrdiff_t start = 0;                     ///< of the row in its planes
    float weight = 0.0f;
};

/// What is the same for all rows, in all lanes.
struct Constants {
    Lanes share[KernelSplit::mostPolynomialTerms], toUnit, steepness, reach;
};

/// Columns [x, x + count), which lie at `table` and after in the tables of sines.
template <size_t terms>
[[gnu::always_inline]] inline void addColumns(const Tables& t, const Constants& constants, const Row& row, int x, int table, int count,
                                              Sums& sums)
{
    const float *red = t.planes.channels[0].data() + row.start + x, *green = t.planes.channels[1].data() + row.start + x,
                *blue = t.planes.channels[2].data() + row.start + x, *sine = t.sine.data() + table, *cosine = t.cosine.data() + table;
    const Lanes* g = constants.share;
    const Lanes none{};
    const Wholes lane{0, 1, 2, 3, 4, 5, 6, 7};
    Lanes r{}, gr{}, b{}, one{};
    for (int i = 0; i < count; i += lanes) {
        const Lanes s = *reinterpret_cast<const Lanes*>(sine + i), c = *reinterpret_cast<const Lanes*>(cosine + i);
        const Lanes v = s * row.offsetCosine - c * row.offsetSine;
        const Lanes u = row.least + row.slope * (v * v);
        const Lanes y = 1.0f + constants.toUnit * u, y2 = y * y; // even and odd powers apart: neither waits for the other
        Lanes even = g[terms - 2], odd = g[terms - 1];
        for (size_t k = terms - 2; k > 0; k -= 2) {
            even = g[k - 2] + y2 * even;
            odd = g[k - 1] + y2 * odd;
        }
        const Lanes under = 1.0f + constants.steepness * u;
        const Lanes all = (1.0f - u) * (even + y * odd) / (under * under);
        const Lanes n = (u < constants.reach) & (lane < count - i) ? all : none;
        r += n * *reinterpret_cast<const Lanes*>(red + i);
        gr += n * *reinterpret_cast<const Lanes*>(green + i);
        b += n * *reinterpret_cast<const Lanes*>(blue + i);
        one += n;
    }
    sums.red += row.weight * r;
    sums.green += row.weight * gr;
    sums.blue += row.weight * b;
    sums.one += row.weight * one;
}

template <size_t terms>
[[gnu::always_inline]] inline glm::dvec4 sumAt(const Tables& t, const Constants& constants, double azimuth, double colatitude)
{
    const double rowHeight = pi / t.planes.height, columnWidth = 2.0 * pi / t.planes.width, turns = azimuth / (2.0 * pi);
    const double column = (turns - std::floor(turns)) * t.planes.width - 0.5;
    const int nearest = static_cast<int>(std::floor(column + 0.5));
    const double offset = 0.5 * columnWidth * (column - nearest);
    const double sine = std::sin(0.5 * colatitude), cosine = std::cos(0.5 * colatitude), across = 2.0 * sine * cosine;
    const int top = std::max(0, static_cast<int>(std::ceil((colatitude - t.reachAngle) / rowHeight - 0.5))),
              bottom = std::min(t.planes.height - 1, static_cast<int>(std::floor((colatitude + t.reachAngle) / rowHeight - 0.5)));
    Row row{.offsetSine = static_cast<float>(std::sin(offset)), .offsetCosine = static_cast<float>(std::cos(offset))};
    Sums sums;
    // What roots and quotients tell of the rows is found for some at once: vectors of the compiler's, and loops that do not wait for them.
    constexpr int some = 16;
    std::array<float, some> leasts, slopes;
    std::array<int, some> reaches; // columns to either side within the reach, and perhaps one more, which the comparison with it drops
    for (int first = top; first <= bottom; first += some) {
        const int rows = std::min(some, bottom + 1 - first);
        for (int i = 0; i < rows; ++i) {
            const auto y = static_cast<size_t>(first + i);
            const double between = sine * t.halfCosine[y] - cosine * t.halfSine[y], least = 2.0 * between * between,
                         slope = 2.0 * across * t.rowSine[y], square = (t.reach - least) / std::max(slope, 1e-30);
            const double s = std::sqrt(std::clamp(square, 0.0, 1.0)), half = 2.0 * (s + (0.5 * pi - 1.0) * s * s * s); // asin s is less
            leasts[static_cast<size_t>(i)] = static_cast<float>(least);
            slopes[static_cast<size_t>(i)] = static_cast<float>(slope);
            const int columns = static_cast<int>(half / columnWidth + 1.5);
            reaches[static_cast<size_t>(i)] = square < 0.0 ? -1 : columns;
        }
        for (int i = 0; i < rows; ++i) {
            const int y = first + i, columns = reaches[static_cast<size_t>(i)];
            if (columns < 0)
                continue;
            row.least = leasts[static_cast<size_t>(i)];
            row.slope = slopes[static_cast<size_t>(i)];
            row.start = y * t.planes.stride;
            row.weight = static_cast<float>(t.planes.solidAngles[static_cast<size_t>(y)]);
            const int left = std::min(t.planes.width / 2, columns), right = std::min((t.planes.width - 1) / 2, columns);
            int x = nearest - left, table = t.planes.width / 2 - left, count = left + right + 1;
            if (x < 0) {
                const int before = std::min(-x, count);
                addColumns<terms>(t, constants, row, x + t.planes.width, table, before, sums);
                x = 0;
                table += before;
                count -= before;
            }
            const int here = std::min(count, t.planes.width - x);
            addColumns<terms>(t, constants, row, x, table, here, sums);
            if (here < count)
                addColumns<terms>(t, constants, row, 0, table + here, count - here, sums);
        }
    }
    return sums.total(t.planes.scale) * t.peakOfLobe;
}

} // namespace

MIRRORBALL_CLONES // hot: some hundred texels for each place
    void
    nearSums(const Tables& tables, const SpherePoint* places, size_t count, double yaw, glm::dvec4* sums)
{
    const Lanes one = Lanes{} + 1.0f;
    Constants constants;
    for (size_t i = 0; i < std::size(constants.share); ++i)
        constants.share[i] = one * tables.share[i];
    constants.toUnit = one * static_cast<float>(-2.0 / tables.reach);
    constants.steepness = one * static_cast<float>(tables.steepness);
    constants.reach = one * static_cast<float>(tables.reach);
    for (size_t i = 0; i < count; ++i)
        sums[i] = tables.terms > KernelSplit::fewPolynomialTerms
                      ? sumAt<KernelSplit::mostPolynomialTerms>(tables, constants, places[i].azimuth + yaw, places[i].colatitude)
                      : sumAt<KernelSplit::fewPolynomialTerms>(tables, constants, places[i].azimuth + yaw, places[i].colatitude);
}

NearSum::NearSum(const EnvironmentMap& latlong, std::span<const BrightTexels::Change> changes, const KernelSplit& split,
                 const JobControl& job)
{
    Tables& t = m_tables;
    t.planes = FloatPlanes(latlong, changes, job);
    const int width = t.planes.width, height = t.planes.height;
    for (int j = 0; j < width + lanes; ++j) {
        const double half = pi / width * (j - width / 2);
        t.sine.push_back(static_cast<float>(std::sin(half)));
        t.cosine.push_back(static_cast<float>(std::cos(half)));
    }
    t.peakOfLobe = 1.0 / LobeShape(split.lobe()).integral();
    for (int y = 0; y < height; ++y) {
        const double theta = pi * (y + 0.5) / height;
        t.rowSine.push_back(std::sin(theta));
        t.halfSine.push_back(std::sin(0.5 * theta));
        t.halfCosine.push_back(std::cos(0.5 * theta));
    }
    const double alpha2 = split.lobe().alpha * split.lobe().alpha;
    t.reach = split.reach();
    t.reachAngle = split.reachAngle();
    t.steepness = 0.5 * (1.0 - alpha2) / alpha2;
    const std::vector<double> powers = split.sharePolynomial();
    t.terms = powers.size();
    for (size_t i = 0; i < t.terms; ++i)
        t.share[i] = static_cast<float>(powers[i]);
}

void NearSum::at(std::span<const SpherePoint> places, double yaw, glm::dvec4* sums) const
{
    nearSums(m_tables, places.data(), places.size(), yaw, sums);
}

double NearSum::texels(double reachAngle, int latlongWidth)
{
    const double share = std::pow(std::sin(0.5 * reachAngle), 2); // of the sphere
    // Rows near the poles are denser, and are met as often.
    return share * latlongWidth * (latlongWidth / 2.0) * (pi / 2);
}

} // namespace mirrorball
