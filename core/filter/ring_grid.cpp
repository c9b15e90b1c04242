#include "ring_grid.h"

#include "core/base/multiversion.h"
#include "core/image/latlong_positions.h"
#include "core/image/texel_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace mirrorball {

namespace {

constexpr int taps = 6;
constexpr int haloBefore = 3; ///< taps reach floor(p) - 2, and floor(p) may be -1 at the north pole
constexpr int haloAfter = 4;

/// Poles of the quintic B-spline's inverse filter (Unser 1999, table 1) and its gain, the product of (1 - z)(1 - 1/z).
constexpr std::array<double, 2> poles{-0.43057534709997, -0.04309628820326};

double splineGain()
{
    double gain = 1.0;
    for (const double z : poles)
        gain *= (1.0 - z) * (1.0 - 1.0 / z);
    return gain;
}

/// Points whose weights are found side by side.
constexpr size_t batch = 64;
using Weights = std::array<std::array<float, batch>, taps>;

/// Values of the six quintic B-splines that reach points at fractions t in [0, 1) past the third one.
inline void setSplineWeights(const std::array<float, batch>& fractions, Weights& weights)
{
    constexpr float scale = 1.0f / 120.0f;
    for (size_t i = 0; i < batch; ++i) {
        const float t = fractions[i];
        const float t2 = t * t, t3 = t2 * t, t4 = t2 * t2, t5 = t4 * t;
        const float s = 1.0f - t, s5 = s * s * s * s * s;
        weights[0][i] = scale * s5;
        weights[1][i] = scale * (26.0f - 50.0f * t + 20.0f * t2 + 20.0f * t3 - 20.0f * t4 + 5.0f * t5);
        weights[2][i] = scale * (66.0f - 60.0f * t2 + 30.0f * t4 - 10.0f * t5);
        weights[3][i] = scale * (26.0f + 50.0f * t + 20.0f * t2 - 20.0f * t3 - 20.0f * t4 + 10.0f * t5);
        weights[4][i] = scale * (1.0f + 5.0f * t + 10.0f * t2 + 10.0f * t3 + 5.0f * t4 - 5.0f * t5);
        weights[5][i] = scale * t5;
    }
}

/// Two neighboring samples of RGB and the norm as one vector of the compiler's; loads need no alignment.
typedef float TwoTexels __attribute__((vector_size(32), aligned(4), may_alias)); // an attribute that `using` cannot carry

constexpr int lanes = 8; ///< great circles filtered side by side
using Lanes = std::array<double, lanes>;

/// Turns samples on closed circles into spline coefficients, in place: a causal and an anticausal recursion for each pole, started
/// from the periodic sums that a run without beginning would have reached.
void prefilterCircles(std::vector<Lanes>& circle)
{
    const int n = static_cast<int>(circle.size());
    const double gain = splineGain();
    for (Lanes& s : circle)
        for (double& v : s)
            v *= gain;
    for (const double z : poles) {
        const int horizon = std::min(n, static_cast<int>(std::ceil(std::log(1e-18) / std::log(std::abs(z)))));
        const double closing = 1.0 / (1.0 - std::pow(z, n));
        Lanes start{};
        double power = closing;
        for (int i = 0; i < horizon; ++i, power *= z)
            for (size_t j = 0; j < lanes; ++j)
                start[j] += power * circle[static_cast<size_t>((n - i) % n)][j];
        circle[0] = start;
        for (int i = 1; i < n; ++i)
            for (size_t j = 0; j < lanes; ++j)
                circle[static_cast<size_t>(i)][j] += z * circle[static_cast<size_t>(i) - 1][j];

        start = {};
        power = -z * closing;
        for (int i = 0; i < horizon; ++i, power *= z)
            for (size_t j = 0; j < lanes; ++j)
                start[j] += power * circle[static_cast<size_t>((n - 1 + i) % n)][j];
        circle[static_cast<size_t>(n) - 1] = start;
        for (int i = n - 2; i >= 0; --i)
            for (size_t j = 0; j < lanes; ++j)
                circle[static_cast<size_t>(i)][j] = z * (circle[static_cast<size_t>(i) + 1][j] - circle[static_cast<size_t>(i)][j]);
    }
}

/// n rounded up to an even number of factors 2, 3 and 5.
int goodRings(int n)
{
    for (int rings = std::max(8, n + n % 2);; rings += 2) {
        int rest = rings;
        for (const int p : {2, 3, 5})
            while (rest % p == 0)
                rest /= p;
        if (rest == 1)
            return rings;
    }
}

/// The zonal norm from pole to pole, so dense that cubics between its places do, and one place beyond either pole.
std::vector<double> poleToPole(const Spectrum& spectrum, const std::vector<double>& k, int bandLimit)
{
    const size_t places = 16 * static_cast<size_t>(bandLimit) + 64;
    std::vector<double> north; // the southern half is its mirror image
    for (size_t i = 0; 2 * i <= places; ++i)
        north.push_back(pi * static_cast<double>(i) / static_cast<double>(places));
    north = zonalNorm(spectrum, k, north);
    std::vector<double> line{north[1]};
    for (size_t i = 0; i <= places; ++i)
        line.push_back(north[std::min(i, places - i)]);
    line.push_back(north[1]);
    return line;
}

constexpr double negligibleZonal = 1e-9; ///< beside 1, in a float

/// Lagrange's cubics through the four places about each interval of such a line.
std::vector<std::array<float, 4>> cubics(const std::vector<double>& line)
{
    std::vector<std::array<float, 4>> result;
    for (size_t i = 0; i + 3 < line.size(); ++i) {
        const double a = line[i], b = line[i + 1], c = line[i + 2], d = line[i + 3];
        result.push_back({static_cast<float>(b), static_cast<float>(c - a / 3.0 - b / 2.0 - d / 6.0), static_cast<float>((a + c) / 2.0 - b),
                          static_cast<float>((d - a) / 6.0 + (b - c) / 2.0)});
    }
    return result;
}

/// RingGrid::m_zonal and m_zonalBeyond.
/// @param longer  k followed further, for the norm
std::pair<std::vector<std::array<float, 4>>, std::vector<std::array<float, 4>>>
zonalLines(const Spectrum& spectrum, const std::vector<double>& k, const std::vector<double>& longer, int normLimit)
{
    std::vector<double> line = poleToPole(spectrum, longer, normLimit), beyond;
    if (normLimit >= static_cast<int>(k.size())) { // most norms end within the band limit
        const std::vector<double> within = poleToPole(spectrum, k, normLimit);
        for (size_t i = 0; i < within.size(); ++i)
            beyond.push_back(line[i] - within[i]);
    }
    for (double& value : line)
        value -= 1.0;
    const bool isFlat =
        beyond.empty() && std::all_of(line.begin(), line.end(), [](double value) { return std::abs(value) < negligibleZonal; });
    return {isFlat ? std::vector<std::array<float, 4>>() : cubics(line), cubics(beyond)};
}

/// Root mean square of what the rings get wrong of the zonal norm.
double zonalInterpolationError(const Spectrum& spectrum, const std::vector<double>& k, int rings)
{
    double lost = 0.0;
    for (size_t l = 1; l < std::min(k.size(), spectrum.zonalUnit.size()); ++l)
        lost += RingGrid::leakage(static_cast<int>(l), rings) * std::pow(k[l] * spectrum.zonalUnit[l], 2) / (4.0 * pi);
    return std::sqrt(lost);
}

} // namespace

