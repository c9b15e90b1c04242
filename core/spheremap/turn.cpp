#include "turn.h"

#include "resample.h"

#include "../sphere/direction.h"

#include <glm/glm.hpp>

namespace mirrorball {

namespace {

/// Reads everything below at the place that `source` gives for each point of the disc, |q| <= 1.
template <typename Source>
Warp resampling(int size, Source source)
{
    const TexelRect all{0, 0, size, size};
    const auto whole = [all](const TexelRect&) { return all; };
    const auto apply = [size, source](const Image& below, const TexelRect& given, const TexelRect& wanted, const JobControl& job) {
        Image result(wanted.width(), wanted.height(), 4);
        const float texel = 2.0f / static_cast<float>(size), half = 0.5f * static_cast<float>(size);
        parallelRows(result.height, job, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < result.width; ++x) {
                    glm::vec2 q((static_cast<float>(wanted.x0 + x) + 0.5f) * texel - 1.0f, 1.0f - (static_cast<float>(wanted.y0 + y) + 0.5f) * texel);
                    const float length = glm::length(q);
                    if (length > 1.0f)
                        q /= length;
                    q = source(q);
                    sampleSmoothly<4>(below, half * (1.0f + q.x) - static_cast<float>(given.x0),
                                      half * (1.0f - q.y) - static_cast<float>(given.y0), result.texel(x, y));
                    float& opacity = result.texel(x, y)[3];
                    opacity = std::min(opacity, 1.0f);
                }
        });
        return result;
    };
    return {.needs = whole, .reaches = whole, .apply = apply};
}

} // namespace

Warp prepare(const TwistLayer& layer, const Level& level)
{
    const auto angle = static_cast<float>(layer.angleDeg * pi / 180.0), inverse = static_cast<float>(1.0 / layer.radius);
    return resampling(level.size, [angle, inverse](const glm::vec2& q) {
        const float far = std::max(1.0f - glm::length(q) * inverse, 0.0f), turn = angle * far * far;
        const float c = std::cos(turn), s = std::sin(turn);
        return glm::vec2(c * q.x + s * q.y, c * q.y - s * q.x);
    });
}

Warp prepare(const RotateLayer& layer, const Level& level)
{
    const auto radians = [](double degrees) { return static_cast<float>(degrees * pi / 180.0); };
    const float ca = std::cos(radians(layer.angleDeg)), sa = std::sin(radians(layer.angleDeg));
    const float cr = std::cos(radians(layer.rightDeg)), sr = std::sin(radians(layer.rightDeg));
    const float cu = std::cos(radians(layer.upDeg)), su = std::sin(radians(layer.upDeg));
    return resampling(level.size, [=](const glm::vec2& q) {
        glm::vec3 n(q, std::sqrt(std::max(1.0f - glm::dot(q, q), 0.0f)));
        n = {n.x, cu * n.y - su * n.z, su * n.y + cu * n.z}; // undo up, right, angle
        n = {cr * n.x - sr * n.z, n.y, sr * n.x + cr * n.z};
        n = {ca * n.x + sa * n.y, ca * n.y - sa * n.x, n.z};
        glm::vec2 source(n.x, n.y);
        if (n.z < 0.0f) // from the back: the rim
            source /= std::max(glm::length(source), 1e-6f);
        return source;
    });
}

} // namespace mirrorball
