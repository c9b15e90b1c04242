#pragma once

#include "disc_places.h"
#include "render_settings.h"

#include <memory>
#include <optional>

namespace mirrorball::preview {

/// What a picture's pixels were computed from. Four channels each; the fourth is 1 on the object and 0 beside it.
struct GeometryBuffers {
    Image position{};  ///< world space
    Image normal{};    ///< unit, world space, turned towards the viewer
    Image direction{}; ///< of the specular lookup, in the space of the map (yaw or eye space applied)
};

/// What the object shows in one pixel. Directions are unit vectors.
struct SurfaceHit {
    glm::vec3 position{}; ///< world space
    glm::vec3 normal{};   ///< world space, turned towards the viewer
    glm::vec2 texCoord{};
    glm::vec3 reflected{}; ///< mirror direction, world space
    glm::vec3 lookup{};    ///< mirror direction in the space of the specular map (yaw or eye space applied)
};

/// Pixels [x, x + width) x [y, y + height), from the lower left.
struct PixelRectangle {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const PixelRectangle&) const = default;
};

/// Where a picture goes: into a framebuffer of the current context, its lower left corner at (x, y), as much of it as the clip holds.
struct Destination {
    unsigned framebuffer = 0;
    int x = 0;
    int y = 0;
    std::optional<PixelRectangle> clip{}; ///< in pixels of the picture; nothing: all of it
};

/// Draws an object under an environment in the OpenGL 4.5 core context that is current: an OffscreenContext or a window's.
///
/// Rows of images run from the top. Anti-aliasing shades once per pixel and tests coverage per sample. A *display* picture applies
/// exposure and tone curve to each sample and averages afterwards, so that the edge of a sun is smooth; a *radiance* picture is the
/// plain mean of the samples, unexposed, as an .exr should hold it.
///
/// Textures, shaders and meshes are made when first needed and kept while the same pointers and settings come in. They belong to the
/// context: make it current before the renderer dies, or call release() while it is - QOpenGLContext::aboutToBeDestroyed is the place.
class Renderer {
public:
    explicit Renderer(TexelFormat format = TexelFormat::Half);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Scene-linear RGBA, not exposed. Alpha is 1 but for Backdrop::None, where it is the object's coverage.
    /// @throws InvalidArgument for settings out of range or a map that is needed and missing; WorkError when the current context is not
    ///         OpenGL 4.5, as all that draw do
    Image renderRadiance(const RenderSettings& settings, const RenderMaps& maps);

    /// RGBA in [0, 1], exposed, tone-mapped and sRGB-encoded; then the color is multiplied by alpha. Quantized to 8 bits.
    Image renderDisplay(const RenderSettings& settings, const RenderMaps& maps);

    /// The same picture into a framebuffer of the current context: what a window's paint function calls. Sizes are in device pixels.
    /// Leaves blending, depth and scissor tests off, no program and no vertex array bound, and the viewport on the picture.
    void drawDisplay(const RenderSettings& settings, const RenderMaps& maps, const Destination& destination);

    /// The part of such a picture that the object can touch: beside it is nothing but background.
    PixelRectangle objectPart(const RenderSettings& settings);

    /// One sample per pixel. A normal map tilts normals as it did in the last picture: it has no maps of its own, nor have pick() and
    /// discPlaces().
    GeometryBuffers renderBuffers(const RenderSettings& settings);

    /// What one pixel of the picture shows, x and y from the upper left; nothing beside the object. Draws that pixel only.
    std::optional<SurfaceHit> pick(const RenderSettings& settings, int x, int y);

    /// The mip level that the specular lookup of one pixel reads, x and y from the upper left, as Shading::Mips colors it; nothing beside
    /// the object, where no specular map of levels is read, or where a BRDF reads several of them. Draws that pixel only.
    std::optional<float> level(const RenderSettings& settings, const RenderMaps& maps, int x, int y);

    /// Where each pixel looks a painted sphere map up that is indexed so; through a window, the nearest layer outside. One sample per
    /// pixel.
    DiscPlaces discPlaces(const RenderSettings& settings, SphereMapIndex index);

    /// Puts new texels into one level of the painted sphere map that the last picture read, their upper left one at (x, y): what a stroke
    /// touched, without a new map. The next picture must be handed the same pointer. @param texels RGBA, colors multiplied by opacity
    void patchSphereMap(const Image& texels, int x, int y, int level);

    /// Gives back all that it holds in the current context. The next picture makes it anew, in whichever context is current then.
    void release();

private:
    struct Resources;
    Resources& resources();

    TexelFormat m_format;
    std::unique_ptr<Resources> m_resources;
};

} // namespace mirrorball::preview
