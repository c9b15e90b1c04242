#pragma once

#include "core/base/fields.h"
#include "core/filter/lobe.h"
#include "core/filter/lookup_choice.h"
#include "core/filter/method.h"
#include "core/image/color.h"
#include "core/image/probe_reading.h"
#include "core/shading/fresnel.h"
#include "core/sphere/parameterization.h"
#include "core/spheremap/document/embedded_sphere_map.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A scene says what to make: which probe, on which material, seen how, written into which maps. One plain value, which the command
/// line reads from a file (scene_file.h) and the studio edits. Angles are in degrees here, and only here in core: they stand as they
/// were typed, so that a file that is loaded and saved stays the same.
namespace mirrorball {

struct Brdf;

enum class SurfaceLobe { Mirror, Phong, Ggx };
enum class SphereMapUse { Replace, Multiply, Over, Tint, Add };
enum class SphereMapLevels { Authored, Plain };
enum class LookupAt { Pixel, Vertex };
enum class MapSpace { World, Eye };
enum class Projection { Perspective, Orthographic };
enum class Backdrop { Environment, Blurred, Color, None };
enum class ToneChoice { Auto, None, Reinhard, Filmic };
enum class Shading { Material, Wireframe, Normals, TexCoords, Seams, Mips, NormalLines, Bounds };
enum class ExportKind { Source, Specular, Diffuse, Chain, Painted };

/// The words of files and command line for an enum's values, in their order.
std::span<const std::string_view> words(SurfaceLobe);      // mirror phong ggx
std::span<const std::string_view> words(SphereMapUse);     // replace multiply over tint add
std::span<const std::string_view> words(SphereMapLevels);  // authored plain
std::span<const std::string_view> words(LookupAt);         // pixel vertex
std::span<const std::string_view> words(MapSpace);         // world eye
std::span<const std::string_view> words(Projection);       // perspective orthographic
std::span<const std::string_view> words(Backdrop);         // environment blurred color none
std::span<const std::string_view> words(Shading);          // material wireframe normals texcoords seams mips normal-lines bounds
std::span<const std::string_view> words(ExportKind);       // source specular diffuse chain painted
std::span<const std::string_view> words(Parameterization); // latlong cube sphere angular paraboloid octahedral
std::span<const std::string_view> words(FresnelKind);      // none dielectric conductor
std::span<const std::string_view> words(Combine);          // add coat
std::span<const std::string_view> words(Method);           // auto reference spectral direct hierarchical importance paraboloid mip sh9
std::span<const std::string_view> words(ToneChoice);       // auto none reinhard filmic

/// Where the light comes from.
struct ProbeSettings {
    std::string source = "builtin:studio";
    double yawDeg = 0.0;
    double exposure = 0.0;
    ProbeReading reading{};
    UnknownKeys unknown{};

    bool operator==(const ProbeSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"source", "image file, six or two with a %s, or builtin:NAME"}, self.source);
        visit(Field{"yaw", "turns the environment about +Y, counterclockwise seen from above", -36000, 36000, "degrees"}, self.yawDeg);
        visit(Field{"exposure", "brightness of the light: radiance times 2^exposure", -64, 64, "EV"}, self.exposure);
        ProbeReading::visitFields(self.reading, visit);
    }
};

/// The map that the picture reads reflections from.
struct MapSettings {
    Parameterization parameterization = Parameterization::Cube;
    int size = 512;
    int border = 0;
    bool mips = false;
    MipFiltering mipFiltering = MipFiltering::AcrossSeams;
    int anisotropy = 1;
    MapSpace space = MapSpace::World;
    UnknownKeys unknown{};

    bool operator==(const MapSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"parameterization", "kind of the map that the picture reads"}, self.parameterization);
        visit(Field{"size", "edge of a face, disc or octahedron, or height of a latlong", 1, 16384, "texels"}, self.size);
        visit(Field{"border", "paraboloid: texels kept free outside each disc", 0, 4096, "texels"}, self.border);
        visit(Field{"mips", "coarser levels, read where a reflection shrinks: no shimmer on strongly curved parts"}, self.mips);
        visit(Field{"mip_filtering",
                    "cube with coarser levels: filtered across the seams of the faces, or each face by itself as the hardware of 2002 "
                    "did, which shows the seams"},
              self.mipFiltering);
        visit(Field{"anisotropy", "with coarser levels: lookups along the longer side of a pixel's footprint, sharper at grazing angles", 1,
                    16},
              self.anisotropy);
        visit(Field{"space", "world: the environment stands still; eye: the map turns with the camera"}, self.space);
    }
};