int RingGrid::ringsFor(const std::vector<double>& share, double tolerance)
{
    const int bandLimit = static_cast<int>(share.size()) - 1;
    for (int rings = goodRings(bandLimit + 1);; rings = goodRings(rings + rings / 16 + 1))
        if (interpolationError(share, rings) <= tolerance)
            return rings;
}

int RingGrid::leastRings(int bandLimit) { return goodRings(bandLimit + 1); }

double RingGrid::leakage(int degree, int rings)
{
    // The strongest alias of a frequency x (in samples) that a spline of degree 5 lets through, (x/(1-x))^6; one from either side, along
    // the azimuth and along the meridian.
    const double x = static_cast<double>(degree) / (2.0 * rings), alias = x / (1.0 - x);
    const double alias4 = alias * alias * alias * alias;
    return 4.0 * alias4 * alias4 * alias4;
}

double RingGrid::interpolationError(const std::vector<double>& share, int rings)
{
    double lost = 0.0;
    for (size_t l = 0; l < share.size(); ++l)
        lost += leakage(static_cast<int>(l), rings) * share[l];
    return std::sqrt(lost);
}

RingGrid::RingGrid(const Spectrum& spectrum, const std::vector<double>& k, int rings, double yaw, const JobControl& job,
                   const std::vector<double>& longer)
    : m_rings(rings), m_stride(2 * rings + haloBefore + haloAfter)
{
    const int samples = 2 * rings;
    std::vector<double> theta(static_cast<size_t>(rings));
    for (int j = 0; j < rings; ++j)
        theta[static_cast<size_t>(j)] = pi * (j + 0.5) / rings;
    std::vector<std::complex<double>> azimuth(k.size());
    for (size_t i = 0; i < k.size(); ++i) {
        const double m = static_cast<double>(i), w = 2.0 * pi * m / samples;
        // Azimuth runs against longitude, so turning the map by +yaw is a shift by -yaw along it.
        azimuth[i] = std::polar(120.0 / (66.0 + 52.0 * std::cos(w) + 2.0 * std::cos(2.0 * w)), m * yaw);
    }
    FilteredRings filtered = synthesize(spectrum, k, theta, samples, 0.0, azimuth, job);
    m_mean = glm::vec3(filtered.mean);
    // The zonal norm repeats with the probe's rows, which may be finer than the rings: then it has a line of samples of its own.
    const std::vector<double>& factors = longer.empty() ? k : longer;
    const int normLimit = zonalNormLimit(spectrum, factors);
    const bool hasLine = normLimit >= static_cast<int>(k.size()) || zonalInterpolationError(spectrum, k, rings) > negligibleZonal;
    const std::vector<double> zonal = hasLine ? zonalNorm(spectrum, k, theta) : std::vector<double>(theta.size(), 1.0);
    for (size_t i = 0; i < filtered.norm.size(); ++i) {
        // In doubles: beside a sun the mean times this is many times what is left in the dark.
        for (int c = 0; c < 3; ++c)
            filtered.rgb[static_cast<size_t>(c)][i] += filtered.mean[c] * (filtered.norm[i] - 1.0);
        filtered.norm[i] -= zonal[i / static_cast<size_t>(samples)];
    }
    if (hasLine)
        std::tie(m_zonal, m_zonalBeyond) = zonalLines(spectrum, k, factors, normLimit);

    m_texels.resize(4 * static_cast<size_t>(rings + haloBefore + haloAfter) * static_cast<size_t>(m_stride));
    const auto at = [&](int row, int x) {
        return m_texels.data() +
               4 * (static_cast<size_t>(row + haloBefore) * static_cast<size_t>(m_stride) + static_cast<size_t>(x + haloBefore));
    };
    const int blocks = (rings + lanes - 1) / lanes;
    parallelRows(
        blocks, job,
        [&](int first, int last) {
            std::vector<Lanes> circle(static_cast<size_t>(samples));
            for (int block = first; block < last; ++block) {
                const int x0 = block * lanes, width = std::min(lanes, rings - x0);
                for (int c = 0; c < 4; ++c) {
                    const double* map = (c < 3 ? filtered.rgb[static_cast<size_t>(c)] : filtered.norm).data();
                    // Down the meridian at x, then up the one opposite to it.
                    for (int i = 0; i < samples; ++i) {
                        const double* row = map + static_cast<size_t>(i < rings ? i : samples - 1 - i) * static_cast<size_t>(samples) +
                                            (i < rings ? 0 : rings) + x0;
                        for (int j = 0; j < width; ++j)
                            circle[static_cast<size_t>(i)][static_cast<size_t>(j)] = row[j];
                    }
                    prefilterCircles(circle);
                    for (int i = -haloBefore; i < rings + haloAfter; ++i)
                        for (int j = 0; j < width; ++j) {
                            const auto lane = static_cast<size_t>(j);
                            at(i, x0 + j)[c] = static_cast<float>(circle[static_cast<size_t>((i + samples) % samples)][lane]);
                            at(i, x0 + j + rings)[c] =
                                static_cast<float>(circle[static_cast<size_t>((2 * samples - 1 - i) % samples)][lane]);
                        }
                }
            }
        },
        4);
    for (int row = -haloBefore; row < rings + haloAfter; ++row) {
        for (int x = -haloBefore; x < 0; ++x)
            std::copy_n(at(row, x + samples), 4, at(row, x));
        for (int x = samples; x < samples + haloAfter; ++x)
            std::copy_n(at(row, x - samples), 4, at(row, x));
    }
}

