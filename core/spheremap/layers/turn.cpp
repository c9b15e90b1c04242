#include "turn.h"

#include "core/spheremap/math/resample.h"

#include "core/sphere/direction.h"

#include <glm/glm.hpp>

namespace mirrorball {

namespace {

/// A circle on the disc; at least as wide as the disc where nothing better is known.
struct Circle {
    glm::vec2 center{0.0f};
    float radius = 4.0f;
};

/// What a warp reads, and what it reaches, by blocks of texels: of each block it is known in which circle its sources lie.
template <typename Around>
class Blocks {
public:
    Blocks(int size, Around around) : m_size(size), m_around(around) {}

    TexelRect needs(const TexelRect& wanted) const
    {
        TexelRect all;
        if (wanted == whole())
            return whole();
        forEach(wanted, [&](const TexelRect&, const TexelRect& sources) { all = all.united(sources); });
        return all.intersected(whole());
    }
    TexelRect reaches(const TexelRect& touched) const
    {
        TexelRect all;
        forEach(whole(), [&](const TexelRect& block, const TexelRect& sources) {
            if (!sources.intersected(touched).empty())
                all = all.united(block);
        });
        return all;
    }

private:
    static constexpr int edge = 8;       ///< texels of a block
    static constexpr float reach = 3.0f; ///< texels that sampleSmoothly() reads around a place, and a little

    TexelRect whole() const { return {0, 0, m_size, m_size}; }

    template <typename Use>
    void forEach(const TexelRect& rect, Use use) const
    {
        const float half = 0.5f * static_cast<float>(m_size), spread = 0.7072f * edge / half;
        for (int y = rect.y0 / edge * edge; y < rect.y1; y += edge)
            for (int x = rect.x0 / edge * edge; x < rect.x1; x += edge) {
                glm::vec2 q(static_cast<float>(x + edge / 2) / half - 1.0f, 1.0f - static_cast<float>(y + edge / 2) / half);
                if (const float length = glm::length(q); length > 1.0f) // what lies outside is drawn to the rim, which draws nothing apart
                    q /= length;
                const Circle circle = m_around(q, spread);
                const float r = half * circle.radius + reach, cx = half * (1.0f + circle.center.x), cy = half * (1.0f - circle.center.y);
                const auto low = [](float v) { return static_cast<int>(std::floor(v)); };
                use(TexelRect{x, y, std::min(x + edge, m_size), std::min(y + edge, m_size)},
                    TexelRect{low(cx - r), low(cy - r), low(cx + r) + 1, low(cy + r) + 1});
            }
    }

    int m_size;
    Around m_around;
};

/// Reads everything below at the place that `source` gives for each point of the disc, |q| <= 1.
/// @param around  around(q, h): where the sources of all points of the disc within h of q lie
template <typename Source, typename Around>
Warp resampling(int size, Source source, Around around)
{
    const Blocks<Around> blocks(size, around);
    const auto apply = [size, source](const Image& below, const TexelRect& given, const TexelRect& wanted, const JobControl& job) {
        Image result(wanted.width(), wanted.height(), 4);
        const float texel = 2.0f / static_cast<float>(size), half = 0.5f * static_cast<float>(size);
        parallelRows(result.height, job, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < result.width; ++x) {
                    glm::vec2 q((static_cast<float>(wanted.x0 + x) + 0.5f) * texel - 1.0f,
                                1.0f - (static_cast<float>(wanted.y0 + y) + 0.5f) * texel);
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
    return {.needs = [blocks](const TexelRect& wanted) { return blocks.needs(wanted); },
            .reaches = [blocks](const TexelRect& touched) { return blocks.reaches(touched); },
            .apply = apply};
}

} // namespace

// A turn by t(r) draws points apart by at most 1 + r |t'(r)| = 1 + 2 |angle| x (1 - x), x = r / radius: 1 + |angle| / 2 at its middle.
Warp prepare(const TwistLayer& layer, const Level& level)
{
    const auto angle = static_cast<float>(layer.angleDeg * pi / 180.0), inverse = static_cast<float>(1.0 / layer.radius);
    const auto source = [angle, inverse](const glm::vec2& q) {
        const float far = std::max(1.0f - glm::length(q) * inverse, 0.0f), turn = angle * far * far;
        const float c = std::cos(turn), s = std::sin(turn);
        return glm::vec2(c * q.x + s * q.y, c * q.y - s * q.x);
    };
    return resampling(level.size, source, [source, stretch = 1.0f + 0.5f * std::abs(angle)](const glm::vec2& q, float h) {
        return Circle{source(q), stretch * h};
    });
}

Warp prepare(const RotateLayer& layer, const Level& level)
{
    const auto radians = [](double degrees) { return static_cast<float>(degrees * pi / 180.0); };
    const float ca = std::cos(radians(layer.angleDeg)), sa = std::sin(radians(layer.angleDeg));
    const float cr = std::cos(radians(layer.rightDeg)), sr = std::sin(radians(layer.rightDeg));
    const float cu = std::cos(radians(layer.upDeg)), su = std::sin(radians(layer.upDeg));
    const auto onBall = [](const glm::vec2& q) { return glm::vec3(q, std::sqrt(std::max(1.0f - glm::dot(q, q), 0.0f))); };
    const auto turnedBack = [=](glm::vec3 n) { // undo up, right, angle
        n = {n.x, cu * n.y - su * n.z, su * n.y + cu * n.z};
        n = {cr * n.x - sr * n.z, n.y, sr * n.x + cr * n.z};
        return glm::vec3(ca * n.x + sa * n.y, ca * n.y - sa * n.x, n.z);
    };
    const auto source = [=](const glm::vec2& q) {
        const glm::vec3 n = turnedBack(onBall(q));
        glm::vec2 place(n.x, n.y);
        if (n.z < 0.0f) // from the back: the rim
            place /= std::max(glm::length(place), 1e-6f);
        return place;
    };
    // Turning keeps chords, and seen from the front a chord only shortens. From the back, points a chord c apart come to the rim in
    // directions at most asin(c / r) < 1.6 c / r apart, where r is how far one of them is from the axis.
    return resampling(level.size, source, [=](const glm::vec2& q, float h) -> Circle {
        const auto height = [](float r) { return std::sqrt(std::max(1.0f - r * r, 0.0f)); };
        const float length = std::min(glm::length(q), 1.0f), z = height(length);
        const float rise = std::max(height(std::max(length - h, 0.0f)) - z, z - height(std::min(length + h, 1.0f)));
        const float chord = std::sqrt(h * h + rise * rise);
        const glm::vec3 n = turnedBack(onBall(q));
        const glm::vec2 place(n.x, n.y);
        if (n.z > chord)
            return {place, chord};
        const float r = glm::length(place);
        if (r < 0.1f + chord)
            return {};
        return {place / r, (1.0f - std::min(r, 1.0f)) + chord + 1.6f * chord / r};
    });
}

} // namespace mirrorball