/// The mirrored part of a material.
struct SpecularSettings {
    SurfaceLobe lobe = SurfaceLobe::Mirror;
    double exponent = 50.0;
    double roughness = 0.3;
    double weight = 1.0;
    glm::dvec3 color{1.0};
    UnknownKeys unknown{};

    bool operator==(const SpecularSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"lobe", "mirror, or how a glossy surface spreads the reflection"}, self.lobe);
        visit(Field{"exponent", "phong: the larger, the sharper", 0, 1e9}, self.exponent);
        visit(Field{"roughness", "ggx: 0 is a mirror, 1 fully rough; alpha is its square", 0, 1}, self.roughness);
        visit(Field{"weight", "strength of the reflection", 0, 1000}, self.weight);
        visit(Field{"color", "color of the reflection, linear RGB", 0, 1000}, self.color);
    }
};

/// The Fresnel term of a material.
struct FresnelSettings {
    FresnelKind kind = FresnelKind::None;
    double index = 1.5;
    std::string metal = "gold";
    glm::dvec3 n{0.2, 0.9, 1.1};
    glm::dvec3 k{3.9, 2.5, 2.4};
    UnknownKeys unknown{};

    bool operator==(const FresnelSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"kind", "none: mirrors alike at every angle; dielectric: glass, lacquer, water; conductor: metal"}, self.kind);
        visit(Field{"index", "dielectric: index of refraction", 1e-3, 1e9}, self.index);
        visit(Field{"metal", "conductor: name of a metal, or custom for n and k below"}, self.metal);
        visit(Field{"n", "custom conductor: index of refraction for red, green, blue", 1e-6, 1e6}, self.n);
        visit(Field{"k", "custom conductor: extinction for red, green, blue", 0, 1e6}, self.k);
    }
};

/// The matt part of a material.
struct DiffuseSettings {
    double weight = 0.0;
    glm::dvec3 color{0.8};
    std::string picture{}; ///< an image file, whose path starts at the scene's folder
    UnknownKeys unknown{};

    bool operator==(const DiffuseSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"weight", "strength of the diffuse part", 0, 1000}, self.weight);
        visit(Field{"color", "color of the diffuse part, linear RGB", 0, 1000}, self.color);
        visit(Field{"picture", "picture by the mesh's texture coordinates, times the color; it repeats beyond 0 to 1; empty: none"},
              self.picture);
    }
};

/// A lobe that knows the view, in place of the specular lobe and the Fresnel term: the picture reads it as a few lookups into an ordinary
/// ggx chain, as an engine would. lookup_table.h
struct BrdfSettings {
    std::string model{};
    LookupKind kind = LookupKind::Fitted;
    int lookups = 5;
    UnknownKeys unknown{};

    bool isNone() const { return model.empty(); }
    /// What the picture reads: lookups 0 are the split sum, as before there were kinds.
    LookupChoice choice() const
    {
        return kind == LookupKind::Fitted && lookups == 0 ? LookupChoice{LookupKind::SplitSum} : LookupChoice{kind, lookups};
    }
    bool operator==(const BrdfSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"model", "ggx:roughness=0.5,metal=gold, another model, or a measured file (.binary .brdf .csv .txt), in place of the "
                             "specular lobe and the Fresnel term; empty: those"},
              self.model);
        visit(Field{"kind", "fitted: lookups that are fitted to the lobe; split-sum, three, filament: what those show, to compare"},
              self.kind);
        visit(Field{"lookups", "fitted: how many into a ggx chain stand for the lobe at each angle of view; 0: the split sum", 0, 8},
              self.lookups);
    }
};

/// Flecks: cells on the surface, each of which looks the sphere map up elsewhere, as facets that are turned at random. Source: 003
/// section 6.2
struct FleckSettings {
    double density = 0.0;
    double size = 0.02;
    double spread = 0.4;
    int seed = 0;
    std::string pattern{}; ///< an image file, whose path starts at the scene's folder
    UnknownKeys unknown{};

    bool operator==(const FleckSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"density", "share of the cells that are flecks; 0: none", 0, 1}, self.density);
        visit(Field{"size", "of a cell; the object's radius is 1", 1e-3, 1}, self.size);
        visit(Field{"spread", "how far a fleck's lookup may lie from the surface's own, in radii of the disc", 0, 2}, self.spread);
        visit(Field{"seed", "another number, another arrangement", 0, 1000000}, self.seed);
        visit(Field{"pattern",
                    "picture by the mesh's texture coordinates: where it is white, flecks are as dense as said above, where it is "
                    "black there are none; empty: as dense everywhere"},
              self.pattern);
    }
};

