#include "reproject.h"

#include "core/base/error.h"
#include "remap.h"
#include "texel_outline.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mirrorball {

namespace {

/// Bilinear interpolation at a position whose whole numbers are texel centers, clamped to a rectangle of the image.
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

/// The source's texel whose center this is, as those of mirrored and quarter-turned maps are: they are moved, not mixed. Or null.
const float* texelAt(const EnvironmentMap& source, const glm::dvec3& d)
{
    const glm::dvec2 p = coordinate(source.layout, d), cell = glm::floor(p);
    if (std::max(std::abs(p.x - cell.x - 0.5), std::abs(p.y - cell.y - 0.5)) > 1e-6 || cell.x < 0.0 || cell.y < 0.0 ||
        cell.x >= source.image.width || cell.y >= source.image.height)
        return nullptr;
    return source.image.texel(static_cast<int>(cell.x), static_cast<int>(cell.y));
}

} // namespace

EnvironmentMap reproject(const EnvironmentMap& source, const ReprojectOptions& options, const JobControl& job)
{
    validate(source.layout);
    validate(options.target);
    if (source.layout == options.target && options.yaw == 0.0 && options.turn == glm::dmat3(1.0))
        return source;
    if (magnification(source.layout, options).largest >= magnifiedBelow)
        return remap(source, options, job);
    EnvironmentMap result(options.target);
    const bool turns = options.turn != glm::dmat3(1.0);
    const TexelOutlines places(options.target, options.yaw, options.turn, MapCharts(source.layout));
    const int width = result.image.width, chart = options.target.chartWidth();
    parallelRows(result.image.height, job, [&](int first, int last) {
        const size_t count = static_cast<size_t>(chart);
        std::vector<double> x(count), y(count), z(count);
        for (int row = first; row < last; ++row)
            for (int left = 0; left < width; left += chart) {
                places.directions(left, row, {.first = {left + 0.5, row + 0.5}, .step = {1.0, 1.0}, .columns = chart, .rows = 1}, x.data(),
                                  y.data(), z.data());
                float* const out = result.image.texel(left, row);
                lookUp(source, count, x.data(), y.data(), z.data(), options.resample, out);
                for (size_t i = 0; turns && i < count; ++i)
                    if (const float* same = texelAt(source, glm::normalize(glm::dvec3(x[i], y[i], z[i]))))
                        std::copy_n(same, 3, out + 3 * i);
            }
    });
    return result;
}

bool canReprojectRows(const MapLayout& source, const ReprojectOptions& options)
{
    return !mapping(source.kind).hasDiscs() && magnification(source, options).smallest >= 1.1 * magnifiedBelow;
}

EnvironmentMap reprojectRows(const MapLayout& source, const RowReader& readRows, const ReprojectOptions& options, const JobControl& job)
{
    validate(source);
    validate(options.target);
    if (!canReprojectRows(source, options))
        throw InvalidArgument("a " + std::string(name(source.kind)) + " map of size " + std::to_string(source.size) +
                              " cannot be resampled row by row to size " + std::to_string(options.target.size) +
                              ": give a smaller size, or hold the map");
    return remapRows(source, readRows, options, job);
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
