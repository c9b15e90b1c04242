#include "renderer.h"

#include "mesh_buffer.h"
#include "render_target.h"
#include "shader_program.h"
#include "texture.h"

#include "../error.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

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
    case GeometryKind::Teapot:
        break;
    }
    return teapotMesh(geometry.level);
}

// The turn from world directions to the map's: L'(d) = L(yawed(d, -yaw)).
glm::mat3 yawToMap(float yaw)
{
    return {glm::vec3(yawed({1, 0, 0}, -yaw)), glm::vec3(yawed({0, 1, 0}, -yaw)), glm::vec3(yawed({0, 0, 1}, -yaw))};
}

// The turn of the material's lookups.
glm::mat3 mapRotation(const RenderSettings& settings)
{
    return settings.material.space == LookupSpace::Eye ? glm::transpose(settings.camera.cameraToWorld()) : yawToMap(settings.yaw);
}

// One texture and the map it was made from. A pointer that comes back unchanged is the same map.
struct BoundMap {
    MapLevels source{};
    std::unique_ptr<EnvironmentTexture> texture{};

    const EnvironmentTexture& update(const MapLevels& levels, TexelFormat format, const char* role)
    {
        if (!levels || levels->empty())
            throw InvalidArgument(std::string("render maps: the picture needs a ") + role + " map and there is none");
        if (levels != source) {
            texture.reset();
            texture = std::make_unique<EnvironmentTexture>(*levels, format);
            source = levels;
        }
        return *texture;
    }
    void release()
    {
        texture.reset();
        source.reset();
    }
};

void addMapDefines(std::vector<ShaderDefine>& defines, const std::string& role, const EnvironmentTexture& texture)
{
    defines.emplace_back(role + "_KIND", std::to_string(static_cast<int>(texture.kind())));
    defines.emplace_back(role + "_MIPS", texture.levelCount() > 1 ? "1" : "0");
}

void bindMap(const ShaderProgram& program, const std::string& role, GLuint unit, const EnvironmentTexture& texture, const glm::mat3& rotation)
{
    texture.bind(unit);
    program.set((role + "Map").c_str(), static_cast<int>(unit));
    program.set((role + "Levels").c_str(), texture.levels());
    program.set((role + "Settings").c_str(), glm::vec4(texture.scale(), float(texture.levelCount() - 1), 0.0f, 0.0f));
    program.set((role + "Rotation").c_str(), rotation);
}

// Pixels [x, x + width) x [y, y + height), from the lower left.
struct PixelRectangle {
    int x, y, width, height;
};

// Where a box can show on the screen, with a pixel to spare. A box that reaches behind the eye can show anywhere.
PixelRectangle screenBounds(const BoundingBox& box, const glm::mat4& worldToClip, int width, int height)
{
    glm::vec2 low(1.0f), high(-1.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 clip = worldToClip * glm::vec4(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                                       corner & 4 ? box.high.z : box.low.z, 1.0f);
        if (clip.w <= 0.0f)
            return {0, 0, width, height};
        low = glm::min(low, glm::vec2(clip) / clip.w);
        high = glm::max(high, glm::vec2(clip) / clip.w);
    }
    const auto pixel = [](float ndc, int size, int margin) {
        return std::clamp(static_cast<int>(std::floor((0.5 + 0.5 * glm::clamp(ndc, -1.5f, 1.5f)) * size)) + margin, 0, size);
    };
    const int x0 = pixel(low.x, width, -1), y0 = pixel(low.y, height, -1);
    return {x0, y0, pixel(high.x, width, 2) - x0, pixel(high.y, height, 2) - y0};
}

glm::mat4 worldToClip(const RenderSettings& settings, const BoundingBox& box)
{
    const glm::vec3 farthest = glm::max(glm::abs(box.low - settings.camera.target), glm::abs(box.high - settings.camera.target));
    return settings.camera.worldToClip(float(settings.width) / float(settings.height), 1.01f * glm::length(farthest));
}