/// A painted sphere map and how it meets the reflection. Transparent parts of the map and an opacity below 1 let show what lies below.
struct SphereMapSettings {
    std::string source{};
    EmbeddedSphereMap document{};
    Fit fit = Fit::None;
    SphereMapUse use = SphereMapUse::Replace;
    double opacity = 1.0;
    glm::dvec3 color{0.8};
    MapSpace space = MapSpace::Eye;
    int size = 512;
    SphereMapLevels levels = SphereMapLevels::Authored;
    LookupAt lookup = LookupAt::Pixel;
    FleckSettings flecks{};
    UnknownKeys unknown{};

    bool isNone() const { return source.empty() && !document; }
    bool operator==(const SphereMapSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"source", "painted sphere map: a .spheremap file, a picture of one, or a preset; empty: none"}, self.source);
        visit(Field{"document", "a sphere map that is part of the scene, in place of the source; null: none"}, self.document);
        visit(Field{"fit", "a picture of one that is not square: stretched, padded, or cropped about its middle; none: refused"}, self.fit);
        visit(Field{"use", "replace: shown alone, over the color below; multiply: times that color; over: over the reflecting material; "
                           "tint: times the reflecting material; add: its light added to the reflecting material"},
              self.use);
        visit(Field{"opacity", "of the map", 0, 1}, self.opacity);
        visit(Field{"color", "replace, multiply: of the surface, linear RGB", 0, 1000}, self.color);
        visit(Field{"space", "eye: the map turns with the camera; world: it stands still, looked up by world directions"}, self.space);
        visit(Field{"size", "texels along the edge of the map that the picture reads", 16, 8192, "texels"}, self.size);
        visit(Field{"levels", "authored: coarser levels as the document makes them; plain: averages, as hardware makes them"}, self.levels);
        visit(Field{"lookup", "pixel: exact; vertex: coordinates interpolated between vertices, as hardware of 1999 did"}, self.lookup);
        visit(Field{"flecks", "cells of the surface that look the map up elsewhere"}, self.flecks);
    }
};

/// A material: F L_m + L_d (add) or F L_m + (1 - F) L_d (coat), with L_m the specular and L_d the diffuse part. With a BRDF, F L_m is the
/// light that it reflects and F its directional albedo.
struct Material {
    SpecularSettings specular{};
    FresnelSettings fresnel{};
    BrdfSettings brdf{};
    Combine combine = Combine::Add;
    DiffuseSettings diffuse{};
    double lambda = 0.0;
    double lambdaGrazing = 0.0;
    double lodBias = 0.0;
    SphereMapSettings sphereMap{};
    UnknownKeys unknown{};

    bool operator==(const Material&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"specular", "the mirrored part"}, self.specular);
        visit(Field{"fresnel", "how much is mirrored at which angle"}, self.fresnel);
        visit(Field{"brdf", "a lobe that knows the view"}, self.brdf);
        visit(Field{"combine", "add: F times specular plus diffuse; coat: the diffuse part lies under the reflecting layer, times 1 - F"},
              self.combine);
        visit(Field{"diffuse", "the matt part"}, self.diffuse);
        visit(Field{"lambda", "least mip level of the reflection: blurs it without filtering", 0, 16}, self.lambda);
        visit(Field{"lambda_grazing",
                    "with lambda: sharper where the surface is seen at a grazing angle; 1 as rough surfaces do, more exaggerates", 0, 8},
              self.lambdaGrazing);
        visit(Field{"lod_bias", "moves the mip level of the reflection by this much; lambda then holds it from below", -16, 16},
              self.lodBias);
        visit(Field{"sphere_map", "a painted sphere map"}, self.sphereMap);
    }
};

/// Orbits the target: yaw 0, pitch 0 looks from +Z; yaw turns the eye towards +X, pitch towards +Y.
struct CameraSettings {
    double yawDeg = 25.0;
    double pitchDeg = 18.0;
    double rollDeg = 0.0;
    double distance = 3.4;
    double fieldOfViewDeg = 36.0;
    glm::dvec3 target{0.0};
    Projection projection = Projection::Perspective;
    UnknownKeys unknown{};

    bool operator==(const CameraSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"yaw", "longitude of the eye", -36000, 36000, "degrees"}, self.yawDeg);
        visit(Field{"pitch", "latitude of the eye", -90, 90, "degrees"}, self.pitchDeg);
        visit(Field{"roll", "turns the camera about its view, counterclockwise seen from behind it", -36000, 36000, "degrees"},
              self.rollDeg);
        visit(Field{"distance", "from the target; the object's radius is 1", 0.01, 1000}, self.distance);
        visit(Field{"fov", "angle of view from bottom to top", 1, 170, "degrees"}, self.fieldOfViewDeg);
        visit(Field{"target", "point that the eye looks at and orbits; the object's center is 0, 0, 0", -1000, 1000}, self.target);
        visit(Field{"projection", "perspective, or orthographic at the size the object has in perspective"}, self.projection);
    }
};

