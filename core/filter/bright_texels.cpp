#include "bright_texels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirrorball {

namespace {

constexpr size_t mostTexels = 96;
constexpr double smallestShare = 1.0 / 2000.0;

/// The directions of the bright texels as planes, so that the sums over them vectorise.
struct Planes {
    std::vector<double> x, y, z, red, green, blue;

    explicit Planes(const BrightTexels& bright)
    {
        for (size_t i = 0; i < bright.directions.size(); ++i) {
            x.push_back(bright.directions[i].x);
            y.push_back(bright.directions[i].y);
            z.push_back(bright.directions[i].z);
            red.push_back(bright.flux[i].r);
            green.push_back(bright.flux[i].g);
            blue.push_back(bright.flux[i].b);
        }
    }
};

} // namespace

BrightTexels takeBrightTexels(EnvironmentMap& latlong)
{
    Image& image = latlong.image;
    const size_t texels = image.texels.size() / 3;
    std::vector<double> power(texels);
    for (int y = 0; y < image.height; ++y) {
        const double solidAngle = texelSolidAngle(latlong.layout, 0, y);
        for (int x = 0; x < image.width; ++x) {
            const float* t = image.texel(x, y);
            power[image.index(x, y) / 3] = solidAngle * (std::abs(t[0]) + std::abs(t[1]) + std::abs(t[2]));
        }
    }
    const double threshold = smallestShare * std::accumulate(power.begin(), power.end(), 0.0);
    std::vector<size_t> brightest;
    for (size_t i = 0; i < texels; ++i)
        if (power[i] > threshold)
            brightest.push_back(i);
    std::sort(brightest.begin(), brightest.end(), [&](size_t a, size_t b) { return power[a] != power[b] ? power[a] > power[b] : a < b; });
    const double level = brightest.size() > mostTexels ? power[brightest[mostTexels]] : threshold;
    brightest.resize(std::min(brightest.size(), mostTexels));

    BrightTexels bright;
    for (const size_t i : brightest) {
        const int x = static_cast<int>(i % static_cast<size_t>(image.width)), y = static_cast<int>(i / static_cast<size_t>(image.width));
        float* t = image.texel(x, y);
        glm::dvec3 excess;
        for (int c = 0; c < 3; ++c) { // what stays is the float that is stored, so that the two parts add up exactly
            const double whole = t[c];
            t[c] = static_cast<float>(whole * level / power[i]);
            excess[c] = whole - t[c];
        }
        bright.directions.push_back(texelDirection(latlong.layout, x, y));
        bright.flux.push_back(excess * texelSolidAngle(latlong.layout, x, y));
    }
    return bright;
}

void addBrightTexels(EnvironmentMap& map, const BrightTexels& bright, const Lobe& lobe, const Spectrum& calm, const std::vector<double>& k,
                     double yaw, const JobControl& job)
{
    if (bright.directions.empty())
        return;
    const Planes planes(bright);
    const size_t count = bright.directions.size();
    const LobeShape shape(lobe);
    const double peak = 1.0 / shape.integral();
    const double a2 = lobe.alpha * lobe.alpha;

    // N varies smoothly and differs from 1 by some 1e-6: a table over the colatitude, read linearly.
    constexpr int steps = 1024;
    std::vector<double> theta(steps + 1);
    for (int i = 0; i <= steps; ++i)
        theta[static_cast<size_t>(i)] = pi * i / steps;
    const std::vector<double> norm = filterOfOne(calm, k, theta);

    parallelRows(map.image.height, job, [&](int first, int last) {
        std::vector<double> weight(count);
        for (int y = first; y < last; ++y)
            for (int x = 0; x < map.image.width; ++x) {
                const glm::dvec3 r = yawed(texelDirection(map.layout, x, y), -yaw);
                for (size_t i = 0; i < count; ++i)
                    weight[i] = std::min(1.0, r.x * planes.x[i] + r.y * planes.y[i] + r.z * planes.z[i]);
                if (lobe.kind == LobeKind::Diffuse)
                    for (double& w : weight)
                        w = std::max(w, 0.0);
                else if (lobe.kind == LobeKind::Ggx) // as LobeShape::relative, written out so that it vectorises
                    for (double& w : weight) {
                        const double ratio = a2 / (0.5 * (1.0 - w) + a2 * 0.5 * (1.0 + w));
                        w = std::max(w, 0.0) * ratio * ratio;
                    }
                else
                    for (double& w : weight)
                        w = shape.relative(w);
                glm::dvec3 sum(0.0);
                for (size_t i = 0; i < count; ++i)
                    sum += weight[i] * glm::dvec3(planes.red[i], planes.green[i], planes.blue[i]);
                const double position = std::acos(std::clamp(r.y, -1.0, 1.0)) / pi * steps;
                const auto step = std::min(static_cast<size_t>(position), static_cast<size_t>(steps - 1));
                const double fraction = position - static_cast<double>(step);
                sum *= peak / ((1.0 - fraction) * norm[step] + fraction * norm[step + 1]);
                for (int c = 0; c < 3; ++c)
                    map.image.texel(x, y)[c] += static_cast<float>(sum[c]);
            }
    });
}

} // namespace mirrorball
