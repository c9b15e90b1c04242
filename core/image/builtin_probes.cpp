#include "builtin_probes.h"

#include "cube_probes.h"
#include "daylight.h"
#include "studio_probe.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_map>

namespace mirrorball {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::array probes{
    BuiltinProbe{"studio", "Gray photographic studio with soft boxes, a strip light and a lit backdrop.", studioRadiance},
    BuiltinProbe{"sky", "Clear daylight sky (Preetham 1999) with the sun's disc at 35 degrees over a sunlit ground.", skyRadiance},
    BuiltinProbe{"cube-room", "The inside of a cube with six differently colored, checkered walls.", cubeRoomRadiance},
    BuiltinProbe{"axes", "Test probe whose six cube faces carry the names of their axes.", axesRadiance},
};

using Radiance = dvec3 (*)(const dvec3&);

/// Mean of the radiance over one texel: k x k samples, each weighted by the solid angle per area at its place. A texel of a disc's
/// image that lies off the map has none: its samples count alike.
dvec3 texelMean(Radiance radiance, const MapLayout& layout, int k, int x, int y)
{
    if (k == 1)
        return radiance(texelDirection(layout, x, y));
    const bool inside = isInside(layout, x, y);
    dvec3 sum(0.0);
    double weights = 0.0;
    for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
            const dvec2 p(x + (i + 0.5) / k, y + (j + 0.5) / k);
            const double w = inside ? density(layout, p) : 1.0;
            if (w <= 0.0)
                continue;
            sum += w * radiance(direction(layout, p));
            weights += w;
        }
    return weights > 0.0 ? sum / weights : radiance(texelDirection(layout, x, y));
}

void store(float* texel, const dvec3& rgb)
{
    for (int c = 0; c < 3; ++c)
        texel[c] = static_cast<float>(rgb[c]);
}

/// How much two texels differ, from 0 to 1; above about 0.04 there is an edge between them.
float contrast(const float* a, const float* b)
{
    float most = 0.0f;
    for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(a[c] - b[c]) / (0.05f + a[c] + b[c]));
    return most;
}

/// Adds a disc of constant radiance by sharing out its solid angle among the texels it falls on, so that sum(L w) is exact however
/// the disc lies to the texels. Points of equal solid angle on a spiral stand for the disc, a thousand or more for each texel.
void splatDisc(EnvironmentMap& map, const dvec3& center, double radius, const dvec3& radiance)
{
    const MapLayout& layout = map.layout;
    const double solidAngle = 2.0 * pi * (1.0 - std::cos(radius));
    const double across = 2.0 * radius / std::sqrt(4.0 * pi / (static_cast<double>(layout.width()) * layout.height()));
    const int points = static_cast<int>(std::clamp(2048.0 * across * across, 32768.0, 4194304.0));

    const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), center));
    const dvec3 up = glm::cross(center, right);
    constexpr double goldenAngle = 2.0 * pi * (2.0 - std::numbers::phi);
    std::unordered_map<size_t, int> hits; // points by texel, y * width + x
    for (int i = 0; i < points; ++i) {
        const double cosine = 1.0 - (1.0 - std::cos(radius)) * (i + 0.5) / points;
        const double sine = std::sqrt(1.0 - cosine * cosine), angle = goldenAngle * i;
        const dvec2 p = coordinate(layout, cosine * center + sine * (std::cos(angle) * right + std::sin(angle) * up));
        const int x = std::clamp(static_cast<int>(p.x), 0, layout.width() - 1);
        const int y = std::clamp(static_cast<int>(p.y), 0, layout.height() - 1);
        ++hits[static_cast<size_t>(y) * static_cast<size_t>(layout.width()) + static_cast<size_t>(x)];
    }
    for (const auto& [index, count] : hits) {
        const int x = static_cast<int>(index % static_cast<size_t>(layout.width()));
        const int y = static_cast<int>(index / static_cast<size_t>(layout.width()));
        const double own = texelSolidAngle(layout, x, y);
        if (own <= 0.0)
            continue; // a rounding away beyond a disc's edge
        const double share = solidAngle * count / points / own;
        float* texel = map.image.texel(x, y);
        for (int c = 0; c < 3; ++c)
            texel[c] = static_cast<float>(texel[c] + share * radiance[c]);
    }
}

} // namespace

std::span<const BuiltinProbe> builtinProbes() { return probes; }

const BuiltinProbe& builtinProbe(std::string_view name)
{
    std::string known;
    for (const BuiltinProbe& probe : probes) {
        if (probe.name == name)
            return probe;
        known += (known.empty() ? "" : ", ") + std::string(probe.name);
    }
    throw InvalidArgument("unknown built-in probe '" + std::string(name) + "'; the built-in probes are " + known);
}

EnvironmentMap renderBuiltinProbe(std::string_view name, const MapLayout& layout, const JobControl& job)
{
    const BuiltinProbe& probe = builtinProbe(name);
    validate(layout);
    const bool hasSun = probe.radiance == skyRadiance;
    const Radiance radiance = hasSun ? skyWithoutSun : probe.radiance; // a disc of a texel's size would slip between the samples
    EnvironmentMap map(layout);
    const int width = layout.width(), height = layout.height();

    // At least 2^18 samples over the whole map, 0.4 degrees apart, find the smallest detail of any probe.
    const double texels = static_cast<double>(width) * height;
    const int k = std::clamp(static_cast<int>(std::ceil(std::sqrt(262144.0 / texels) - 1e-9)), 1, 512);
    constexpr int edgeK = 3;
    const bool refines = k < edgeK && !hasSun; // the sky has no edges
    JobControl pass = job;
    if (job.progress && refines)
        pass.progress = [&](float f) { job.progress(f / 2.0f); };
    parallelRows(height, pass, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < width; ++x)
                store(map.image.texel(x, y), texelMean(radiance, layout, k, x, y));
    });

    if (refines) {
        const Image coarse = map.image;
        if (job.progress)
            pass.progress = [&](float f) { job.progress(0.5f + f / 2.0f); };
        parallelRows(height, pass, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < width; ++x) {
                    const float* own = coarse.texel(x, y);
                    float most = 0.0f;
                    for (const Texel near : {Texel{x - 1, y}, Texel{x + 1, y}, Texel{x, y - 1}, Texel{x, y + 1}})
                        if (near.x >= 0 && near.x < width && near.y >= 0 && near.y < height)
                            most = std::max(most, contrast(own, coarse.texel(near.x, near.y)));
                    const int fineK = most > 0.2f ? edgeK : most > 0.04f ? 2 : 1; // a faint edge needs fewer samples
                    if (fineK > k)
                        store(map.image.texel(x, y), texelMean(radiance, layout, fineK, x, y));
                }
        });
    }
    if (hasSun)
        splatDisc(map, skySunDirection(), skySunRadius, skySunRadiance());
    return map;
}

} // namespace mirrorball
