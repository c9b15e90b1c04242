#pragma once

#include "bound_map.h"
#include "display_tables.h"
#include "lookup_texture.h"
#include "mesh_buffer.h"
#include "picture_texture.h"
#include "render_target.h"
#include "renderer.h"
#include "shader_program.h"
#include "sphere_map_texture.h"
#include "view_stack_texture.h"

namespace mirrorball::preview {

enum class Output {
    Display,
    Radiance,
    Values, ///< of a debug view: the numbers that its colors stand for
};

/// What a renderer keeps in its context, and the passes that a picture is made of. Only the renderer's own files know it.
struct Renderer::Resources {
    explicit Resources(TexelFormat format);

    TexelFormat format;
    GlObject emptyVertexArray;
    GlObject edgeFramebuffer{};
    BoundMap specular{}, diffuse{}, clearCoat{}, background{};
    LookupTexture brdfLookups{};
    ViewStackTexture viewStack{};
    SphereMapTexture sphereMaps[3]{};
    PictureTexture diffusePicture{}, fleckPattern{}, normalMap{};
    ProgramCache programs{};
    DisplayTables displayTables{};
    Geometry geometry{};
    std::unique_ptr<MeshBuffer> meshBuffer{};
    RenderTarget objectTarget{}, pictureTarget{}, bufferTarget{}, pickTarget{}, levelTarget{}, placesTarget{};

    const MeshBuffer& mesh(const Geometry& wanted);
    RenderTarget& target(RenderTarget& slot, int width, int height, int samples, GLenum colorFormat, int count, GLenum depthFormat);

    /// The whole picture.
    void drawScene(const RenderSettings& settings, const RenderMaps& maps, Output output, const Destination& destination);

    // object_pass.cpp
    PixelRectangle objectPart(const RenderSettings& settings);
    /// Clears the part of the target that the object can touch and leaves the scissor on it.
    PixelRectangle beginObject(const RenderSettings& settings, const RenderTarget& target);
    void drawMesh(const RenderSettings& settings, const ShaderProgram& shader);
    void drawObject(const RenderSettings& settings, const RenderMaps& maps, Output output);
    /// What an object shows, on the GPU, and what its shader must know of it when it is compiled.
    std::vector<ShaderDefine> updateObjectMaps(const RenderSettings& settings, const RenderMaps& maps, const NeededMaps& needed);
    void bindReflection(const RenderSettings& settings, const NeededMaps& needed, const ShaderProgram& shader);
    void bindSurfacePictures(const RenderSettings& settings, const NeededMaps& needed, const ShaderProgram& shader);
    void bindNormalMap(const RenderSettings& settings, const ShaderProgram& shader);
    void bindPaintedMap(const RenderSettings& settings, const ShaderProgram& shader);
    void drawWindow(const RenderSettings& settings, const RenderMaps& maps, Output output);
    void drawDebug(const RenderSettings& settings, const RenderMaps& maps, Output output);
    /// The object, or the window, as the material shows it.
    void drawMaterial(const RenderSettings& settings, const RenderMaps& maps, Output output);
    void drawLines(const RenderSettings& settings, Output output); ///< line_pass.cpp: those of Shading::NormalLines and Shading::Bounds
    /// edge_pass.cpp: shades the edges inside of the object, which has been drawn, sample by sample.
    void smoothEdges(const RenderSettings& settings, const RenderMaps& maps, Output output, const RenderTarget& object);
    /// The levels that the specular lookups of some pixels read, to a target of those. @param corner pixel of the picture at (0, 0)
    void drawLevel(const RenderSettings& settings, const RenderMaps& maps, const RenderTarget& target, glm::ivec2 corner);
    /// Position, normal, direction and, with five, what else a SurfaceHit holds. @param corner pixel of the picture at (0, 0)
    void drawBuffers(const RenderSettings& settings, const RenderTarget& target, glm::ivec2 corner);
    /// Places in the painted sphere map, to a target of two channels.
    void drawDiscPlaces(const RenderSettings& settings, SphereMapIndex index, const RenderTarget& target);
    void setWindowView(const RenderSettings& settings, const ShaderProgram& shader); ///< window_pass.cpp: what lib/window_view.glsl reads

    // composite_pass.cpp
    /// @param part   of the picture
    /// @param object the samples to lay over the background, or null where there are none
    void drawComposite(const RenderSettings& settings, const RenderMaps& maps, Output output, const Destination& destination,
                       const PixelRectangle& part, const GlObject* object);
};

inline constexpr float normalLineLength = 0.08f; ///< of Shading::NormalLines; the object's radius is 1
/// What a picture of a mesh can touch: its bounds, and the lines that stand out of them.
BoundingBox drawnBounds(const RenderSettings& settings, const BoundingBox& mesh);
glm::mat4 worldToClip(const RenderSettings& settings, const BoundingBox& drawn);

/// The turn from world directions to the environment's: L'(d) = L(yawed(d, -yaw)).
glm::mat3 yawToMap(float yaw);

/// SPHERE_SPACE and WINDOW_SPACE of the shaders.
const char* spaceDefine(MapSpace space);

/// What lib/output.glsl needs to know when it is compiled, and the display transform that stands before it.
void addOutputDefines(std::vector<ShaderDefine>& defines, const RenderSettings& settings, Output output, ToneCurve curve);
std::string_view outputPrelude(const RenderSettings& settings, Output output);

/// Texture units: 0 specular, 1 diffuse, 2 background and, on an object, the clear coat, 3 the object's samples and, on an object, the
/// normal map, 4 to 6 painted maps, on an object 4 alone and then 5 the diffuse picture, 6 the flecks' pattern; 7 the table of a BRDF's
/// lookups or its exact maps, from here on tables of the display.
inline constexpr GLuint displayUnit = 8;

} // namespace mirrorball::preview
