#include "reproject.h"

#include "core/base/error.h"
#include "mip_pyramid.h"
#include "spline_lookup.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mirrorball {

namespace {

/// The angle that a texel subtends at p, as the side of a square of its solid angle. For a latlong its height, and for an angular map its
/// radial length: the slivers at the poles and the rim are no finer than that in the other direction.
double texelAngle(const MapLayout& layout, const glm::dvec2& p)
{
    if (layout.kind == Parameterization::Latlong)
        return pi / layout.size;
    if (layout.kind == Parameterization::Angular)
        return 2.0 * pi / layout.size;
    const double omega = density(layout, p);
    return omega > 0.0 ? std::sqrt(omega) : 4.0 / layout.size; // outside a disc
}

/// The angles across the texel at p along x and along y, through its middle.
glm::dvec2 texelExtent(const MapLayout& layout, const glm::dvec2& p)
{
    const glm::dvec3 d = direction(layout, p);
    const auto along = [&](const glm::dvec2& half) {
        return glm::distance(direction(layout, p + half), d) + glm::distance(d, direction(layout, p - half));
    };
    return {along({0.4999, 0.0}), along({0.0, 0.4999})}; // not on to the next face of the image
}

class Resampler {
public:
    Resampler(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job)
        : m_source(source), m_target(options.target), m_yaw(options.yaw), m_turns(options.turn != glm::dmat3(1.0)),
          m_back(glm::transpose(options.turn))
    {
        // A coarse look at the target: its smallest texel, and where one is largest against the source's.
        double smallest = 1e9, largestSource = 0.0;
        const int step = std::max(1, m_target.size / 32);
        for (int y = 0; y < m_target.height(); y += step)
            for (int x = 0; x < m_target.width(); x += step) {
                const glm::dvec2 p{x + 0.5, y + 0.5};
                const double sourceAngle = this->sourceAngle(sourceDirection(p));
                smallest = std::min(smallest, texelAngle(m_target, p));
                largestSource = std::max(largestSource, sourceAngle);
                const glm::dvec2 extent = texelExtent(m_target, p);
                m_magnifies = m_magnifies && std::max(extent.x, extent.y) <= 1.05 * sourceAngle;
            }
        if (m_magnifies)
            return;
        // One level for the whole map: where two met, a sun on the border would be counted a little more or less than once.
        const double ratio = smallest / largestSource;
        if (ratio < 1.0 || source.layout.size < 4) {
            m_smooth = smoothedPoles(source);
            return;
        }
        m_level = std::max(0, static_cast<int>(std::floor(std::log2(0.75 * ratio))));
        if (m_level == 0) {
            m_spline.emplace(source);
            return;
        }
        MipPyramid pyramid = buildMipPyramid(source, job);
        m_level = std::min(m_level, static_cast<int>(pyramid.levels.size()) - 1);
        while (pyramid.levels[static_cast<size_t>(m_level)].layout.size < 4) // what the spline needs
            --m_level;
        m_spline.emplace(std::move(pyramid.levels[static_cast<size_t>(m_level)]));
    }

    glm::vec3 texel(int x, int y) const
    {
        const glm::dvec2 centre{x + 0.5, y + 0.5};
        const glm::dvec3 d = sourceDirection(centre);
        if (const float* same = m_turns ? texelAt(d) : nullptr)
            return {same[0], same[1], same[2]};
        if (m_magnifies)
            return m_source.radiance(d);
        const glm::dvec2 ratio = texelExtent(m_target, centre) / sourceAngle(d);
        if (m_spline) {
            const double samples = isPolar(d, y) ? 8.0 : 2.0; // per texel of the level
            return mean(x, y, samples * std::ldexp(1.0, -m_level) * ratio, [this](const glm::dvec3& s) { return m_spline->radiance(s); });
        }
        if (std::max(ratio.x, ratio.y) <= 1.05)
            return m_source.radiance(d);
        return mean(x, y, 2.0 * ratio, [this](const glm::dvec3& s) { return m_smooth->radiance(s); });
    }

private:
    static constexpr double maxSteps = 48.0; ///< sub-samples along a texel's side; the drawn out texels of a rim would ask for hundreds

    const EnvironmentMap& m_source;
    MapLayout m_target;
    double m_yaw;
    bool m_turns;
    glm::dmat3 m_back;       ///< from the turned environment to the source
    bool m_magnifies = true; ///< no target texel is larger than the source's
    int m_level = 0;
    std::optional<EnvironmentMap> m_smooth{}; ///< the source without slivers, when only some target texels are larger than its
    std::optional<SplineLookup> m_spline{};   ///< level m_level of the source's pyramid, when all are

    /// The source's texel whose centre this is, as those of mirrored and quarter-turned maps are: they are moved, not mixed. Or null.
    const float* texelAt(const glm::dvec3& d) const
    {
        const glm::dvec2 p = coordinate(m_source.layout, d), cell = glm::floor(p);
        if (std::max(std::abs(p.x - cell.x - 0.5), std::abs(p.y - cell.y - 0.5)) > 1e-6 || cell.x < 0.0 || cell.y < 0.0 ||
            cell.x >= m_source.image.width || cell.y >= m_source.image.height)
            return nullptr;
        return m_source.image.texel(static_cast<int>(cell.x), static_cast<int>(cell.y));
    }

