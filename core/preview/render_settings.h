#pragma once

#include "camera.h"
#include "disc_place.h"
#include "display_transform.h"
#include "flecks.h"
#include "mesh.h"

#include "core/filter/view_stack.h"
#include "core/image/color.h"
#include "core/image/environment_map.h"
#include "core/image/picture_levels.h"
#include "core/scene/scene_kinds.h"
#include "core/shading/fresnel.h"
#include "core/spheremap/evaluation/sphere_map_texels.h"

#include <memory>
#include <optional>
#include <vector>

/// What to draw: plain values. Kinds are the scene's, scene_kinds.h; numbers are floats and angles radians, as shaders take them.
namespace mirrorball::preview {

/// What the material is shown on. A mesh read from a file comes in as `mesh`.
struct Geometry {
    GeometryKind kind = GeometryKind::Teapot;
    int level = 12;                             ///< how finely it is cut: quads along a quarter of the circumference
    std::shared_ptr<const Mesh> mesh = nullptr; ///< drawn in place of `kind` when there is one; a new pointer means a new mesh

    bool operator==(const Geometry&) const = default;
};

/// A painted sphere map on the object. Its texels, and whether it is indexed by normal or by reflection, come with the maps.
struct PaintSettings {
    std::optional<SphereMapUse> use{}; ///< empty: the object has none
    float opacity = 1.0f;
    glm::vec3 color{0.8f};
    MapSpace space = MapSpace::Eye;
    LookupAt lookup = LookupAt::Pixel;
    int anisotropy = 16; ///< most lookups along the longer side of a pixel's footprint, where the map's levels are averages; 1 to 16
    Flecks flecks{};
    bool hasFleckPattern = false;   ///< whether the flecks' density is times the maps' pattern, by the mesh's texture coordinates
    std::optional<int> onlyLevel{}; ///< of the map's levels this one alone is read, wherever; beyond the last: the last

    bool operator==(const PaintSettings&) const = default;
};

/// What a lookup beside the edge of a cube map's face reads: across it, or the face's own last texels, as the hardware of 2002 did.
enum class FaceEdges { Seamless, Clamped };

/// A clear layer over the material: w F L_c + (1 - w F) L, or for Add w F L_c + L, with F of a dielectric and L_c the clear coat's map
/// looked up by the mirror direction.
struct ClearCoat {
    float weight = 0.0f; ///< w, [0, 1]; 0: there is none, and its map is left out
    double index = 1.5;  ///< of refraction, > 0
    Combine combine = Combine::Coat;
    bool operator==(const ClearCoat&) const = default;
};

/// How the object reflects. L_m is the specular map looked up by the mirror direction, times `specular`; L_d the diffuse map looked up by
/// the normal, times `diffuse`. A color of 0 leaves its map out: it is not uploaded and its shader code not built.
struct MaterialSettings {
    glm::vec3 specular{1.0f};
    glm::vec3 diffuse{0.0f};
    bool hasDiffusePicture = false; ///< whether L_d is times the maps' picture, too, by the mesh's texture coordinates
    /// How far the maps' normal map tilts normals, times its own; 0: there is none, and its shader code is not built.
    float normalStrength = 0.0f;
    /// Whether the specular map is a ggx chain (chainRoughness()), read at each pixel by the lookups that the maps' table has: they stand
    /// for F L_m, and their weights' sum for F. Otherwise one lookup by the mirror direction.
    bool hasBrdf = false;
    bool isExact = false;           ///< of a BRDF: the maps' view stack stands for specular map, lookups and their sum; no levels are read
    Fresnel fresnel{};              ///< F; None: F = 1. Not with BRDF lookups
    Combine combine = Combine::Add; ///< Add: F L_m + L_d; Coat: F L_m + (1 - F) L_d
    ClearCoat clearCoat{};
    float lambda = 0.0f;        ///< least mip level of the specular lookup: max(lod + lodBias, lambda). Source: 002 section 2
    float lambdaGrazing = 0.0f; ///< how much sharper at grazing angles: lambdaAt() of core/shading/lambda.h
    FaceEdges faceEdges = FaceEdges::Seamless;
    float lodBias = 0.0f; ///< moves that level where lambda does not hold it
    int anisotropy = 1;   ///< most lookups along the longer side of a pixel's footprint, where the map has levels; 1 to 16
    MapSpace space = MapSpace::World;
    PaintSettings paint{};

