#pragma once

#include "gl_object.h"

#include "core/image/image.h"

#include <vector>

namespace mirrorball::preview {

/// A framebuffer with color textures of one format and, if asked for, a depth buffer.
struct RenderTarget {
    int width = 0;
    int height = 0;
    int samples = 1;
    GLenum format = GL_NONE;
    std::vector<GlObject> colors{};
    GlObject depth{};
    GlObject framebuffer{};

    RenderTarget() = default;
    /// @param depthFormat GL_NONE for no depth buffer
    /// @throws WorkError when the driver does not draw to such a target
    RenderTarget(int width, int height, int samples, GLenum format, int colorCount, GLenum depthFormat);
    bool fits(int width_, int height_, int samples_, GLenum format_) const
    {
        return width == width_ && height == height_ && samples == samples_ && format == format_;
    }
};

/// One color texture of a target with one sample, top row first: two channels of GL_RG32F, four of other formats.
Image readImage(const RenderTarget& target, int colorIndex = 0);

} // namespace mirrorball::preview
