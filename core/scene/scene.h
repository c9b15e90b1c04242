#pragma once

#include "material_settings.h"
#include "scene_kinds.h"
#include "view_settings.h"

#include "core/base/fields.h"
#include "core/filter/lobe.h"
#include "core/filter/method.h"
#include "core/image/color.h"
#include "core/image/probe_reading.h"
#include "core/shading/fresnel.h"
#include "core/sphere/parameterization.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A scene says what to make: which probe, on which material, seen how, written into which maps. One plain value, which the command
/// line reads from a file (scene_file.h) and the studio edits. Angles are in degrees here, and only here in core: they stand as they
/// were typed, so that a file that is loaded and saved stays the same.
namespace mirrorball {

struct Brdf;

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

/// The body that a view.geometry is the word of; otherwise it names a mesh file.
std::optional<GeometryKind> builtinGeometry(std::string_view geometry);

/// Whether the scene shows the window of a room and no object.
bool showsWindow(const Scene& scene);

/// Where the camera of a scene is at first: in the room, where the geometry is the window; otherwise before and above the object.
CameraSettings initialCamera(std::string_view geometry);

/// The lobe of the reflection; a mirror is ggx with alpha = 0.
Lobe lobe(const SpecularSettings& specular);
Lobe lobe(const ClearCoatSettings& coat);
/// The BRDF of the scene's material, a measurement's file read. Only of a scene that has one.
/// @throws InvalidArgument naming the field; FileError
Brdf brdfOf(const Scene& scene);
/// The Fresnel term with the metal looked up. @throws InvalidArgument for an unknown metal
Fresnel fresnelTerm(const FresnelSettings& settings);

} // namespace mirrorball
