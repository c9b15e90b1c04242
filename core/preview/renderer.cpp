#include "render_resources.h"

#include "window_mesh.h"

#include "core/base/error.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace mirrorball::preview {

namespace {

Mesh buildMesh(const Geometry& geometry)
{
    switch (geometry.kind) {
    case GeometryKind::Torus:
        return torusMesh(0.7f, 0.3f, 8 * geometry.level, 4 * geometry.level);
    case GeometryKind::Sphere:
        return sphereMesh(1.0f, 2 * geometry.level);
    case GeometryKind::Box:
        return boxMesh();
    case GeometryKind::Window:
        return windowMesh();
    case GeometryKind::Teapot:
        break;
    }
    return teapotMesh(geometry.level);
}

PixelRectangle intersection(const PixelRectangle& a, const PixelRectangle& b)
{
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

void checkPixel(const RenderSettings& settings, int x, int y)
{
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height)
        throw InvalidArgument("pick: pixel " + std::to_string(x) + ", " + std::to_string(y) + " lies outside the picture");
}

} // namespace

Renderer::Resources::Resources(TexelFormat format_) : format(format_), emptyVertexArray(makeVertexArray()) {}

const MeshBuffer& Renderer::Resources::mesh(const Geometry& wanted)
{
    if (!meshBuffer || wanted != geometry) {
        meshBuffer = std::make_unique<MeshBuffer>(wanted.mesh ? *wanted.mesh : buildMesh(wanted));
        geometry = wanted;
    }
    return *meshBuffer;
}

RenderTarget& Renderer::Resources::target(RenderTarget& slot, int width, int height, int samples, GLenum colorFormat, int count,
                                          GLenum depthFormat)
{
    if (!slot.fits(width, height, samples, colorFormat)) {
        slot = RenderTarget(); // the old one goes before the new one comes
        slot = RenderTarget(width, height, samples, colorFormat, count, depthFormat);
    }
    return slot;
}

// Multisampling costs memory traffic by the sample, and only the object has edges: it alone is drawn multisampled, in the rectangle that
// it can touch, with its coverage in alpha. One pass then lays the mean of the samples over the background, which all samples of a
// pixel share; beside the rectangle the background is all there is.
void Renderer::Resources::drawScene(const RenderSettings& settings, const RenderMaps& maps, Output output, const Destination& destination)
{
    const NeededMaps needed = neededMaps(settings);
    if (!needed.specular)
        specular.release();
    if (!needed.specular || !settings.material.hasBrdf)
        brdfLookups.release();
    if (!needed.viewStack)
        viewStack.release();
    if (!needed.diffuse)
        diffuse.release();
    if (!needed.clearCoat)
        clearCoat.release();
    if (!needed.background)
        background.release();
    if (!needed.diffusePicture)
        diffusePicture.release();
    if (!needed.fleckPattern)
        fleckPattern.release();
    if (!needed.normalMap)
        normalMap.release();

    displayTables.update(output == Output::Display ? settings.display : nullptr);
    if (!needed.sphereMap)
        for (SphereMapTexture& map : sphereMaps)
            map.release();

    // Tone-mapped values fit a half; radiance may hold a sun of 1e6.
    const GLenum colorFormat = output == Output::Radiance ? GL_RGBA32F : GL_RGBA16F;
    const RenderTarget& object =
        target(objectTarget, settings.width, settings.height, settings.samples, colorFormat, 1, GL_DEPTH_COMPONENT32F);
    const PixelRectangle inside = beginObject(settings, object);
    if (settings.shading == Shading::Material)
        drawMaterial(settings, maps, output);
    else
        drawDebug(settings, maps, output);
    if (settings.shading == Shading::Material && output == Output::Display && settings.samples > 1 && settings.smoothEdges)
        smoothEdges(settings, maps, output, object);

    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, destination.framebuffer);
    glViewport(destination.x, destination.y, settings.width, settings.height);
    const int right = inside.x + inside.width, top = inside.y + inside.height;
    const PixelRectangle whole{0, 0, settings.width, settings.height};
    const auto composite = [&](const PixelRectangle& part, const GlObject* samples) {
        drawComposite(settings, maps, output, destination, intersection(part, destination.clip.value_or(whole)), samples);
    };
    composite({0, 0, settings.width, inside.y}, nullptr);
    composite({0, top, settings.width, settings.height - top}, nullptr);
    composite({0, inside.y, inside.x, inside.height}, nullptr);
    composite({right, inside.y, settings.width - right, inside.height}, nullptr);
    composite(inside, &object.colors[0]);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(0);
}