MIRRORBALL_CLONES // the loop over taps is the hot one of every export
    void
    interpolate(const float* texels, int stride, double perRadian, std::span<const SpherePoint> points, float* rgbn)
{
    std::array<float, batch> fractionX{}, fractionY{};
    std::array<int, batch> corner{};
    Weights wx, wy;
    for (size_t first = 0; first < points.size(); first += batch) {
        const size_t count = std::min(batch, points.size() - first);
        for (size_t i = 0; i < count; ++i) {
            const double x = points[first + i].azimuth * perRadian, y = points[first + i].colatitude * perRadian + 0.5; // one row down
            const int floorX = static_cast<int>(x), floorY = static_cast<int>(y); // neither is negative
            fractionX[i] = static_cast<float>(x - floorX);
            fractionY[i] = static_cast<float>(y - floorY);
            corner[i] = (floorY - 3 + haloBefore) * stride + floorX - 2 + haloBefore;
        }
        setSplineWeights(fractionX, wx);
        setSplineWeights(fractionY, wy);
        for (size_t i = 0; i < count; ++i) {
            const float* row = texels + 4 * static_cast<ptrdiff_t>(corner[i]);
            TwoTexels sum01{}, sum23{}, sum45{};
            for (size_t j = 0; j < taps; ++j, row += 4 * static_cast<ptrdiff_t>(stride)) {
                const auto* pair = reinterpret_cast<const TwoTexels*>(row);
                sum01 += wy[j][i] * pair[0];
                sum23 += wy[j][i] * pair[1];
                sum45 += wy[j][i] * pair[2];
            }
            const float a = wx[0][i], b = wx[1][i], c = wx[2][i], d = wx[3][i], e = wx[4][i], f = wx[5][i];
            const TwoTexels sum = TwoTexels{a, a, a, a, b, b, b, b} * sum01 + TwoTexels{c, c, c, c, d, d, d, d} * sum23 +
                                  TwoTexels{e, e, e, e, f, f, f, f} * sum45;
            for (size_t k = 0; k < 4; ++k)
                *rgbn++ = sum[k] + sum[k + 4];
        }
    }
}