/// What stands behind the object.
struct BackdropSettings {
    Backdrop kind = Backdrop::Environment;
    double blur = 0.3;
    glm::dvec3 color{0.18};
    UnknownKeys unknown{};

    bool operator==(const BackdropSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"kind", "the environment, the environment blurred, one color, or none (transparent)"}, self.kind);
        visit(Field{"blur", "blurred: ggx roughness of the blur", 0.01, 1}, self.blur);
        visit(Field{"color", "color: linear RGB", 0, 1000}, self.color);
    }
};

/// A window in a room, view.geometry "window": what lies outside is the material's sphere map, and behind it up to two more, each a layer
/// at its depth. Source: 003 section 4
struct WindowSettings {
    double depth = 4.0;
    std::string middle{};
    double middleDepth = 12.0;
    std::string far{};
    double farDepth = 1000.0;
    UnknownKeys unknown{};

    bool operator==(const WindowSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"depth", "of the material's sphere map behind the pane; the pane is 1.2 wide", 0, 1e6}, self.depth);
        visit(Field{"middle", "sphere map behind that one, seen where it is transparent; empty: none"}, self.middle);
        visit(Field{"middle_depth", "its depth", 0, 1e6}, self.middleDepth);
        visit(Field{"far", "sphere map behind both; empty: none"}, self.far);
        visit(Field{"far_depth", "its depth", 0, 1e6}, self.farDepth);
    }
};

/// What brings radiance to the display: an OpenColorIO configuration's display and view in place of tone curve and sRGB.
struct DisplaySettings {
    std::string config{};
    std::string display{};
    std::string view{};
    UnknownKeys unknown{};

    bool operator==(const DisplaySettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"config", "OpenColorIO configuration: a .ocio file, or env for the one that $OCIO names; empty: tone curve and sRGB"},
              self.config);
        visit(Field{"display", "of the configuration; empty: its default"}, self.display);
        visit(Field{"view", "of the display; empty: its default"}, self.view);
    }
};

/// How the picture is taken.
struct ViewSettings {
    std::string geometry = "teapot";
    int tessellation = 0;
    Shading shading = Shading::Material;
    CameraSettings camera{};
    WindowSettings window{};
    ToneChoice tone = ToneChoice::Auto;
    double exposure = 0.0;
    DisplaySettings display{};
    BackdropSettings background{};
    int width = 1280;
    int height = 720;
    UnknownKeys unknown{};

    bool operator==(const ViewSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"geometry", "teapot, torus, sphere, box, window, or a mesh file (.obj .ply .stl .off .gltf .glb .fbx .dae .3ds)"},
              self.geometry);
        visit(Field{"tessellation", "quads along a quarter of a circumference; 0: as fine as the picture needs", 0, 256},
              self.tessellation);
        visit(
            Field{
                "shading",
                "the material, or what it is computed from: triangles, normals as colors or as lines, texture coordinates, seams or levels "
                "of the map, the bounding box"},
            self.shading);
        visit(Field{"camera", "where the eye is"}, self.camera);
        visit(Field{"window", "the window of the geometry of that name"}, self.window);
        visit(Field{"tone", "curve that brings radiance to the display; auto: a sphere map that replaces the material is shown as it was "
                            "painted, all else through filmic"},
              self.tone);
        visit(Field{"exposure", "brightness of the display picture: times 2^exposure", -64, 64, "EV"}, self.exposure);
        visit(Field{"display", "display through OpenColorIO"}, self.display);
        visit(Field{"background", "what stands behind the object"}, self.background);
        visit(Field{"width", "of the picture", 1, 16384, "pixels"}, self.width);
        visit(Field{"height", "of the picture", 1, 16384, "pixels"}, self.height);
    }
};

/// One map to write.
struct ExportTarget {
    std::string name{};
    ExportKind kind = ExportKind::Specular;
    Parameterization parameterization = Parameterization::Cube;
    int size = 256;
    int border = 0;
    std::string file{};
    bool half = false;
    bool mips = false;
    int levels = 0;
    UnknownKeys unknown{};