    bool operator==(const MaterialSettings&) const = default;
};

struct Background {
    Backdrop kind = Backdrop::Environment;
    glm::vec3 color{0.18f}; ///< scene-linear, for Color
    bool operator==(const Background&) const = default;
};

/// Color of a mip level in the debug view: blue 0, cyan 1, green 2, yellow 3, orange 4, red 5, magenta 6, white from 7 on; linear RGB,
/// mixed in between.
glm::vec3 levelColor(float level);

struct RenderSettings {
    int width = 1280;
    int height = 720;
    int samples = 4;         ///< per pixel: 1, 2 or 4, as the driver has them
    bool smoothEdges = true; ///< display pictures of several samples: those of highlights and ink as those of the object's outline
    float pixelRatio = 1.0f; ///< device pixels to a pixel of the window: the width of lines follows it
    Geometry geometry{};
    Shading shading = Shading::Material;
    Parameterization seamsOf = Parameterization::Cube; ///< for Shading::Seams
    glm::vec3 windowDepths{4.0f, 12.0f, 1000.0f};      ///< GeometryKind::Window: of the layers outside, nearest first
    std::optional<glm::vec3> marker{};                 ///< ringed where the object mirrors it: a direction in the specular map
    Camera camera{};
    MaterialSettings material{};
    Background background{};
    float yaw = 0.0f;                        ///< radians, turns the environment about +Y as direction.h says
    float exposure = 0.0f;                   ///< EV: display pictures are multiplied by 2^exposure; radiance pictures are not
    ToneCurve toneCurve = ToneCurve::Filmic; ///< display pictures only
    std::optional<ToneCurve> objectCurve{};  ///< of the object, where it is not toneCurve: paint is shown as it was painted
    bool dither = false;                     ///< display pictures only: before they are rounded to 8 bits, lib/dither.glsl
    /// In place of tone curve and sRGB, display pictures only; a new pointer means a new transform.
    std::shared_ptr<const DisplayTransform> display = nullptr;

    bool operator==(const RenderSettings&) const = default;
};

/// How texels are stored on the GPU. Half carries a common factor, so that a sun beyond 65504 is not clipped.
enum class TexelFormat { Half, Float };

/// A map and its coarser levels, largest first.
using MapLevels = std::shared_ptr<const std::vector<EnvironmentMap>>;

/// The maps of a picture, by pointer: the renderer keeps a texture as long as it is handed the same pointer. Maps that the settings
/// do not need may be null and are never looked at.
struct RenderMaps {
    MapLevels specular{};                         ///< the environment for a mirror, a filtered map for a glossy material
    MapLevels diffuse{};                          ///< filtered with the diffuse lobe
    MapLevels background{};                       ///< the environment, drawn behind the object
    std::shared_ptr<const Image> brdfLookups{};   ///< core/filter/lookup_table.h
    std::shared_ptr<const ViewStack> viewStack{}; ///< core/filter/view_stack.h
    /// The painted sphere map; for a window the layers outside, one to three, nearest first.
    std::vector<SphereMapChain> sphereMaps{};
    PictureLevels diffusePicture{}; ///< linear RGB
    PictureLevels fleckPattern{};   ///< shares in the first channel, [0, 1]
    MapLevels clearCoat{};          ///< for the clear coat, as `specular` for the material
    PictureLevels normalMap{};      ///< vectors of tangent space, components in [-1, 1]
};

/// @throws InvalidArgument naming the field that is out of range
void validate(const RenderSettings& settings);

/// Which maps a picture with these settings reads.
struct NeededMaps {
    bool specular, diffuse, background;
    bool sphereMap = false;
    bool diffusePicture = false, fleckPattern = false;
    bool clearCoat = false;
    bool normalMap = false;
    bool viewStack = false; ///< in place of the specular map
    bool operator==(const NeededMaps&) const = default;
};
NeededMaps neededMaps(const RenderSettings& settings);

} // namespace mirrorball::preview
