#include "picture_values.h"

#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::studio {

namespace {

constexpr QRgb aboveMark = 0xffff2828, belowMark = 0xff3c78ff;

enum class Clip { Inside, Above, Below };

Clip clipOf(const glm::vec3& exposed)
{
    if (std::max({exposed.r, exposed.g, exposed.b}) > 1.0f + clipSlack)
        return Clip::Above;
    return std::min({exposed.r, exposed.g, exposed.b}) < -clipSlack ? Clip::Below : Clip::Inside;
}

} // namespace

DisplayHistogram histogramOf(const QImage& picture)
{
    DisplayHistogram histogram{};
    for (int y = 0; y < picture.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
        for (int x = 0; x < picture.width(); ++x) {
            ++histogram[0][static_cast<size_t>(qRed(row[x]))];
            ++histogram[1][static_cast<size_t>(qGreen(row[x]))];
            ++histogram[2][static_cast<size_t>(qBlue(row[x]))];
        }
    }
    return histogram;
}

std::optional<ScenePixel> scenePixel(const PictureOrder& order, const QPoint& pixel)
{
    switch (order.comparison) {
    case Comparison::Off:
        return ScenePixel{false, pixel};
    case Comparison::Hold:
        return ScenePixel{true, pixel};
    case Comparison::Wipe:
        return ScenePixel{pixel.x() < order.wipe, pixel};
    case Comparison::SideBySide: {
        if (pixel.x() < order.settings.width)
            return ScenePixel{true, pixel};
        const QPoint now = pixel - QPoint(order.size.width() - order.settings.width, 0);
        return now.x() < 0 ? std::nullopt : std::optional(ScenePixel{false, now});
    }
    case Comparison::Difference:
        break;
    }
    return std::nullopt;
}

std::optional<glm::vec3> lightAt(const LightPair& light, const PictureOrder& order, const QPoint& pixel)
{
    const auto at = scenePixel(order, pixel);
    if (!at)
        return std::nullopt;
    const Image& image = at->isKept ? light.kept : light.now;
    if (at->pixel.x() < 0 || at->pixel.y() < 0 || at->pixel.x() >= image.width || at->pixel.y() >= image.height)
        return std::nullopt;
    const float* t = image.texel(at->pixel.x(), at->pixel.y());
    return glm::vec3(t[0], t[1], t[2]);
}

Clipping clippingOf(const LightPair& light, const PictureOrder& order)
{
    Clipping clipping{.marks = QImage(order.size, QImage::Format_ARGB32_Premultiplied)};
    clipping.marks.fill(Qt::transparent);
    const float factor = std::exp2(order.settings.exposure); // the snapshot is exposed as now, too
    const int stripe = std::max(1, static_cast<int>(std::lround(4.0f * order.settings.pixelRatio)));
    qint64 above = 0, below = 0;
    for (int y = 0; y < order.size.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(clipping.marks.scanLine(y));
        for (int x = 0; x < order.size.width(); ++x) {
            const auto radiance = lightAt(light, order, {x, y});
            const Clip clip = radiance ? clipOf(factor * *radiance) : Clip::Inside;
            if (clip == Clip::Inside)
                continue;
            ++(clip == Clip::Above ? above : below);
            if ((x + y) / stripe % 2 == 0)
                row[x] = clip == Clip::Above ? aboveMark : belowMark;
        }
    }
    const double pixels = std::max(1.0, double(order.size.width()) * order.size.height());
    clipping.above = static_cast<double>(above) / pixels;
    clipping.below = static_cast<double>(below) / pixels;
    return clipping;
}

// As composite.vert: also for an orthographic camera.
glm::dvec3 backgroundDirection(const preview::RenderSettings& settings, const QPoint& pixel)
{
    const glm::dvec2 extent(settings.camera.halfExtent(float(settings.width) / float(settings.height)));
    const glm::dvec2 corner(2.0 * (pixel.x() + 0.5) / settings.width - 1.0, 1.0 - 2.0 * (pixel.y() + 0.5) / settings.height);
    const glm::dvec3 seen = glm::dmat3(settings.camera.cameraToWorld()) * glm::dvec3(corner * extent, -1.0);
    return yawed(glm::normalize(seen), -settings.yaw);
}

} // namespace mirrorball::studio
