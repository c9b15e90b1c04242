#pragma once

#include "render_settings.h"

#include <memory>

namespace mirrorball::preview {

/// What a picture's pixels were computed from. Four channels each; the fourth is 1 on the object and 0 beside it.
struct GeometryBuffers {
    Image position{};  ///< world space
    Image normal{};    ///< unit, world space, turned towards the viewer
    Image direction{}; ///< of the specular lookup, in the space of the map (yaw or eye space applied)
};

/// Draws an object under an environment in the OpenGL 4.5 core context that is current: an OffscreenContext or a window's.
///
/// Rows of images run from the top. Anti-aliasing shades once per pixel and tests coverage per sample. A *display* picture applies
/// exposure and tone curve to each sample and averages afterwards, so that the edge of a sun is smooth; a *radiance* picture is the
/// plain mean of the samples, unexposed, as an .exr should hold it.
///
/// Textures, shaders and meshes are made when first needed and kept while the same pointers and settings come in.
class Renderer {
public:
    /// @throws WorkError when the current context is not OpenGL 4.5
    explicit Renderer(TexelFormat format = TexelFormat::Half);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Scene-linear RGBA, not exposed. Alpha is 1 but for BackgroundKind::None, where it is the object's coverage.
    /// @throws InvalidArgument for settings out of range or a map that is needed and missing
    Image renderRadiance(const RenderSettings& settings, const RenderMaps& maps);

    /// RGBA in [0, 1], exposed, tone-mapped and sRGB-encoded; colour is premultiplied by alpha. Quantised to 8 bits.
    Image renderDisplay(const RenderSettings& settings, const RenderMaps& maps);

    /// The same picture into a framebuffer of the current context, at (0, 0): what a window's paint function calls.
    void drawDisplay(const RenderSettings& settings, const RenderMaps& maps, unsigned framebuffer);

    /// One sample per pixel.
    GeometryBuffers renderBuffers(const RenderSettings& settings);

private:
    struct Resources;
    std::unique_ptr<Resources> m_resources;
};

} // namespace mirrorball::preview
