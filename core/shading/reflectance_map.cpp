#include "reflectance_map.h"

#include "core/base/error.h"
#include "core/image/color_scale.h"
#include "core/sphere/direction.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

constexpr double lastIncidence = 80.0 * pi / 180.0, nearMirror = 15.0 * pi / 180.0;
constexpr int nearSteps = 15;

void check(int size)
{
    if (size < 1 || size > 4096)
        throw InvalidArgument("size: must be a whole number from 1 to 4096");
}

glm::dvec3 inPlane(double angle) { return {std::sin(angle), 0.0, std::cos(angle)}; }

glm::dvec3 mirrored(const Brdf& brdf, double incidence)
{
    const glm::dvec3 l = inPlane(-incidence);
    if (!std::holds_alternative<MeasuredBrdf>(brdf.model))
        return evaluate(brdf, l, inPlane(incidence));
    glm::dvec3 strongest(0.0);
    for (int i = -nearSteps; i <= nearSteps; ++i)
        strongest = glm::max(strongest, evaluate(brdf, l, inPlane(std::min(incidence + nearMirror * i / nearSteps, 0.499 * pi))));
    return strongest;
}

/// The disc's texels: `value` of a place in it.
template <typename Value>
Image disc(int size, Value&& value)
{
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::dvec2 place(2.0 * (x + 0.5) / size - 1.0, 1.0 - 2.0 * (y + 0.5) / size);
            if (glm::dot(place, place) >= 1.0)
                continue;
            const glm::dvec3 v = value(place);
            for (int c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(v[c]);
        }
    return image;
}

} // namespace

Image mirrorReflectanceMap(const Brdf& brdf, int size)
{
    check(size);
    // A table over the angle: measurements are read slowly.
    constexpr int steps = 320;
    std::vector<glm::dvec3> byAngle;
    for (int i = 0; i <= steps; ++i)
        byAngle.push_back(mirrored(brdf, lastIncidence * i / steps));
    const glm::dvec3& last = byAngle.back();
    const double largest = std::max({last.r, last.g, last.b, 1e-300});
    return disc(size, [&](const glm::dvec2& place) {
        const double x = std::min(std::asin(glm::length(place)) / lastIncidence, 1.0) * steps;
        const auto i = std::min(static_cast<size_t>(x), static_cast<size_t>(steps - 1));
        return glm::mix(byAngle[i], byAngle[i + 1], x - static_cast<double>(i)) / largest;
    });
}

Image hemisphereMap(const Brdf& brdf, double incidence, int size)
{
    check(size);
    const glm::dvec3 l = inPlane(-incidence);
    return disc(size, [&](const glm::dvec2& place) {
        return evaluate(brdf, l, {place, std::sqrt(std::max(1.0 - glm::dot(place, place), 1e-6))});
    });
}

Image falseColored(const Image& disc)
{
    const auto mean = [&](int x, int y) {
        const float* t = disc.texel(x, y);
        return (t[0] + t[1] + t[2]) / 3.0f;
    };
    const auto isInside = [&](int x, int y) {
        return glm::length(glm::dvec2(2.0 * (x + 0.5) / disc.width - 1.0, 2.0 * (y + 0.5) / disc.height - 1.0)) < 1.0;
    };
    std::vector<float> values;
    for (int y = 0; y < disc.height; ++y)
        for (int x = 0; x < disc.width; ++x)
            if (isInside(x, y))
                values.push_back(mean(x, y));
    Image picture(disc.width, disc.height);
    std::fill(picture.texels.begin(), picture.texels.end(), 1.0f);
    if (values.empty())
        return picture;
    const auto high = values.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), high, values.end());
    for (int y = 0; y < disc.height; ++y)
        for (int x = 0; x < disc.width; ++x)
            if (isInside(x, y)) {
                const glm::vec3 color = falseColor(*high > 0.0f ? mean(x, y) / *high : 0.0);
                std::copy_n(&color.x, 3, picture.texel(x, y));
            }
    return picture;
}

} // namespace mirrorball
