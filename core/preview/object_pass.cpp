#include "render_resources.h"

#include <algorithm>
#include <cmath>

namespace mirrorball::preview {

namespace {

// Where a box can show on the screen, with pixels to spare for lines along it. A box that reaches behind the eye can show anywhere.
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
    const int x0 = pixel(low.x, width, -3), y0 = pixel(low.y, height, -3);
    return {x0, y0, pixel(high.x, width, 4) - x0, pixel(high.y, height, 4) - y0};
}

// The turn of the material's lookups.
glm::mat3 mapRotation(const RenderSettings& settings)
{
    return settings.material.space == MapSpace::Eye ? glm::transpose(settings.camera.cameraToWorld()) : yawToMap(settings.yaw);
}

// The turn of the painted map's lookups.
glm::mat3 sphereRotation(const RenderSettings& settings)
{
    return settings.material.paint.space == MapSpace::Eye ? glm::transpose(settings.camera.cameraToWorld()) : yawToMap(settings.yaw);
}

void beginDrawing(const RenderTarget& target, const glm::vec4& nothing = glm::vec4(0.0f))
{
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
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

std::string number(int value) { return std::to_string(value); }

// SPHERE_USE of object.frag.
const char* useDefine(const std::optional<SphereMapUse>& use)
{
    if (!use)
        return "0";
    switch (*use) {
    case SphereMapUse::Replace:
        return "1";
    case SphereMapUse::Multiply:
        return "2";
    case SphereMapUse::Over:
        return "3";
    case SphereMapUse::Tint:
        return "4";
    case SphereMapUse::Add:
        break;
    }
    return "5";
}

// SHADING of debug.frag, which does not draw the material.
const char* shadingDefine(Shading shading)
{
    switch (shading) {
    case Shading::Wireframe:
        return "1";
    case Shading::Normals:
        return "2";
    case Shading::TexCoords:
        return "3";
    case Shading::Seams:
        return "4";
    case Shading::Mips:
        return "5";
    case Shading::NormalLines:
        return "6";
    case Shading::Bounds:
        return "7";
    case Shading::Material:
        break;
    }
    return "0";
}

} // namespace

const char* spaceDefine(MapSpace space)
{
    switch (space) {
    case MapSpace::Eye:
        return "0";
    case MapSpace::World:
        break;
    }
    return "1";
}

BoundingBox drawnBounds(const RenderSettings& settings, const BoundingBox& mesh)
{
    const float more = settings.shading == Shading::NormalLines ? normalLineLength : 0.0f;
    return {mesh.low - more, mesh.high + more};
}

glm::mat4 worldToClip(const RenderSettings& settings, const BoundingBox& drawn)
{
    const glm::vec3 farthest = glm::max(glm::abs(drawn.low - settings.camera.target), glm::abs(drawn.high - settings.camera.target));
    return settings.camera.worldToClip(float(settings.width) / float(settings.height), 1.01f * glm::length(farthest));
}

PixelRectangle Renderer::Resources::objectPart(const RenderSettings& settings)
{
    const BoundingBox box = drawnBounds(settings, mesh(settings.geometry).bounds());
    return screenBounds(box, worldToClip(settings, box), settings.width, settings.height);
}

PixelRectangle Renderer::Resources::beginObject(const RenderSettings& settings, const RenderTarget& target)
{
    const PixelRectangle part = objectPart(settings);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.width, target.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    beginDrawing(target);
    return part;
}

void Renderer::Resources::drawMesh(const RenderSettings& settings, const ShaderProgram& shader)
{
    const MeshBuffer& buffer = mesh(settings.geometry);
    shader.set("worldToClip", worldToClip(settings, drawnBounds(settings, buffer.bounds())));
    shader.set("viewer", settings.camera.viewer());
    shader.use();
    if (settings.material.faceEdges == FaceEdges::Clamped)
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    buffer.draw();
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void Renderer::Resources::drawMaterial(const RenderSettings& settings, const RenderMaps& maps, Output output)
{
    if (settings.geometry.kind == GeometryKind::Window && !settings.geometry.mesh)
        drawWindow(settings, maps, output);
    else
        drawObject(settings, maps, output);
}

/// What of a material is compiled, but for what the maps themselves say.
static std::vector<ShaderDefine> materialDefines(const MaterialSettings& material, const NeededMaps& needed, bool hasMarker)
{
    return {{"HAS_SPECULAR", needed.specular ? "1" : "0"},
            {"HAS_DIFFUSE", needed.diffuse ? "1" : "0"},
            {"FRESNEL", number(static_cast<int>(material.fresnel.kind))},
            {"CLEAR_COAT", !needed.clearCoat                             ? "0"
                           : material.clearCoat.combine == Combine::Coat ? "1"
                                                                         : "2"},
            {"COAT", material.combine == Combine::Coat ? "1" : "0"},
            {"LAMBDA_BY_ANGLE", material.lambda > 0.0f && material.lambdaGrazing > 0.0f ? "1" : "0"},
            {"MARKER", hasMarker ? "1" : "0"},
            {"HAS_TEXCOORD", needed.diffusePicture || needed.fleckPattern || needed.normalMap ? "1" : "0"},
            {"NORMAL_MAP", needed.normalMap ? "1" : "0"},
            {"DIFFUSE_PICTURE", needed.diffusePicture ? "1" : "0"},
            {"FLECK_PATTERN", needed.fleckPattern ? "1" : "0"},
            {"SPHERE_USE", useDefine(material.paint.use)},
            {"SPHERE_VERTEX", needed.sphereMap && material.paint.lookup == LookupAt::Vertex ? "1" : "0"}};
}

static bool hasFlecks(const PaintSettings& paint) { return paint.flecks.density > 0.0f; }

/// n^2 - 1 of an index of refraction, without the digits that a square near 1 loses.
static float n2m1(double n) { return static_cast<float>((n - 1.0) * (n + 1.0)); }

std::vector<ShaderDefine> Renderer::Resources::updateObjectMaps(const RenderSettings& settings, const RenderMaps& maps,
                                                                const NeededMaps& needed)
{
    std::vector<ShaderDefine> defines;
    const MaterialSettings& material = settings.material;
    if (needed.sphereMap) {
        sphereMaps[0].update(maps.sphereMaps.empty() ? nullptr : maps.sphereMaps[0], "sphere map");
        const SphereMapTexels& texels = *sphereMaps[0].source();
        defines.emplace_back("SPHERE_INDEX", number(static_cast<int>(texels.index)));
        defines.emplace_back("SPHERE_SPACE", spaceDefine(material.paint.space));
        defines.emplace_back("SPHERE_LEVELS", texels.hasAuthoredLevels ? "1" : "0");
        defines.emplace_back("FLECKS", hasFlecks(material.paint) ? "1" : "0");
    }
    if (needed.specular) {
        addMapDefines(defines, "SPECULAR", specular.update(maps.specular, format, "specular"));
        defines.emplace_back("SPECULAR_ANISOTROPY", number(material.anisotropy));
    }
    const bool readsBrdf = needed.specular && material.hasBrdf;
    if (readsBrdf)
        brdfLookups.update(maps.brdfLookups);
    defines.emplace_back("BRDF_LOOKUPS", number(readsBrdf ? brdfLookups.count() : 0));
    if (needed.viewStack)
        viewStack.update(maps.viewStack, format);
    defines.emplace_back("VIEW_STACK_NODES", number(needed.viewStack ? static_cast<int>(viewStack.nodeCount()) : 0));
    if (needed.diffuse)
        addMapDefines(defines, "DIFFUSE", diffuse.update(maps.diffuse, format, "diffuse"));
    if (needed.clearCoat) {
        addMapDefines(defines, "CLEAR_COAT", clearCoat.update(maps.clearCoat, format, "clear coat"));
        defines.emplace_back("CLEAR_COAT_ANISOTROPY", number(material.anisotropy));
    }
    if (needed.diffusePicture)
        diffusePicture.update(maps.diffusePicture, "diffuse picture");
    if (needed.fleckPattern)
        fleckPattern.update(maps.fleckPattern, "fleck pattern");
    if (needed.normalMap)
        normalMap.update(maps.normalMap, "normal map");
    return defines;
}

void Renderer::Resources::bindNormalMap(const RenderSettings& settings, const ShaderProgram& shader)
{
    normalMap.bind(3);
    shader.set("normalMap", 3);
    shader.set("normalStrength", settings.material.normalStrength);
}

void Renderer::Resources::bindReflection(const RenderSettings& settings, const NeededMaps& needed, const ShaderProgram& shader)
{
    const MaterialSettings& material = settings.material;
    const glm::mat3 rotation = mapRotation(settings);
    if (needed.specular) {
        bindMap(shader, "specular", 0, *specular.texture(), rotation, material.lodBias);
        shader.set("specularColor", material.specular);
        if (material.hasBrdf) {
            brdfLookups.bind(7);
            shader.set("brdfTable", 7);
        }
        shader.set("lambda", material.lambda);
        shader.set("lambdaGrazing", material.lambdaGrazing);
    }
    if (needed.viewStack) {
        viewStack.bind(shader, 7);
        shader.set("specularRotation", mapRotation(settings));
        shader.set("specularColor", material.specular);
    }
    if (needed.diffuse) {
        bindMap(shader, "diffuse", 1, *diffuse.texture(), rotation);
        shader.set("diffuseColor", material.diffuse);
    }
    if (needed.clearCoat) {
        bindMap(shader, "clearCoat", 2, *clearCoat.texture(), rotation);
        shader.set("clearCoatWeight", material.clearCoat.weight);
        shader.set("clearCoatN2m1", n2m1(material.clearCoat.index));
    }
    shader.set("n2m1", n2m1(material.fresnel.index));
    shader.set("conductorN", glm::vec3(material.fresnel.conductor.n));
    shader.set("conductorK", glm::max(glm::vec3(material.fresnel.conductor.k), 1e-6f));
}

void Renderer::Resources::bindSurfacePictures(const RenderSettings& settings, const NeededMaps& needed, const ShaderProgram& shader)
{
    if (needed.diffusePicture) {
        diffusePicture.bind(5);
        shader.set("diffusePicture", 5);
    }
    if (needed.fleckPattern) {
        fleckPattern.bind(6);
        shader.set("fleckPattern", 6);
    }
    if (needed.normalMap)
        bindNormalMap(settings, shader);
}

void Renderer::Resources::bindPaintedMap(const RenderSettings& settings, const ShaderProgram& shader)
{
    const PaintSettings& paint = settings.material.paint;
    const bool isShifted = hasFlecks(paint) || sphereMaps[0].source()->hasAuthoredLevels;
    sphereMaps[0].bind(4, isShifted ? 1 : paint.anisotropy, paint.onlyLevel);
    shader.set("paintedMap", 4);
    shader.set("sphereOpacity", paint.opacity);
    shader.set("sphereColor", paint.color);
    shader.set("sphereRotation", sphereRotation(settings));
    shader.set("flecks", glm::vec4(paint.flecks.density, paint.flecks.size, paint.flecks.spread, float(paint.flecks.seed)));
}

void Renderer::Resources::drawObject(const RenderSettings& settings, const RenderMaps& maps, Output output)
{
    const NeededMaps needed = neededMaps(settings);
    const bool hasMarker = settings.marker.has_value() && output == Output::Display;
    std::vector<ShaderDefine> defines = materialDefines(settings.material, needed, hasMarker);
    const std::vector<ShaderDefine> ofMaps = updateObjectMaps(settings, maps, needed);
    defines.insert(defines.end(), ofMaps.begin(), ofMaps.end());
    addOutputDefines(defines, settings, output, settings.objectCurve.value_or(settings.toneCurve));

    const ShaderProgram& shader = programs.get({"preview/object.vert", "preview/object.frag"}, defines, outputPrelude(settings, output));
    displayTables.bind(shader, displayUnit);
    bindReflection(settings, needed, shader);
    bindSurfacePictures(settings, needed, shader);
    if (needed.sphereMap)
        bindPaintedMap(settings, shader);
    if (hasMarker) {
        shader.set("marker", glm::normalize(*settings.marker));
        shader.set("markerPixel", settings.pixelRatio);
        shader.set("markerRotation", mapRotation(settings));
    }
    shader.set("exposure", std::exp2(settings.exposure));
    drawMesh(settings, shader);
}

void Renderer::Resources::drawDebug(const RenderSettings& settings, const RenderMaps& maps, Output output)
{
    const NeededMaps needed = neededMaps(settings);
    const bool hasLevels = needed.specular;
    std::vector<ShaderDefine> defines = {{"SHADING", shadingDefine(settings.shading)},
                                         {"HAS_TEXCOORD", settings.shading == Shading::TexCoords || needed.normalMap ? "1" : "0"},
                                         {"NORMAL_MAP", needed.normalMap ? "1" : "0"},
                                         {"SPHERE_VERTEX", "0"},
                                         {"ENCODED", settings.display && output == Output::Display ? "1" : "0"},
                                         {"LEVEL_VALUE", output == Output::Values ? "1" : "0"},
                                         {"HAS_SPECULAR", hasLevels ? "1" : "0"}};
    if (settings.shading == Shading::Seams)
        defines.emplace_back("SEAM", shaderFunction(settings.seamsOf, "Seam"));
    if (hasLevels) {
        addMapDefines(defines, "SPECULAR", specular.update(maps.specular, format, "specular"));
        defines.emplace_back("SPECULAR_ANISOTROPY", number(settings.material.anisotropy));
    }
    const bool isWireframe = settings.shading == Shading::Wireframe;
    const ShaderProgram& shader =
        programs.get({"preview/object.vert", "preview/debug.frag", isWireframe ? "preview/wireframe.geom" : nullptr}, defines);
    if (hasLevels) {
        bindMap(shader, "specular", 0, *specular.texture(), mapRotation(settings), settings.material.lodBias);
        shader.set("lambda", settings.material.lambda);
        shader.set("lambdaGrazing", settings.material.lambdaGrazing);
    }
    if (needed.normalMap) {
        normalMap.update(maps.normalMap, "normal map");
        bindNormalMap(settings, shader);
    }
    shader.set("specularRotation", mapRotation(settings));
    shader.set("pixelRatio", settings.pixelRatio);
    shader.set("viewport", glm::vec4(settings.width, settings.height, 0.0f, 0.0f));
    drawMesh(settings, shader);
    if (settings.shading == Shading::NormalLines || settings.shading == Shading::Bounds)
        drawLines(settings, output);
}

// As drawBuffers().
void Renderer::Resources::drawLevel(const RenderSettings& settings, const RenderMaps& maps, const RenderTarget& target, glm::ivec2 corner)
{
    RenderSettings levels = settings;
    levels.shading = Shading::Mips;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(-corner.x, -corner.y, settings.width, settings.height);
    glDisable(GL_SCISSOR_TEST);
    beginDrawing(target);
    drawDebug(levels, maps, Output::Values);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
}

// A viewport that begins left of and below the target moves one pixel of the picture to its (0, 0), on the same grid of samples.
void Renderer::Resources::drawBuffers(const RenderSettings& settings, const RenderTarget& target, glm::ivec2 corner)
{
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(-corner.x, -corner.y, settings.width, settings.height);
    glDisable(GL_SCISSOR_TEST);
    beginDrawing(target);
    const bool isPick = target.colors.size() > 3;
    const bool isMapped = neededMaps(settings).normalMap && normalMap.isHeld();
    const ShaderProgram& shader =
        programs.get({"preview/object.vert", "preview/buffers.frag"}, {{"HAS_TEXCOORD", isPick || isMapped ? "1" : "0"},
                                                                       {"PICK", isPick ? "1" : "0"},
                                                                       {"NORMAL_MAP", isMapped ? "1" : "0"},
                                                                       {"SPHERE_VERTEX", "0"}});
    if (isMapped)
        bindNormalMap(settings, shader);
    shader.set("specularRotation", mapRotation(settings));
    drawMesh(settings, shader);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
}

void Renderer::Resources::drawDiscPlaces(const RenderSettings& settings, SphereMapIndex index, const RenderTarget& target)
{
    const PaintSettings& paint = settings.material.paint;
    const bool isWindow = settings.geometry.kind == GeometryKind::Window && !settings.geometry.mesh;
    const bool isMapped = neededMaps(settings).normalMap && normalMap.isHeld();
    std::vector<ShaderDefine> defines = {{"WINDOW", isWindow ? "1" : "0"},
                                         {"HAS_TEXCOORD", isWindow || isMapped ? "1" : "0"},
                                         {"NORMAL_MAP", isMapped ? "1" : "0"},
                                         {"SPHERE_VERTEX", !isWindow && paint.lookup == LookupAt::Vertex ? "1" : "0"}};
    if (isWindow) {
        defines.emplace_back("WINDOW_SPACE", spaceDefine(paint.space));
    } else {
        defines.emplace_back("SPHERE_INDEX", number(static_cast<int>(index)));
        defines.emplace_back("SPHERE_SPACE", spaceDefine(paint.space));
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, settings.width, settings.height);
    glDisable(GL_SCISSOR_TEST);
    beginDrawing(target, glm::vec4(DiscPlaces::noPlace));
    const ShaderProgram& shader = programs.get({"preview/object.vert", "preview/disc_places.frag"}, defines);
    shader.set("noPlace", DiscPlaces::noPlace);
    if (isMapped)
        bindNormalMap(settings, shader);
    if (isWindow) {
        setWindowView(settings, shader);
        shader.set("layerDepth", settings.windowDepths.x);
    } else {
        shader.set("sphereRotation", sphereRotation(settings));
    }
    drawMesh(settings, shader);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
}

} // namespace mirrorball::preview
