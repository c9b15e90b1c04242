#include "map_picture.h"

#include "color_scale.h"

#include "core/base/error.h"
#include "core/sphere/distortion.h"
#include "core/sphere/map_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorball {

namespace {

void checkWindow(const MapWindow& window)
{
    validate(window.layout);
    if (!(window.scale > 0.0 && std::isfinite(window.scale)) || !std::isfinite(window.origin.x) || !std::isfinite(window.origin.y))
        throw InvalidArgument("scale: must be above 0 and finite, and the origin finite");
    if (window.width < 1 || window.height < 1 || window.width > 32768 || window.height > 32768)
        throw InvalidArgument("width, height: a picture has 1 to 32768 pixels each way; it has " + std::to_string(window.width) + " x " +
                              std::to_string(window.height));
}

/// Calls paint(pixel, image position) for every pixel of the window that shows the sheet.
template <typename Paint>
Image painted(const MapWindow& window, const JobControl& job, const Paint& paint)
{
    Image picture(window.width, window.height, 4);
    parallelRows(window.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            float* pixel = picture.row(y);
            for (int x = 0; x < window.width; ++x, pixel += 4)
                if (const auto p = imageFromSheet(window.layout, sheetPosition(window, {x + 0.5, y + 0.5})))
                    paint(pixel, *p);
        }
    });
    return picture;
}

/// How much of the map is at an image position: beside a disc is nothing, but a paraboloid's border holds radiance too.
float coverage(const MapLayout& layout, const glm::dvec2& p)
{
    if (density(layout, p) > 0.0)
        return 1.0f;
    return layout.border > 0 ? 0.4f : 0.0f;
}

/// Luminances of the texels that lie on the map, of at most about two hundred thousand of them.
std::vector<float> sampledLuminances(const EnvironmentMap& map)
{
    const Image& image = map.image;
    const int step = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(image.width) * image.height / 2e5)));
    std::vector<float> values;
    for (int y = 0; y < image.height; y += step)
        for (int x = 0; x < image.width; x += step)
            if (isInside(map.layout, x, y)) {
                const float* t = image.texel(x, y);
                values.push_back(static_cast<float>(luminance({t[0], t[1], t[2]})));
            }
    return values;
}

double quantile(std::vector<float>& values, double share)
{
    if (values.empty())
        return 0.0;
    const auto at = values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Laid over what is there: straight alpha.
void blend(float* pixel, const glm::vec3& color, float alpha)
{
    const float below = pixel[3] * (1.0f - alpha), total = alpha + below;
    if (total <= 0.0f)
        return;
    for (int c = 0; c < 3; ++c)
        pixel[c] = (color[c] * alpha + pixel[c] * below) / total;
    pixel[3] = total;
}

/// Cover of a line of `width` pixels whose middle is `distance` pixels away, with an edge of one pixel.
float lineCover(double distance, double width) { return static_cast<float>(std::clamp(0.5 * width + 0.5 - distance, 0.0, 1.0)); }

/// The direction grid at one image position: how near, in pixels, the closest lines are.
struct GridDistances {
    double step = 1e9;      ///< to the closest latitude or longitude of the grid
    double principal = 1e9; ///< to the closest of the planes x = 0, y = 0, z = 0
};

/// @param pixelAngle  angle that a pixel subtends along each axis of the image, by finite differences
GridDistances gridDistances(const glm::dvec3& d, const glm::dvec3& right, const glm::dvec3& down, double stepRadians)
{
    GridDistances near;
    const auto line = [&](double value, double valueRight, double valueDown) { // distance to value = 0 by its gradient a pixel
        const double gradient = std::hypot(valueRight - value, valueDown - value);
        return gradient > 0.0 ? std::abs(value) / gradient : 1e9;
    };
    for (int axis = 0; axis < 3; ++axis)
        near.principal = std::min(near.principal, line(d[axis], right[axis], down[axis]));
    const double latitude = std::asin(std::clamp(d.y, -1.0, 1.0)), level = stepRadians * std::round(latitude / stepRadians);
    near.step = line(latitude - level, std::asin(std::clamp(right.y, -1.0, 1.0)) - level, std::asin(std::clamp(down.y, -1.0, 1.0)) - level);
    // A meridian is the plane through +Y of its longitude: the distance to that plane has no jump at 180 degrees. Those beside the poles
    // are left out where they would run together.
    const double meridian = stepRadians * std::round(std::atan2(d.x, d.z) / stepRadians);
    const glm::dvec3 normal(std::cos(meridian), 0.0, -std::sin(meridian));
    if (std::abs(latitude) < 0.5 * pi - stepRadians)
        near.step = std::min(near.step, line(glm::dot(normal, d), glm::dot(normal, right), glm::dot(normal, down)));
    return near;
}

} // namespace

Image mapWindow(const MipPyramid& map, const MapWindow& window, const JobControl& job)
{
    checkWindow(window);
    const EnvironmentMap& base = map.levels.front();
    const bool texels = base.layout == window.layout && window.scale >= 1.0;
    return painted(window, job, [&](float* pixel, const glm::dvec2& p) {
        const float cover = coverage(window.layout, p);
        if (cover == 0.0f)
            return;
        glm::vec3 value;
        if (texels) {
            const float* t = base.image.texel(std::min(static_cast<int>(p.x), base.image.width - 1),
                                              std::min(static_cast<int>(p.y), base.image.height - 1));
            value = {t[0], t[1], t[2]};
        } else {
            const glm::dvec3 d = direction(window.layout, p);
            const double there = density(base.layout, coordinate(base.layout, d));
            const double here = density(window.layout, p) / (window.scale * window.scale);
            value = radiance(map, d, there > 0.0 && here > there ? 0.5 * std::log2(here / there) : 0.0);
        }
        for (int c = 0; c < 3; ++c)
            pixel[c] = value[c];
        pixel[3] = cover;
    });
}