/// Adds what lines hold, their intervals so many to a radian: the first to the fourth channel, the second, where there is one, times the
/// mean to the others.
MIRRORBALL_CLONES // hot as well
    void
    addLines(std::span<const std::array<float, 4>> zonal, std::span<const std::array<float, 4>> beyond, const glm::vec3& mean,
             double perRadian, std::span<const SpherePoint> points, float* rgbn)
{
    const int last = static_cast<int>(zonal.size()) - 1;
    for (const SpherePoint& p : points) {
        const double at = p.colatitude * perRadian;
        const int i = std::min(static_cast<int>(at), last); // it is not negative
        const auto t = static_cast<float>(at - i);
        const std::array<float, 4>& a = zonal[static_cast<size_t>(i)];
        rgbn[3] += a[0] + t * (a[1] + t * (a[2] + t * a[3]));
        if (!beyond.empty()) {
            const std::array<float, 4>& b = beyond[static_cast<size_t>(i)];
            const float more = b[0] + t * (b[1] + t * (b[2] + t * b[3]));
            rgbn[0] += mean.r * more;
            rgbn[1] += mean.g * more;
            rgbn[2] += mean.b * more;
        }
        rgbn += 4;
    }
}

void RingGrid::read(std::span<const SpherePoint> points, float* rgbn) const
{
    interpolate(m_texels.data(), m_stride, m_rings / pi, points, rgbn);
    if (!m_zonal.empty())
        addLines(m_zonal, m_zonalBeyond, m_mean, static_cast<double>(m_zonal.size()) / pi, points, rgbn);
}

