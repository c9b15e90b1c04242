#include "picture_fit.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

/// Bilinear at a continuous position; beyond the edge the texel there, or around it.
void sample(const Image& picture, double px, double py, bool aroundX, float* out)
{
    const double x = std::floor(px - 0.5), y = std::floor(py - 0.5), fx = px - 0.5 - x, fy = py - 0.5 - y;
    const auto column = [&](double c) {
        const int i = static_cast<int>(c);
        return aroundX ? (i % picture.width + picture.width) % picture.width : std::clamp(i, 0, picture.width - 1);
    };
    const int x0 = column(x), x1 = column(x + 1.0);
    const int y0 = std::clamp(static_cast<int>(y), 0, picture.height - 1), y1 = std::clamp(static_cast<int>(y) + 1, 0, picture.height - 1);
    // Positions that are meant to be texel centers are so to rounding: then the neighbors must not count, however bright they are.
    const double wx = fx < 1e-9 ? 0.0 : fx > 1.0 - 1e-9 ? 1.0 : fx, wy = fy < 1e-9 ? 0.0 : fy > 1.0 - 1e-9 ? 1.0 : fy;
    for (int c = 0; c < picture.channels; ++c) {
        const double top = picture.texel(x0, y0)[c] * (1.0 - wx) + picture.texel(x1, y0)[c] * wx;
        const double bottom = picture.texel(x0, y1)[c] * (1.0 - wx) + picture.texel(x1, y1)[c] * wx;
        out[c] = static_cast<float>(top * (1.0 - wy) + bottom * wy);
    }
}

/// A picture of which every texel is asked where it lies in the source: a place in texels, or nothing.
template <typename Place>
Image mapped(const Image& source, int width, int height, bool aroundX, const JobControl& job, const Place& place)
{
    Image result(width, height, source.channels);
    parallelRows(height, job, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < width; ++x) {
                glm::dvec2 p;
                if (place(x + 0.5, y + 0.5, p))
                    sample(source, p.x, p.y, aroundX, result.texel(x, y));
            }
    });
    return result;
}

constexpr double slack = 1e-9; ///< of a picture's edge, in shares of it

bool spans(double angle, double view) { return std::abs(angle) <= 0.5 * view * (1.0 + slack); }

/// The share of the picture's width at which an azimuth, in degrees from the middle, is shown.
bool horizontalPlace(const ViewOnSphere& view, double azimuth, double& share)
{
    if (!spans(azimuth, view.horizontalDeg)) {
        azimuth = (azimuth > 0.0 ? 180.0 : -180.0) - azimuth;
        if (view.beyond == BeyondView::Black || !spans(azimuth, view.horizontalDeg))
            return false;
    }
    share = 0.5 + azimuth / view.horizontalDeg;
    return true;
}

/// Where in the fisheye's disc, in its radii, an angle from the axis is shown.
bool radialPlace(const ViewOnSphere& view, double angle, double& radius)
{
    if (!spans(angle, view.horizontalDeg)) {
        angle = 180.0 - angle;
        if (view.beyond == BeyondView::Black || !spans(angle, view.horizontalDeg))
            return false;
    }
    radius = 2.0 * angle / view.horizontalDeg;
    return true;
}

} // namespace

ViewOnSphere latlongView(int width, int height, const ProbeReading& reading)
{
    double h = reading.horizontalAngleDeg, v = reading.verticalAngleDeg;
    if (h <= 0.0 && v <= 0.0) {
        const double byWidth = 360.0 / width, byHeight = 180.0 / height;
        const double texel = reading.fit == Fit::Crop ? std::max(byWidth, byHeight) : std::min(byWidth, byHeight);
        h = reading.fit == Fit::Stretch ? 360.0 : texel * width;
        v = reading.fit == Fit::Stretch ? 180.0 : texel * height;
    } else if (h <= 0.0) {
        h = v * width / height;
    } else if (v <= 0.0) {
        v = h * height / width;
    }
    return {h, v, reading.beyond};
}