    /// Whether the texel lies at the pole of a latlong, source or target: the corner of |sin| there wants finer sums.
    bool isPolar(const glm::dvec3& d, int y) const
    {
        if (m_target.kind == Parameterization::Latlong && (y == 0 || y == m_target.size - 1))
            return true;
        const double reach = 4.0 * std::ldexp(pi / m_source.layout.size, m_level); // two texels of the level and about one of the target
        return m_source.layout.kind == Parameterization::Latlong && d.x * d.x + d.z * d.z < reach * reach;
    }
    glm::dvec3 sourceDirection(const glm::dvec2& p) const
    {
        const glm::dvec3 d = direction(m_target, p);
        const glm::dvec3 yawedBack = m_yaw == 0.0 ? d : yawed(d, -m_yaw);
        return m_turns ? m_back * yawedBack : yawedBack;
    }
    double sourceAngle(const glm::dvec3& d) const
    {
        if (m_source.layout.kind == Parameterization::Latlong)
            return pi / m_source.layout.size;
        return texelAngle(m_source.layout, coordinate(m_source.layout, d));
    }

    /// Mean of a grid of sub-samples by their solid angle. At a disc's rim each cell counts by its clipped solid angle. A texel wholly
    /// outside, or beyond the rim in a paraboloid's border, which is read like any other texel, is the plain mean of the continued
    /// directions.
    template <class Lookup>
    glm::vec3 mean(int x, int y, const glm::dvec2& wanted, const Lookup& lookup) const
    {
        const glm::ivec2 steps = glm::ceil(glm::clamp(wanted, 1.0, maxSteps));
        const glm::dvec2 cell = 1.0 / glm::dvec2(steps);
        bool whole = true;
        for (const glm::dvec2 corner : {glm::dvec2(0.0), {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}})
            whole = whole && density(m_target, glm::dvec2(x, y) + 0.001 + 0.998 * corner) > 0.0;
        const bool clipped = !whole && m_target.border == 0 && isInside(m_target, x, y);
        glm::dvec3 sum(0.0);
        double total = 0.0;
        for (int j = 0; j < steps.y; ++j)
            for (int i = 0; i < steps.x; ++i) {
                const glm::dvec2 corner = glm::dvec2(x, y) + cell * glm::dvec2(i, j), p = corner + 0.5 * cell;
                const double w = whole ? density(m_target, p) : clipped ? solidAngle(m_target, corner, corner + cell) : 1.0;
                if (w <= 0.0)
                    continue;
                sum += w * glm::dvec3(lookup(sourceDirection(p)));
                total += w;
            }
        return total > 0.0 ? glm::vec3(sum / total) : lookup(sourceDirection({x + 0.5, y + 0.5}));
    }
};

/// Bilinear interpolation at a position whose whole numbers are texel centres, clamped to a rectangle of the image.
glm::vec3 bilinearAt(const Image& image, double x, double y, int top, int rows)
{
    const int x0 = std::clamp(static_cast<int>(x), 0, image.width - 2), y0 = std::clamp(static_cast<int>(y), 0, rows - 2);
    const float fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    glm::vec3 result;
    const float* a = image.texel(x0, top + y0);
    const float* b = image.texel(x0, top + y0 + 1);
    for (int c = 0; c < 3; ++c)
        result[c] = glm::mix(glm::mix(a[c], a[c + 3], fx), glm::mix(b[c], b[c + 3], fx), fy);
    return result;
}

} // namespace

EnvironmentMap reproject(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job)
{
    validate(source.layout);
    validate(options.target);
    if (source.layout == options.target && options.yaw == 0.0 && options.turn == glm::dmat3(1.0))
        return source;
    const Resampler resampler(source, options, {.stop = job.stop, .progress = {}, .threads = job.threads});
    EnvironmentMap result(options.target);
    parallelRows(result.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < result.image.width; ++x) {
                const glm::vec3 value = resampler.texel(x, y);
                std::copy_n(&value.x, 3, result.image.texel(x, y));
            }
    });
    return result;
}

EnvironmentMap fromEdgeSampledLatlong(const Image& image, const JobControl& job)
{
    if (image.width < 2 || image.height < 2)
        throw InvalidArgument("an edge-sampled latlong needs at least 2 x 2 texels, this has " + std::to_string(image.width) + " x " +
                              std::to_string(image.height));
    EnvironmentMap result({Parameterization::Latlong, image.height, 0});
    parallelRows(result.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < result.image.width; ++x) {
                const double u = (x + 0.5) / result.image.width, v = (y + 0.5) / result.image.height;
                const glm::vec3 value = bilinearAt(image, u * (image.width - 1), v * (image.height - 1), 0, image.height);
                std::copy_n(&value.x, 3, result.image.texel(x, y));
            }
    });
    return result;
}

EnvironmentMap fromOpenExrCube(const Image& image, const JobControl& job)
{
    const int n = image.width;
    if (n < 2 || image.height != 6 * n)
        throw InvalidArgument("an OpenEXR cube map is N x 6N texels with N at least 2, this has " + std::to_string(image.width) + " x " +
                              std::to_string(image.height));
    EnvironmentMap result({Parameterization::Cube, n, 0});
    parallelRows(result.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < n; ++x) {
                const int face = y / n;
                const bool isY = face == 2 || face == 3;
                const double s = (2 * x + 1.0) / n - 1.0, t = (2 * (y % n) + 1.0) / n - 1.0;
                const double column = 0.5 * ((isY ? s : -s) + 1.0) * (n - 1), row = 0.5 * ((isY ? -t : t) + 1.0) * (n - 1);
                const glm::vec3 value = bilinearAt(image, column, row, face * n, n);
                std::copy_n(&value.x, 3, result.image.texel(x, y));
            }
    });
    return result;
}

} // namespace mirrorball