namespace {
constexpr std::array<size_t, 4> sideFaces{0, 1, 4, 5}; ///< among a cube's faces
constexpr size_t sides = sideFaces.size();
} // namespace

/// What rows of rings give at azimuths, at most `batch` of them; for each azimuth one row after the other.
MIRRORBALL_CLONES // hot as well
    void
    readMeridians(const float* texels, int stride, double perRadian, int rows, std::span<const SpherePoint> points, float* rgbn)
{
    std::array<float, batch> fraction{};
    std::array<int, batch> corner{};
    Weights w;
    for (size_t i = 0; i < points.size(); ++i) {
        const double x = points[i].azimuth * perRadian;
        const int floorX = static_cast<int>(x); // it is not negative
        fraction[i] = static_cast<float>(x - floorX);
        corner[i] = floorX - 2 + haloBefore;
    }
    setSplineWeights(fraction, w);
    for (size_t i = 0; i < points.size(); ++i) {
        const float a = w[0][i], b = w[1][i], c = w[2][i], d = w[3][i], e = w[4][i], f = w[5][i];
        const TwoTexels ab{a, a, a, a, b, b, b, b}, cd{c, c, c, c, d, d, d, d}, ef{e, e, e, e, f, f, f, f};
        const float* row = texels + 4 * static_cast<ptrdiff_t>(corner[i]);
        for (int j = 0; j < rows; ++j, row += 4 * static_cast<ptrdiff_t>(stride)) {
            const auto* pair = reinterpret_cast<const TwoTexels*>(row);
            const TwoTexels sum = ab * pair[0] + cd * pair[1] + ef * pair[2];
            for (size_t k = 0; k < 4; ++k)
                *rgbn++ = sum[k] + sum[k + 4];
        }
    }
}

/// Along such meridians, those of a side after those of another, at colatitudes that the sides share.
/// @param top   row of the rings' coefficients that the meridians begin with
/// @param more  4 floats a place that are added on every side
MIRRORBALL_CLONES // hot as well
    void
    readAlongMeridians(const float* meridians, int top, int rows, double perRadian, std::span<const SpherePoint> points, const float* more,
                       const std::array<float*, sides>& rgbn)
{
    std::array<float, batch> fraction{};
    std::array<int, batch> corner{};
    Weights w;
    for (size_t i = 0; i < points.size(); ++i) {
        const double y = points[i].colatitude * perRadian + 0.5;
        const int floorY = static_cast<int>(y);
        fraction[i] = static_cast<float>(y - floorY);
        corner[i] = floorY - 3 + haloBefore - top;
    }
    setSplineWeights(fraction, w);
    const size_t line = 4 * static_cast<size_t>(rows);
    for (size_t i = 0; i < points.size(); ++i) {
        const float a = w[0][i], b = w[1][i], c = w[2][i], d = w[3][i], e = w[4][i], f = w[5][i];
        const TwoTexels ab{a, a, a, a, b, b, b, b}, cd{c, c, c, c, d, d, d, d}, ef{e, e, e, e, f, f, f, f};
        for (size_t side = 0; side < sides; ++side) {
            const float* from = meridians + (side * batch + i) * line + 4 * static_cast<ptrdiff_t>(corner[i]);
            const auto* pair = reinterpret_cast<const TwoTexels*>(from);
            const TwoTexels sum = ab * pair[0] + cd * pair[1] + ef * pair[2];
            for (size_t k = 0; k < 4; ++k)
                rgbn[side][4 * i + k] = sum[k] + sum[k + 4] + more[4 * i + k];
        }
    }
}

