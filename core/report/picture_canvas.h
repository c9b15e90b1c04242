#pragma once

#include "core/image/image.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace mirrorball {

/// A white picture to draw lines, dots and words on, where there is no window system that would: RGB as displayed, 0 to 1. Places are in
/// pixels from the upper left corner; what lies outside is left out.
class PictureCanvas {
public:
    PictureCanvas(int width, int height);

    void blend(int x, int y, const glm::vec3& color, float cover);
    /// @param at  upper left corner
    void text(const std::string& words, glm::ivec2 at, const glm::vec3& color);
    struct LineStyle {
        float width = 2.2f;
        bool isDotted = false; ///< with a dot on each point
    };
    /// A line through the points: each pixel by its distance, so that joints are covered once.
    void line(const std::vector<glm::vec2>& points, const glm::vec3& color, const LineStyle& style);
    void dot(const glm::vec2& at, float radius, const glm::vec3& color);
    Image take() { return std::move(m_image); }

private:
    Image m_image;
};

} // namespace mirrorball
