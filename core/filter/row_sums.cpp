#include "row_sums.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mirrorball {

namespace {

constexpr int largestDegree = 3;

std::optional<int> degreeOf(const Lobe& lobe)
{
    if (lobe.kind == LobeKind::Diffuse || (lobe.kind == LobeKind::Ggx && lobe.alpha == 1.0))
        return 1;
    if (lobe.kind == LobeKind::Phong && lobe.exponent >= 0.0 && lobe.exponent <= largestDegree &&
        lobe.exponent == std::floor(lobe.exponent))
        return static_cast<int>(lobe.exponent);
    return std::nullopt;
}

/// cos(m t) and sin(m t), m = 0 .. 3.
struct Harmonics {
    std::array<double, largestDegree + 1> cosine{}, sine{};

    explicit Harmonics(double t)
    {
        for (int m = 0; m <= largestDegree; ++m) {
            cosine[static_cast<size_t>(m)] = std::cos(m * t);
            sine[static_cast<size_t>(m)] = std::sin(m * t);
        }
    }
};

/// (b + a cos t)^n as a sum of f_m cos(m t).
std::array<double, largestDegree + 1> cosineSeries(int n, double a, double b)
{
    switch (n) {
    case 0:
        return {1.0, 0.0, 0.0, 0.0};
    case 1:
        return {b, a, 0.0, 0.0};
    case 2:
        return {b * b + 0.5 * a * a, 2.0 * a * b, 0.5 * a * a, 0.0};
    default:
        return {b * b * b + 1.5 * a * a * b, 3.0 * a * b * b + 0.75 * a * a * a, 1.5 * a * a * b, 0.25 * a * a * a};
    }
}

/// Running sums along one row of a map: of R, G, B and 1 of its texels, each times the harmonics of their longitude.
class Row {
public:
    Row(int width, int degree)
        : m_width(width), m_terms(static_cast<size_t>(2 * degree + 1)), m_sums((static_cast<size_t>(width) + 1) * m_terms)
    {
    }

    void fill(const float* rgb, const std::vector<Harmonics>& columns)
    {
        std::array<double, 4>* at = m_sums.data();
        std::fill_n(at, m_terms, std::array<double, 4>{});
        for (const Harmonics& h : columns) {
            const std::array<double, 4> value{rgb[0], rgb[1], rgb[2], 1.0};
            for (size_t t = 0; t < m_terms; ++t) {
                const double factor = t % 2 == 1 ? h.sine[(t + 1) / 2] : h.cosine[t / 2];
                for (size_t c = 0; c < 4; ++c)
                    at[m_terms + t][c] = at[t][c] + factor * value[c];
            }
            at += m_terms;
            rgb += 3;
        }
    }

    /// Adds weight * sum over the texels [from, to) of factor[t] times term t; both lie in [0, width].
    void add(int from, int to, const std::array<double, 2 * largestDegree + 1>& factor, double weight, std::array<double, 4>& sum) const
    {
        const std::array<double, 4>*low = m_sums.data() + static_cast<size_t>(from) * m_terms,
                                 *high = m_sums.data() + static_cast<size_t>(to) * m_terms;
        for (size_t t = 0; t < m_terms; ++t)
            for (size_t c = 0; c < 4; ++c)
                sum[c] += weight * factor[t] * (high[t][c] - low[t][c]);
    }

    int width() const { return m_width; }

private:
    int m_width;
    size_t m_terms; ///< 1, sin t, cos t, sin 2t, cos 2t, ...
    std::vector<std::array<double, 4>> m_sums;
};

/// A direction, as the sums need it.
struct Lookup {
    double height, radius;       ///< r.y and the distance from the axis
    double sine, cosine;         ///< r.x, r.z
    double column;               ///< where it lies along the rows, in texels
    Harmonics azimuth;           ///< of its longitude
    std::array<double, 4> sum{}; ///< R, G, B, 1

    Lookup(const glm::dvec3& r, int width)
        : height(r.y), radius(std::sqrt(r.x * r.x + r.z * r.z)), sine(r.x), cosine(r.z),
          column((pi - std::atan2(r.x, r.z)) * width / (2.0 * pi)), azimuth(std::atan2(r.x, r.z))
    {
    }
};

class Sums {
public:
    Sums(const Image& image, int degree) : m_image(image), m_degree(degree)
    {
        for (int x = 0; x < image.width; ++x)
            m_columns.emplace_back(pi - 2.0 * pi * (x + 0.5) / image.width);
    }