void RingGrid::readSides(int size, int first, int last, std::span<const SpherePoint> points, float* rgbn) const
{
    const double perRadian = m_rings / pi;
    const auto width = static_cast<size_t>(size);
    const auto place = [&](size_t side, int row, size_t column) {
        return (sideFaces[side] * width + static_cast<size_t>(row)) * width + column;
    };
    const auto corner = [&](const SpherePoint& p) { return static_cast<int>(p.colatitude * perRadian + 0.5) - 3 + haloBefore; };
    const auto of = points.subspan(place(0, first, 0), static_cast<size_t>(last - first) * width);
    const auto [highest, lowest] =
        std::minmax_element(of.begin(), of.end(), [](const SpherePoint& a, const SpherePoint& b) { return a.colatitude < b.colatitude; });
    const int top = corner(*highest), rows = corner(*lowest) + taps - top;
    std::vector<float> meridians(sides * batch * 4 * static_cast<size_t>(rows)), more(4 * batch);
    for (size_t left = 0; left < width; left += batch) {
        const size_t count = std::min(batch, width - left);
        for (size_t side = 0; side < sides; ++side)
            readMeridians(m_texels.data() + 4 * static_cast<ptrdiff_t>(top) * m_stride, m_stride, perRadian, rows,
                          points.subspan(place(side, first, left), count), meridians.data() + side * batch * 4 * static_cast<size_t>(rows));
        for (int row = first; row < last; ++row) {
            const auto shared = points.subspan(place(0, row, left), count);
            if (!m_zonal.empty()) {
                std::fill(more.begin(), more.end(), 0.0f);
                addLines(m_zonal, m_zonalBeyond, m_mean, static_cast<double>(m_zonal.size()) / pi, shared, more.data());
            }
            std::array<float*, sides> to{};
            for (size_t side = 0; side < sides; ++side)
                to[side] = rgbn + 4 * ((side * static_cast<size_t>(last - first) + static_cast<size_t>(row - first)) * width + left);
            readAlongMeridians(meridians.data(), top, rows, perRadian, shared, more.data(), to);
        }
    }
}

std::vector<SpherePoint> spherePoints(const MapLayout& layout, const JobControl& job)
{
    const int width = layout.width(), height = layout.height();
    const int chart = layout.chartWidth();
    std::vector<SpherePoint> points(static_cast<size_t>(width) * static_cast<size_t>(height));
    const TexelOutlines places(layout, 0.0, glm::dmat3(1.0), MapCharts(layout));
    parallelRows(height, job, [&](int first, int last) {
        const auto count = static_cast<size_t>(chart);
        std::vector<double> x(count), y(count), z(count), azimuth(count), colatitude(count);
        for (int row = first; row < last; ++row)
            for (int left = 0; left < width; left += chart) {
                places.directions(left, row, {.first = {left + 0.5, row + 0.5}, .step = {1.0, 1.0}, .columns = chart, .rows = 1}, x.data(),
                                  y.data(), z.data());
                latlongCoordinates(1, count, x.data(), y.data(), z.data(), azimuth.data(), colatitude.data()); // in half turns
                SpherePoint* to = points.data() + static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(left);
                for (size_t i = 0; i < count; ++i)
                    to[i] = {.azimuth = pi * azimuth[i], .colatitude = pi * colatitude[i]};
            }
    });
    return points;
}

} // namespace mirrorball