enum class Output { Display, Radiance };

void addOutputDefines(std::vector<ShaderDefine>& defines, const RenderSettings& settings, Output output)
{
    defines.emplace_back("OUTPUT_RADIANCE", output == Output::Radiance ? "1" : "0");
    defines.emplace_back("TONE_CURVE", output == Output::Radiance ? "0" : std::to_string(static_cast<int>(settings.toneCurve)));
}

} // namespace

struct Renderer::Resources {
    explicit Resources(TexelFormat format_) : format(format_), emptyVertexArray(makeVertexArray()) {}

    const ShaderProgram& program(const char* vertex, const char* fragment, const std::vector<ShaderDefine>& defines = {});
    const MeshBuffer& mesh(const Geometry& geometry);
    RenderTarget& target(RenderTarget& slot, const RenderSettings& settings, int samples, GLenum colorFormat, int count, GLenum depthFormat);
    PixelRectangle beginObject(const RenderSettings& settings, const RenderTarget& target);
    void drawMesh(const RenderSettings& settings, const ShaderProgram& shader);
    void drawObject(const RenderSettings& settings, const RenderMaps& maps, Output output);
    void drawComposite(const RenderSettings& settings, const RenderMaps& maps, Output output, const PixelRectangle& part, const GlObject* object);
    void drawScene(const RenderSettings& settings, const RenderMaps& maps, Output output, GLuint framebuffer);

    TexelFormat format;
    GlObject emptyVertexArray;
    BoundMap specular, diffuse, background;
    std::map<std::string, ShaderProgram> programs; // by everything that they were compiled from
    Geometry geometry;
    std::unique_ptr<MeshBuffer> meshBuffer;
    RenderTarget objectTarget, pictureTarget, bufferTarget;
};

const ShaderProgram& Renderer::Resources::program(const char* vertex, const char* fragment, const std::vector<ShaderDefine>& defines)
{
    std::string key = std::string(vertex) + ' ' + fragment;
    for (const auto& [name, value] : defines)
        key += ' ' + name + '=' + value;
    const auto found = programs.find(key);
    return found != programs.end() ? found->second : programs.emplace(key, ShaderProgram(vertex, fragment, defines)).first->second;
}

const MeshBuffer& Renderer::Resources::mesh(const Geometry& wanted)
{
    if (!meshBuffer || wanted != geometry) {
        meshBuffer = std::make_unique<MeshBuffer>(wanted.mesh ? *wanted.mesh : buildMesh(wanted));
        geometry = wanted;
    }
    return *meshBuffer;
}

RenderTarget& Renderer::Resources::target(RenderTarget& slot, const RenderSettings& settings, int samples, GLenum colorFormat, int count,
                                          GLenum depthFormat)
{
    if (!slot.fits(settings.width, settings.height, samples, colorFormat)) {
        slot = RenderTarget(); // the old one goes before the new one comes
        slot = RenderTarget(settings.width, settings.height, samples, colorFormat, count, depthFormat);
    }
    return slot;
}