    bool operator==(const ExportTarget&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"name", "letters, digits, - and _; names the files"}, self.name);
        visit(Field{"kind", "source: the environment; specular: filtered with the material's lobe; diffuse: irradiance over pi; chain: ggx "
                            "levels of roughness 0 to 1; painted: the sphere map"},
              self.kind);
        visit(Field{"parameterization", "kind of the map; painted: always a sphere map's disc"}, self.parameterization);
        visit(Field{"size", "edge of a face, disc or octahedron, or height of a latlong", 1, 16384, "texels"}, self.size);
        visit(Field{"border",
                    "paraboloid: texels kept free outside each disc; cube: texels of its neighbors around each face; painted: "
                    "texels between the disc and the picture's edge",
                    0, 4096, "texels"},
              self.border);
        visit(
            Field{"file", "file name, whose extension is the format; empty: NAME.exr; %s in a cube's makes six files, %d one file a level"},
            self.file);
        visit(Field{"half", "16-bit floats where the format has them"}, self.half);
        visit(Field{"mips", "coarser levels: halved, or as the painted map makes them"}, self.mips);
        visit(Field{"levels", "chain: how many levels; 0: down to one texel", 0, 16}, self.levels);
    }

    /// Of the map; a painted picture's own border is no part of it.
    MapLayout layout() const
    {
        return kind == ExportKind::Painted ? MapLayout{Parameterization::Sphere, size, 0}
                                           : MapLayout{parameterization, size, parameterization == Parameterization::Cube ? 0 : border};
    }
    /// Texels around each face of a cube's files.
    int faceBorder() const { return kind != ExportKind::Painted && parameterization == Parameterization::Cube ? border : 0; }
    /// `file`, or NAME.exr where that is empty.
    std::string fileName() const { return file.empty() ? name + ".exr" : file; }
};

/// How the specular map, of the picture and of exports, is filtered. Whatever a method refuses is left to auto, and the plan says so.
struct FilterSettings {
    Method method = Method::Auto;
    double tolerance = 1e-5;
    int samples = 1024;
    MipFiltering mipFiltering = MipFiltering::AcrossSeams;
    ParaboloidKnobs paraboloid{};
    UnknownKeys unknown{};

    bool operator==(const FilterSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"method", "how the specular map is filtered; auto: the cheapest method that meets the tolerance"}, self.method);
        visit(Field{"tolerance", "largest error of the map, rel_rms", 1e-9, 1}, self.tolerance);
        visit(Field{"samples", "importance: samples of the lobe a texel", 1, 1 << 20}, self.samples);
        visit(Field{"mip_filtering", "mip: cube faces filtered across their seams, or each by itself as the hardware of 2002 did"},
              self.mipFiltering);
        ParaboloidKnobs::visitFields(self.paraboloid, visit);
    }

    MethodKnobs knobs() const { return {.samples = samples, .mipFiltering = mipFiltering, .paraboloid = paraboloid}; }
};

struct Scene {
    ProbeSettings probe{};
    MapSettings map{};
    Material material{};
    FilterSettings filter{};
    ViewSettings view{};
    std::vector<ExportTarget> exports{};
    UnknownKeys unknown{};
    /// Where relative paths start from: the folder of the scene's file. Not written into it. Empty: the current folder.
    std::filesystem::path folder{};

    bool operator==(const Scene&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"probe", "where the light comes from"}, self.probe);
        visit(Field{"map", "the map that the picture reads"}, self.map);
        visit(Field{"material", "what the object is made of"}, self.material);
        visit(Field{"filter", "how the specular map is filtered"}, self.filter);
        visit(Field{"view", "how the picture is taken"}, self.view);
        visit(Field{"exports", "maps to write"}, self.exports);
    }
};

/// @throws InvalidArgument naming the field ("material.specular.exponent"), what it must be and what it is
void validate(const Scene& scene);
void validate(const Material& material);

/// A path of the scene as it can be opened: relative ones start at scene.folder; "builtin:NAME" and absolute ones stay.
std::string resolved(const Scene& scene, const std::string& path);

/// Whether view.geometry is the name of a body that is built in; otherwise it names a mesh file.
bool isBuiltinGeometry(std::string_view geometry);

/// Where the camera of a scene is at first: in the room, where the geometry is the window; otherwise before and above the object.
CameraSettings initialCamera(std::string_view geometry);

/// The lobe of the reflection; a mirror is ggx with alpha = 0.
Lobe lobe(const SpecularSettings& specular);
/// The BRDF of the scene's material, a measurement's file read. Only of a scene that has one.
/// @throws InvalidArgument naming the field; FileError
Brdf brdfOf(const Scene& scene);
/// The Fresnel term with the metal looked up. @throws InvalidArgument for an unknown metal
Fresnel fresnelTerm(const FresnelSettings& settings);

} // namespace mirrorball
