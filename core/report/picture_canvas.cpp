#include "picture_canvas.h"

#include "core/image/text_picture.h"

#include <algorithm>
#include <cmath>

namespace mirrorball {

namespace {

constexpr float dotRadius = 3.0f;

/// How much of each pixel of a picture is covered.
class Cover {
public:
    Cover(int width, int height) : m_width(width), m_height(height), m_shares(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

    /// All that is no further than `radius` from the way from a to b.
    void add(const glm::vec2& a, const glm::vec2& b, float radius)
    {
        const glm::vec2 low = glm::min(a, b) - radius - 1.0f, high = glm::max(a, b) + radius + 1.0f, along = b - a;
        const float length2 = glm::dot(along, along);
        for (int y = std::max(static_cast<int>(low.y), 0); y <= std::min(static_cast<int>(high.y), m_height - 1); ++y)
            for (int x = std::max(static_cast<int>(low.x), 0); x <= std::min(static_cast<int>(high.x), m_width - 1); ++x) {
                const glm::vec2 p = glm::vec2(x, y) + 0.5f - a;
                const float t = length2 > 0.0f ? std::clamp(glm::dot(p, along) / length2, 0.0f, 1.0f) : 0.0f;
                float& place = m_shares[index(x, y)];
                place = std::max(place, std::clamp(radius + 0.5f - glm::length(p - t * along), 0.0f, 1.0f));
            }
    }
    float at(int x, int y) const { return m_shares[index(x, y)]; }

private:
    size_t index(int x, int y) const { return static_cast<size_t>(y) * static_cast<size_t>(m_width) + static_cast<size_t>(x); }
    int m_width, m_height;
    std::vector<float> m_shares;
};

} // namespace

PictureCanvas::PictureCanvas(int width, int height) : m_image(width, height, 3, 1.0f) {}

void PictureCanvas::blend(int x, int y, const glm::vec3& color, float cover)
{
    if (x < 0 || y < 0 || x >= m_image.width || y >= m_image.height)
        return;
    float* texel = m_image.texel(x, y);
    for (int c = 0; c < 3; ++c)
        texel[c] += cover * (color[c] - texel[c]);
}

void PictureCanvas::text(const std::string& words, glm::ivec2 at, const glm::vec3& color)
{
    const Image letters = textPicture(words, 1);
    for (int y = 0; y < letters.height; ++y)
        for (int x = 0; x < letters.width; ++x)
            blend(at.x + x, at.y + y, color, *letters.texel(x, y));
}

void PictureCanvas::line(const std::vector<glm::vec2>& points, const glm::vec3& color, const LineStyle& style)
{
    Cover cover(m_image.width, m_image.height);
    for (size_t i = 0; i < points.size(); ++i) {
        if (style.isDotted)
            cover.add(points[i], points[i], dotRadius);
        if (i + 1 < points.size())
            cover.add(points[i], points[i + 1], 0.5f * style.width);
    }
    for (int y = 0; y < m_image.height; ++y)
        for (int x = 0; x < m_image.width; ++x)
            blend(x, y, color, cover.at(x, y));
}

void PictureCanvas::dot(const glm::vec2& at, float radius, const glm::vec3& color)
{
    const int reach = static_cast<int>(std::ceil(radius)) + 1, left = static_cast<int>(at.x), top = static_cast<int>(at.y);
    for (int y = top - reach; y <= top + reach; ++y)
        for (int x = left - reach; x <= left + reach; ++x)
            blend(x, y, color, std::clamp(radius + 0.5f - glm::length(glm::vec2(x, y) + 0.5f - at), 0.0f, 1.0f));
}

} // namespace mirrorball