int latlongSize(int width, int height, const ViewOnSphere& view)
{
    return std::max(1, static_cast<int>(std::ceil(std::max(180.0 * width / view.horizontalDeg, 180.0 * height / view.verticalDeg) - 1e-6)));
}

Image onLatlong(const Image& picture, const ViewOnSphere& view, int size, const JobControl& job)
{
    const bool around = std::abs(view.horizontalDeg - 360.0) < 1e-6;
    return mapped(picture, 2 * size, size, around, job, [&](double x, double y, glm::dvec2& p) {
        const double polar = (y / size - 0.5) * 180.0;
        if (!spans(polar, view.verticalDeg) || !horizontalPlace(view, (x / (2 * size) - 0.5) * 360.0, p.x))
            return false;
        p = {p.x * picture.width, (0.5 + polar / view.verticalDeg) * picture.height};
        return true;
    });
}

std::int64_t blackTexelsOnLatlong(const ViewOnSphere& view, int size)
{
    std::int64_t columns = 0, rows = 0;
    double share = 0.0;
    for (int x = 0; x < 2 * size; ++x)
        columns += horizontalPlace(view, ((x + 0.5) / (2 * size) - 0.5) * 360.0, share) ? 1 : 0;
    for (int y = 0; y < size; ++y)
        rows += spans(((y + 0.5) / size - 0.5) * 180.0, view.verticalDeg) ? 1 : 0;
    return 2 * std::int64_t{size} * size - columns * rows;
}

Image onAngularMap(const Image& fisheye, const ViewOnSphere& view, int size, const JobControl& job)
{
    const double half = 0.5 * size;
    return mapped(fisheye, size, size, false, job, [&](double x, double y, glm::dvec2& p) {
        const glm::dvec2 q{(x - half) / half, (y - half) / half};
        const double length = glm::length(q);
        double radius = 0.0;
        if (!radialPlace(view, 180.0 * std::min(length, 1.0), radius))
            return false;
        const glm::dvec2 at = length > 0.0 ? q * (radius / length) : q;
        p = {0.5 * (1.0 + at.x) * fisheye.width, 0.5 * (1.0 + at.y) * fisheye.height};
        return true;
    });
}

std::int64_t blackTexelsOnAngularMap(const ViewOnSphere& view, int size)
{
    std::int64_t black = 0;
    double radius = 0.0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double length = std::hypot((x + 0.5) / size - 0.5, (y + 0.5) / size - 0.5) * 2.0;
            black += length <= 1.0 && !radialPlace(view, 180.0 * length, radius) ? 1 : 0;
        }
    return black;
}

int squareSize(int width, int height, Fit fit) { return fit == Fit::Crop ? std::min(width, height) : std::max(width, height); }

Image squared(const Image& picture, Fit fit, int size, const JobControl& job)
{
    const int own = squareSize(picture.width, picture.height, fit);
    const double scaleX = (fit == Fit::Stretch ? picture.width : own) / static_cast<double>(size);
    const double scaleY = (fit == Fit::Stretch ? picture.height : own) / static_cast<double>(size);
    return mapped(picture, size, size, false, job, [&](double x, double y, glm::dvec2& p) {
        p = {0.5 * picture.width + (x - 0.5 * size) * scaleX, 0.5 * picture.height + (y - 0.5 * size) * scaleY};
        return p.x >= 0.0 && p.y >= 0.0 && p.x <= picture.width && p.y <= picture.height;
    });
}

Image around(const Image& picture, const Circle& circle, int size, const JobControl& job)
{
    return mapped(picture, size, size, false, job, [&](double x, double y, glm::dvec2& p) {
        p = circle.center + circle.radius * (2.0 * glm::dvec2(x, y) / static_cast<double>(size) - 1.0);
        return true;
    });
}

} // namespace mirrorball
