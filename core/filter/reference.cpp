#include "reference.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

// This file is compiled with the relaxed floating-point rules that let the compiler call vectorised exp and log (see CMakeLists.txt):
// results stay within a few units in the last place of a double. Nothing here may produce or test for infinities or NaN.
namespace mirrorball {

namespace {

/// ln of the smallest ratio to the peak that still counts: beyond it exp() leaves the range of normal doubles.
constexpr double smallestLog = -700.0;

/// The map split into planes, in double, with the trigonometry of its rows and columns.
struct Planes {
    int width, height;
    std::vector<double> texels; ///< [row][channel][column]
    std::vector<double> sinLon, cosLon, sinLat, cosLat, weight;

    explicit Planes(const Image& image) : width(image.width), height(image.height)
    {
        const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
        texels.resize(3 * w * h);
        for (size_t y = 0; y < h; ++y)
            for (size_t x = 0; x < w; ++x)
                for (size_t c = 0; c < 3; ++c)
                    texels[(3 * y + c) * w + x] = image.texels[(y * w + x) * 3 + c];
        for (size_t x = 0; x < w; ++x) {
            const double lon = pi - 2.0 * pi * (static_cast<double>(x) + 0.5) / width;
            sinLon.push_back(std::sin(lon));
            cosLon.push_back(std::cos(lon));
        }
        for (size_t y = 0; y < h; ++y) {
            const double lat = pi / 2 - pi * (static_cast<double>(y) + 0.5) / height;
            sinLat.push_back(std::sin(lat));
            cosLat.push_back(std::cos(lat));
            weight.push_back(std::cos(lat)); // the solid angle up to a factor that cancels: both sums carry it
        }
    }
};

/// k(c) for a row of cosines, in place, up to a factor: relative to the peak, or for phong to the nearest texel, whose ln is given.
void relativeRow(const Lobe& lobe, const LobeShape& shape, double nearestLog, std::vector<double>& c)
{
    const size_t n = c.size();
    switch (lobe.kind) {
    case LobeKind::Diffuse:
        for (size_t i = 0; i < n; ++i)
            c[i] = std::max(c[i], 0.0);
        return;
    case LobeKind::Phong: {
        const double exponent = lobe.exponent;
        for (size_t i = 0; i < n; ++i) {
            const double log = exponent * std::log(std::clamp(c[i], 1e-300, 1.0)) - nearestLog;
            const double k = std::exp(std::max(log, smallestLog));
            c[i] = c[i] > 0.0 && log > smallestLog ? k : 0.0;
        }
        return;
    }
    case LobeKind::Ggx: {
        const double a2 = lobe.alpha * lobe.alpha;
        for (size_t i = 0; i < n; ++i) {
            const double x = std::clamp(c[i], 0.0, 1.0);
            const double ratio = a2 / (0.5 * (1.0 - x) + a2 * 0.5 * (1.0 + x));
            c[i] = x * ratio * ratio;
        }
        return;
    }
    case LobeKind::Tabulated:
        for (size_t i = 0; i < n; ++i)
            c[i] = shape.relative(c[i]);
        return;
    }
}

} // namespace

std::vector<glm::dvec3> referenceSum(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                     const JobControl& job)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("reference: the probe must be a latlong map; reproject it first");
    if (lobe.isMirror())
        throw InvalidArgument("reference: a mirror has no sum over texels; look the probe up instead");

    const Planes planes(latlong.image);
    const LobeShape shape(lobe);
    const auto width = static_cast<size_t>(planes.width);
    std::vector<glm::dvec3> result(directions.size());
    parallelRows(
        static_cast<int>(directions.size()), job,
        [&](int first, int last) {
            std::vector<double> along(width), k(width);
            for (int i = first; i < last; ++i) {
                const glm::dvec3 r = directions[static_cast<size_t>(i)];
                for (size_t x = 0; x < width; ++x)
                    along[x] = r.x * planes.sinLon[x] + r.z * planes.cosLon[x];
                double nearestLog = 0.0;
                if (lobe.kind == LobeKind::Phong) {
                    const double highest = *std::max_element(along.begin(), along.end());
                    double nearest = 1e-300;
                    for (size_t y = 0; y < planes.weight.size(); ++y)
                        nearest = std::max(nearest, r.y * planes.sinLat[y] + planes.cosLat[y] * highest);
                    nearestLog = lobe.exponent * std::log(std::min(nearest, 1.0));
                }
                glm::dvec3 sum(0.0);
                double norm = 0.0;
                for (size_t y = 0; y < planes.weight.size(); ++y) {
                    const double a = r.y * planes.sinLat[y], b = planes.cosLat[y];
                    for (size_t x = 0; x < width; ++x)
                        k[x] = a + b * along[x];
                    relativeRow(lobe, shape, nearestLog, k);
                    const double* red = planes.texels.data() + 3 * y * width;
                    const double *green = red + width, *blue = green + width;
                    double rowRed = 0.0, rowGreen = 0.0, rowBlue = 0.0, rowNorm = 0.0;
                    for (size_t x = 0; x < width; ++x) {
                        rowRed += k[x] * red[x];
                        rowGreen += k[x] * green[x];
                        rowBlue += k[x] * blue[x];
                        rowNorm += k[x];
                    }
                    sum += planes.weight[y] * glm::dvec3(rowRed, rowGreen, rowBlue);
                    norm += planes.weight[y] * rowNorm;
                }
                result[static_cast<size_t>(i)] = sum / norm;
            }
        },
        1);
    return result;
}

std::vector<glm::dvec3> lookupDirections(const MapLayout& layout, double yaw)
{
    std::vector<glm::dvec3> directions;
    directions.reserve(static_cast<size_t>(layout.width()) * static_cast<size_t>(layout.height()));
    for (int y = 0; y < layout.height(); ++y)
        for (int x = 0; x < layout.width(); ++x)
            directions.push_back(yawed(texelDirection(layout, x, y), -yaw));
    return directions;
}

} // namespace mirrorball
