#include "direct.h"

#include "row_sums.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

std::vector<glm::dvec3> directSum(const EnvironmentMap& latlong, const Lobe& lobe, std::span<const glm::dvec3> directions,
                                  const DirectOptions& options, const JobControl& job)
{
    if (latlong.layout.kind != Parameterization::Latlong)
        throw InvalidArgument("direct: the probe must be a latlong map; reproject it first");
    if (lobe.isMirror())
        throw InvalidArgument("direct: a mirror has no sum over texels; look the probe up instead");

    if (isShortPolynomial(lobe))
        return rowSums(latlong, lobe, directions, job);

    const Image& image = latlong.image;
    const int width = image.width, height = image.height;
    const LobeShape shape(lobe);
    // At least three texels wide, so that a lookup between texel centers always finds some.
    const double reach = std::min(pi / 2, std::max(shape.support(options.level), 1.5 * pi / height));
    const double cosReach = std::cos(reach);

    std::vector<double> sinLon(static_cast<size_t>(width)), cosLon(static_cast<size_t>(width));
    for (int x = 0; x < width; ++x) {
        const double lon = pi - 2.0 * pi * (x + 0.5) / width;
        sinLon[static_cast<size_t>(x)] = std::sin(lon);
        cosLon[static_cast<size_t>(x)] = std::cos(lon);
    }

    std::vector<glm::dvec3> result(directions.size());
    parallelRows(
        static_cast<int>(directions.size()), job,
        [&](int first, int last) {
            for (int i = first; i < last; ++i) {
                const glm::dvec3 r = directions[static_cast<size_t>(i)];
                const double radius = std::sqrt(r.x * r.x + r.z * r.z);
                const double colatitude = std::atan2(radius, r.y);
                const double column = (pi - std::atan2(r.x, r.z)) * width / (2.0 * pi);
                const int top = std::max(0, static_cast<int>(std::floor((colatitude - reach) * height / pi - 0.5)));
                const int bottom = std::min(height - 1, static_cast<int>(std::ceil((colatitude + reach) * height / pi - 0.5)));
                glm::dvec3 sum(0.0);
                double norm = 0.0;
                for (int y = top; y <= bottom; ++y) {
                    const double theta = pi * (y + 0.5) / height;
                    const double a = r.y * std::cos(theta), b = std::sin(theta);
                    // The row meets the cap where a + b radius cos(difference in azimuth) >= cos(reach).
                    const double edge = (cosReach - a) / std::max(b * radius, 1e-300);
                    if (edge > 1.0)
                        continue;
                    const double half = edge <= -1.0 ? width / 2.0 : std::acos(edge) * width / (2.0 * pi);
                    int from = static_cast<int>(std::ceil(column - half - 0.5)), to = static_cast<int>(std::floor(column + half - 0.5));
                    if (to - from + 1 > width) {
                        from = 0;
                        to = width - 1;
                    }
                    const float* row = image.row(y);
                    glm::dvec3 rowSum(0.0);
                    double rowNorm = 0.0;
                    for (int xx = from; xx <= to; ++xx) {
                        const auto x = static_cast<size_t>((xx % width + width) % width);
                        const double k = shape.relative(a + b * (r.x * sinLon[x] + r.z * cosLon[x]));
                        rowSum += k * glm::dvec3(row[3 * x], row[3 * x + 1], row[3 * x + 2]);
                        rowNorm += k;
                    }
                    sum += b * rowSum; // sin(theta) is the texel's solid angle up to a factor that cancels
                    norm += b * rowNorm;
                }
                if (norm > 0.0)
                    result[static_cast<size_t>(i)] = sum / norm;
                else { // narrower than the texel spacing in both directions: the nearest texel
                    const int y = std::clamp(static_cast<int>(colatitude * height / pi), 0, height - 1);
                    const int x = std::clamp(static_cast<int>(column), 0, width - 1);
                    result[static_cast<size_t>(i)] = {image.texel(x, y)[0], image.texel(x, y)[1], image.texel(x, y)[2]};
                }
            }
        },
        16);
    return result;
}

double directTruncation(const Lobe& lobe, const DirectOptions& options)
{
    const LobeShape shape(lobe);
    const double reach = shape.support(options.level);
    // Integral of k beyond the reach, by the midpoint rule in cos t.
    constexpr int steps = 4096;
    double sum = 0.0;
    const double c = std::cos(reach);
    for (int i = 0; i < steps; ++i)
        sum += shape.relative(c * (i + 0.5) / steps);
    return 2.0 * pi * c * sum / steps / shape.integral();
}

double directTaps(const Lobe& lobe, int latlongWidth, const DirectOptions& options)
{
    const double reach = LobeShape(lobe).support(options.level);
    const double capSolidAngle = 2.0 * pi * 2.0 * std::pow(std::sin(reach / 2), 2);
    // Texels over the sphere, latlongWidth^2 / 2, times the cap's share of it: rows near the poles are denser, and are met as often.
    return capSolidAngle / (4.0 * pi) * latlongWidth * (latlongWidth / 2.0) * (pi / 2);
}

} // namespace mirrorball