Image windowColors(const Image& window, const MapColoring& coloring, const JobControl& job)
{
    if (!(coloring.low > 0.0 && coloring.high > coloring.low && std::isfinite(coloring.high)))
        throw InvalidArgument("low, high: a color scale needs 0 < low < high");
    Image picture(window.width, window.height, 4);
    const float gain = static_cast<float>(std::exp2(coloring.exposure));
    const double logLow = std::log2(coloring.low), logWidth = std::log2(coloring.high / coloring.low);
    parallelRows(window.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < window.width; ++x) {
                const float* in = window.texel(x, y);
                float* out = picture.texel(x, y);
                if (in[3] <= 0.0f)
                    continue;
                glm::vec3 color(0.0f);
                const double l = luminance({in[0], in[1], in[2]});
                switch (coloring.colors) {
                case MapColors::Display:
                    for (int c = 0; c < 3; ++c)
                        color[c] = encodeSrgb(toneMapped(gain * in[c], coloring.tone));
                    break;
                case MapColors::Luminance:
                    color = falseColor(l > 0.0 ? (std::log2(l) - logLow) / logWidth : 0.0);
                    break;
                case MapColors::Signed:
                    color = signedColor(l / coloring.high);
                    break;
                }
                for (int c = 0; c < 3; ++c)
                    out[c] = color[c];
                out[3] = std::min(in[3], 1.0f);
            }
    });
    return picture;
}

Image mapOverlay(const MapWindow& window, const MapOverlays& overlays, const JobControl& job)
{
    checkWindow(window);
    if (!(overlays.gridStepDeg > 0.0 && overlays.gridStepDeg <= 90.0))
        throw InvalidArgument("gridStepDeg: must be above 0 and at most 90 degrees");
    const MapLayout& layout = window.layout;
    const Charts charts = mapping(layout.kind).charts;
    const double mean = 4.0 * pi /
                        (charts == Charts::Disc     ? 0.25 * pi * layout.size * layout.size
                         : charts == Charts::Halves ? 0.5 * pi * std::pow(layout.size - 2.0 * layout.border, 2.0)
                                                    : static_cast<double>(layout.width()) * layout.height());
    const double pixel = 1.0 / window.scale, step = overlays.gridStepDeg * pi / 180.0;
    return painted(window, job, [&](float* out, const glm::dvec2& p) {
        const bool inside = density(layout, p) > 0.0;
        if (inside && overlays.tint == MapTint::SolidAngle)
            blend(out, signedColor(std::log2(density(layout, p) / mean) / tintStops), 0.72f);
        if (inside && overlays.tint == MapTint::Anisotropy)
            blend(out, falseColor(std::log2(distortion(layout, p).anisotropy()) / tintStops), 0.72f);
        if (overlays.grid && inside) {
            // Differences that stay in the chart: towards the inside of the map at its right and lower edges.
            const double sx = seamDistance(layout, p) < pixel ? 1e-3 : pixel;
            const glm::dvec3 d = direction(layout, p);
            const auto beside = [&](const glm::dvec2& by) { return d + (direction(layout, p + by * sx) - d) * (pixel / sx); };
            const GridDistances near = gridDistances(d, beside({1.0, 0.0}), beside({0.0, 1.0}), step);
            blend(out, glm::vec3(1.0f), 0.35f * lineCover(near.step, overlays.lineWidth));
            blend(out, glm::vec3(1.0f, 0.85f, 0.45f), 0.8f * lineCover(near.principal, 1.5 * overlays.lineWidth));
        }
        if (overlays.seams)
            blend(out, glm::vec3(1.0f, 0.35f, 0.55f), lineCover(seamDistance(layout, p) * window.scale, 2.0 * overlays.lineWidth));
    });
}

EnvironmentMap difference(const EnvironmentMap& a, const EnvironmentMap& b, const JobControl& job)
{
    EnvironmentMap result(a.layout);
    const bool same = a.layout == b.layout;
    parallelRows(a.image.height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < a.image.width; ++x) {
                if (!isInside(a.layout, x, y))
                    continue;
                const float* left = a.image.texel(x, y);
                const glm::vec3 right = same ? glm::vec3(b.image.texel(x, y)[0], b.image.texel(x, y)[1], b.image.texel(x, y)[2])
                                             : b.radiance(texelDirection(a.layout, x, y));
                for (int c = 0; c < 3; ++c)
                    result.image.texel(x, y)[c] = left[c] - right[c];
            }
    });
    return result;
}

LuminanceRange luminanceRange(const EnvironmentMap& map)
{
    std::vector<float> values = sampledLuminances(map);
    const double high = quantile(values, 0.9999);
    if (!(high > 0.0) || !std::isfinite(high))
        return {};
    const double low = quantile(values, 0.001);
    return {std::clamp(low, high * 0x1p-24, 0.5 * high), high};
}

double signedRange(const EnvironmentMap& difference)
{
    std::vector<float> values = sampledLuminances(difference);
    for (float& value : values)
        value = std::abs(value);
    return std::max(quantile(values, 0.95), 1e-6);
}

} // namespace mirrorball