    void run(std::span<const glm::dvec3> directions, glm::dvec3* result) const
    {
        std::vector<Lookup> lookups;
        for (const glm::dvec3& r : directions)
            lookups.emplace_back(r, m_image.width);
        Row row(m_image.width, m_degree);
        for (int y = 0; y < m_image.height; ++y) {
            const double latitude = pi / 2 - pi * (y + 0.5) / m_image.height, s = std::sin(latitude), c = std::cos(latitude);
            row.fill(m_image.row(y), m_columns);
            for (Lookup& lookup : lookups)
                add(row, s, c, lookup);
        }
        for (const Lookup& lookup : lookups)
            *result++ = glm::dvec3(lookup.sum[0], lookup.sum[1], lookup.sum[2]) / lookup.sum[3];
    }

private:
    void add(const Row& row, double s, double c, Lookup& r) const
    {
        const int width = row.width();
        const double a = c * r.radius, b = s * r.height;
        if (b <= -a)
            return;
        const auto f = cosineSeries(m_degree, a, b);
        std::array<double, 2 * largestDegree + 1> factor{f[0]};
        for (size_t m = 1; m <= static_cast<size_t>(m_degree); ++m) { // cos m(lon - lon_r)
            factor[2 * m - 1] = f[m] * r.azimuth.sine[m];
            factor[2 * m] = f[m] * r.azimuth.cosine[m];
        }
        if (b >= a) {
            row.add(0, width, factor, c, r.sum);
            return;
        }
        const double half = std::acos(-b / a) * width / (2.0 * pi);
        int from = static_cast<int>(std::ceil(r.column - half - 0.5)), to = static_cast<int>(std::floor(r.column + half - 0.5)) + 1;
        // A texel on the horizon counts where the sum over all texels would count it.
        const auto isSeen = [&](int x) {
            const Harmonics& h = m_columns[static_cast<size_t>((x % width + width) % width)];
            return b + c * (r.sine * h.sine[1] + r.cosine * h.cosine[1]) > 0.0;
        };
        from += isSeen(from) ? -(isSeen(from - 1) ? 1 : 0) : 1;
        to += isSeen(to - 1) ? (isSeen(to) ? 1 : 0) : -1;
        to = std::min(to, from + width);
        if (to <= from)
            return;
        const int turn = from < 0 ? width : from >= width ? -width : 0;
        from += turn;
        to += turn;
        row.add(from, std::min(to, width), factor, c, r.sum);
        if (to > width)
            row.add(0, to - width, factor, c, r.sum);
    }

    const Image& m_image;
    int m_degree;
    std::vector<Harmonics> m_columns{};
};

} // namespace

bool isShortPolynomial(const Lobe& lobe) { return degreeOf(lobe).has_value(); }

std::vector<glm::dvec3> rowSums(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                const JobControl& job)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("direct: the probe must be a latlong map; reproject it first");
    const std::optional<int> degree = degreeOf(lobe);
    if (!degree)
        throw InvalidArgument("direct: lobe " + describe(lobe) + " is no polynomial of degree 3 or less; sum over its texels");
    const Sums sums(latlong.image, *degree);
    std::vector<glm::dvec3> result(directions.size());
    // Blocks so large that filling a row's running sums anew for each costs little.
    const int count = static_cast<int>(directions.size()), block = std::max(latlong.image.width, 256);
    parallelRows((count + block - 1) / block, job,
                 [&](int first, int last) {
                     for (int i = first; i < last; ++i) {
                         const auto from = static_cast<size_t>(i) * static_cast<size_t>(block);
                         const size_t length = std::min(static_cast<size_t>(block), directions.size() - from);
                         sums.run(directions.subspan(from, length), result.data() + from);
                     }
                 },
                 1);
    return result;
}

double rowSumsSeconds(int latlongWidth, int directions)
{
    const double rows = latlongWidth / 2.0, block = std::max(latlongWidth, 256);
    return rows * (4e-8 * directions + 2e-8 * latlongWidth * std::ceil(directions / block));
}

} // namespace mirrorball