Renderer::Renderer(TexelFormat format) : m_format(format) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Renderer::Resources& Renderer::resources()
{
    if (!m_resources) {
        if (epoxy_gl_version() < 45 || !epoxy_is_desktop_gl())
            throw WorkError(
                "the preview needs OpenGL 4.5 and this context has less; install a newer driver or set LIBGL_ALWAYS_SOFTWARE=1");
        m_resources = std::make_unique<Resources>(m_format);
    }
    return *m_resources;
}

void Renderer::release() { m_resources.reset(); }

void Renderer::patchSphereMap(const Image& texels, int x, int y, int level)
{
    const SphereMapTexture& map = resources().sphereMaps[0];
    const int size = map.source() ? map.source()->levels.front().width >> level : 0;
    if (texels.channels != 4 || x < 0 || y < 0 || x + texels.width > size || y + texels.height > size)
        throw InvalidArgument("sphere map: the new texels do not lie inside level " + std::to_string(level) + " of the map that is shown");
    resources().sphereMaps[0].patch(texels, x, y, level);
}

Image Renderer::renderRadiance(const RenderSettings& settings, const RenderMaps& maps)
{
    validate(settings);
    Resources& r = resources();
    const RenderTarget& picture = r.target(r.pictureTarget, settings.width, settings.height, 1, GL_RGBA32F, 1, GL_NONE);
    r.drawScene(settings, maps, Output::Radiance, {.framebuffer = picture.framebuffer});
    return readImage(picture);
}

void Renderer::drawDisplay(const RenderSettings& settings, const RenderMaps& maps, const Destination& destination)
{
    validate(settings);
    resources().drawScene(settings, maps, Output::Display, destination);
}

PixelRectangle Renderer::objectPart(const RenderSettings& settings)
{
    validate(settings);
    return resources().objectPart(settings);
}

Image Renderer::renderDisplay(const RenderSettings& settings, const RenderMaps& maps)
{
    validate(settings);
    Resources& r = resources();
    const RenderTarget& picture = r.target(r.pictureTarget, settings.width, settings.height, 1, GL_RGBA8, 1, GL_NONE);
    r.drawScene(settings, maps, Output::Display, {.framebuffer = picture.framebuffer});
    return readImage(picture);
}

GeometryBuffers Renderer::renderBuffers(const RenderSettings& settings)
{
    validate(settings);
    Resources& r = resources();
    const RenderTarget& buffers = r.target(r.bufferTarget, settings.width, settings.height, 1, GL_RGBA32F, 3, GL_DEPTH_COMPONENT32F);
    r.drawBuffers(settings, buffers, {0, 0});
    return {readImage(buffers, 0), readImage(buffers, 1), readImage(buffers, 2)};
}

std::optional<SurfaceHit> Renderer::pick(const RenderSettings& settings, int x, int y)
{
    validate(settings);
    checkPixel(settings, x, y);
    Resources& r = resources();
    const RenderTarget& pixel = r.target(r.pickTarget, 1, 1, 1, GL_RGBA32F, 5, GL_DEPTH_COMPONENT32F);
    r.drawBuffers(settings, pixel, {x, settings.height - 1 - y});
    const auto read = [&](int index) {
        const Image image = readImage(pixel, index);
        return glm::vec4(image.texels[0], image.texels[1], image.texels[2], image.texels[3]);
    };
    const glm::vec4 position = read(0);
    if (position.w == 0.0f)
        return std::nullopt;
    return SurfaceHit{.position = position, .normal = read(1), .texCoord = glm::vec2(read(3)), .reflected = read(4), .lookup = read(2)};
}

std::optional<float> Renderer::level(const RenderSettings& settings, const RenderMaps& maps, int x, int y)
{
    validate(settings);
    checkPixel(settings, x, y);
    if (!neededMaps(settings).specular || settings.material.hasBrdf || !maps.specular || maps.specular->size() < 2)
        return std::nullopt;
    Resources& r = resources();
    // A footprint is a difference inside of a quad of 2 x 2 pixels: the same quad as in the whole picture.
    const RenderTarget& quad = r.target(r.levelTarget, 2, 2, 1, GL_RGBA32F, 1, GL_DEPTH_COMPONENT32F);
    const glm::ivec2 pixel(x, settings.height - 1 - y), corner = pixel & ~1;
    r.drawLevel(settings, maps, quad, corner);
    const Image levels = readImage(quad);
    const float* level = levels.texel(pixel.x - corner.x, 1 - (pixel.y - corner.y));
    return level[3] == 0.0f ? std::nullopt : std::optional(level[0]);
}

DiscPlaces Renderer::discPlaces(const RenderSettings& settings, SphereMapIndex index)
{
    validate(settings);
    Resources& r = resources();
    const RenderTarget& places = r.target(r.placesTarget, settings.width, settings.height, 1, GL_RG32F, 1, GL_DEPTH_COMPONENT32F);
    r.drawDiscPlaces(settings, index, places);
    return {readImage(places)};
}

} // namespace mirrorball::preview