// Clears the part of the target that the object can touch and leaves the scissor on it.
PixelRectangle Renderer::Resources::beginObject(const RenderSettings& settings, const RenderTarget& target)
{
    const BoundingBox& box = mesh(settings.geometry).bounds();
    const PixelRectangle part = screenBounds(box, worldToClip(settings, box), settings.width, settings.height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.width, target.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    const glm::vec4 nothing(0.0f);
    const float farthest = 1.0f;
    glDepthMask(GL_TRUE);
    for (size_t i = 0; i < target.colors.size(); ++i)
        glClearNamedFramebufferfv(target.framebuffer, GL_COLOR, static_cast<GLint>(i), &nothing.x);
    glClearNamedFramebufferfv(target.framebuffer, GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glDisable(GL_BLEND);
    return part;
}

void Renderer::Resources::drawMesh(const RenderSettings& settings, const ShaderProgram& shader)
{
    const MeshBuffer& buffer = mesh(settings.geometry);
    shader.set("worldToClip", worldToClip(settings, buffer.bounds()));
    shader.set("viewer", settings.camera.viewer());
    shader.use();
    buffer.draw();
}

void Renderer::Resources::drawObject(const RenderSettings& settings, const RenderMaps& maps, Output output)
{
    const MaterialSettings& material = settings.material;
    const NeededMaps needed = neededMaps(settings);
    std::vector<ShaderDefine> defines = {{"HAS_SPECULAR", needed.specular ? "1" : "0"},
                                         {"HAS_DIFFUSE", needed.diffuse ? "1" : "0"},
                                         {"FRESNEL", std::to_string(static_cast<int>(material.fresnel.kind))},
                                         {"COAT", material.combine == Combine::Coat ? "1" : "0"}};
    addOutputDefines(defines, settings, output);
    if (needed.specular)
        addMapDefines(defines, "SPECULAR", specular.update(maps.specular, format, "specular"));
    if (needed.diffuse)
        addMapDefines(defines, "DIFFUSE", diffuse.update(maps.diffuse, format, "diffuse"));

    const ShaderProgram& shader = program("preview/object.vert", "preview/object.frag", defines);
    if (needed.specular) {
        bindMap(shader, "specular", 0, *specular.texture, mapRotation(settings));
        shader.set("specularColor", material.specular);
        shader.set("lambda", material.lambda);
    }
    if (needed.diffuse) {
        bindMap(shader, "diffuse", 1, *diffuse.texture, mapRotation(settings));
        shader.set("diffuseColor", material.diffuse);
    }
    const double n = material.fresnel.index;
    shader.set("n2m1", static_cast<float>((n - 1.0) * (n + 1.0)));
    shader.set("conductorN", glm::vec3(material.fresnel.conductor.n));
    shader.set("conductorK", glm::max(glm::vec3(material.fresnel.conductor.k), 1e-6f));
    shader.set("exposure", std::exp2(settings.exposure));
    drawMesh(settings, shader);
}

// @param object the samples to lay over the background, or null where there are none
void Renderer::Resources::drawComposite(const RenderSettings& settings, const RenderMaps& maps, Output output, const PixelRectangle& part,
                                        const GlObject* object)
{
    if (part.width <= 0 || part.height <= 0)
        return;
    std::vector<ShaderDefine> defines = {{"OBJECT_SAMPLES", object ? std::to_string(settings.samples) : "0"}};
    addOutputDefines(defines, settings, output);
    const EnvironmentTexture* texture = nullptr;
    switch (settings.background.kind) {
    case BackgroundKind::None:
        defines.emplace_back("BACKGROUND", "0");
        break;
    case BackgroundKind::Color:
        defines.emplace_back("BACKGROUND", "1");
        break;
    case BackgroundKind::Environment:
        defines.emplace_back("BACKGROUND", "2");
        // The environment is often the specular map itself: one texture then serves both.
        texture = specular.texture && specular.source == maps.background ? specular.texture.get()
                                                                         : &background.update(maps.background, format, "background");
        addMapDefines(defines, "BACKGROUND", *texture);
        break;
    }

    const ShaderProgram& shader = program("preview/composite.vert", "preview/composite.frag", defines);
    if (texture)
        bindMap(shader, "background", 2, *texture, yawToMap(settings.yaw));
    if (object) {
        glBindTextureUnit(3, *object);
        shader.set("objectSamples", 3);
    }
    shader.set("backgroundColor", settings.background.color);
    shader.set("exposure", std::exp2(settings.exposure));
    shader.set("halfExtent", glm::vec3(settings.camera.halfExtent(float(settings.width) / float(settings.height)), 0.0f));
    shader.set("cameraToWorld", settings.camera.cameraToWorld());
    shader.use();
    glScissor(part.x, part.y, part.width, part.height);
    glBindVertexArray(emptyVertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

// Multisampling costs memory traffic by the sample, and only the object has edges: it alone is drawn multisampled, in the rectangle that
// it can touch, with its coverage in alpha. One pass then lays the mean of the samples over the background, which all samples of a
// pixel share; beside the rectangle the background is all there is.
void Renderer::Resources::drawScene(const RenderSettings& settings, const RenderMaps& maps, Output output, GLuint framebuffer)
{
    const NeededMaps needed = neededMaps(settings);
    if (!needed.specular)
        specular.release();
    if (!needed.diffuse)
        diffuse.release();
    if (!needed.background)
        background.release();

    // Tone-mapped values fit a half; radiance may hold a sun of 1e6.
    const GLenum colorFormat = output == Output::Radiance ? GL_RGBA32F : GL_RGBA16F;
    const RenderTarget& object = target(objectTarget, settings, settings.samples, colorFormat, 1, GL_DEPTH_COMPONENT32F);
    const PixelRectangle inside = beginObject(settings, object);
    drawObject(settings, maps, output);

    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const int right = inside.x + inside.width, top = inside.y + inside.height;
    drawComposite(settings, maps, output, {0, 0, settings.width, inside.y}, nullptr);
    drawComposite(settings, maps, output, {0, top, settings.width, settings.height - top}, nullptr);
    drawComposite(settings, maps, output, {0, inside.y, inside.x, inside.height}, nullptr);
    drawComposite(settings, maps, output, {right, inside.y, settings.width - right, inside.height}, nullptr);
    drawComposite(settings, maps, output, inside, &object.colors[0]);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(0);
}

Renderer::Renderer(TexelFormat format)
{
    if (epoxy_gl_version() < 45 || !epoxy_is_desktop_gl())
        throw WorkError("the preview needs OpenGL 4.5 and this context has less; install a newer driver or set LIBGL_ALWAYS_SOFTWARE=1");
    m_resources = std::make_unique<Resources>(format);
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::renderRadiance(const RenderSettings& settings, const RenderMaps& maps)
{
    validate(settings);
    const RenderTarget& picture = m_resources->target(m_resources->pictureTarget, settings, 1, GL_RGBA32F, 1, GL_NONE);
    m_resources->drawScene(settings, maps, Output::Radiance, picture.framebuffer);
    return readImage(picture);
}

void Renderer::drawDisplay(const RenderSettings& settings, const RenderMaps& maps, unsigned framebuffer)
{
    validate(settings);
    m_resources->drawScene(settings, maps, Output::Display, framebuffer);
}

Image Renderer::renderDisplay(const RenderSettings& settings, const RenderMaps& maps)
{
    validate(settings);
    const RenderTarget& picture = m_resources->target(m_resources->pictureTarget, settings, 1, GL_RGBA8, 1, GL_NONE);
    m_resources->drawScene(settings, maps, Output::Display, picture.framebuffer);
    return readImage(picture);
}

GeometryBuffers Renderer::renderBuffers(const RenderSettings& settings)
{
    validate(settings);
    Resources& r = *m_resources;
    const RenderTarget& buffers = r.target(r.bufferTarget, settings, 1, GL_RGBA32F, 3, GL_DEPTH_COMPONENT32F);
    glDisable(GL_SCISSOR_TEST);
    const glm::vec4 nothing(0.0f);
    for (GLint i = 0; i < 3; ++i)
        glClearNamedFramebufferfv(buffers.framebuffer, GL_COLOR, i, &nothing.x);
    r.beginObject(settings, buffers);
    const ShaderProgram& shader = r.program("preview/object.vert", "preview/buffers.frag");
    shader.set("specularRotation", mapRotation(settings));
    r.drawMesh(settings, shader);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(0);
    return {readImage(buffers, 0), readImage(buffers, 1), readImage(buffers, 2)};
}

} // namespace mirrorball::preview
