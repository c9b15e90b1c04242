#pragma once

#include "core/filter/lookup_choice.h"
#include "core/filter/method.h"
#include "core/image/color.h"
#include "core/shading/fresnel.h"
#include "core/sphere/parameterization.h"

#include <span>
#include <string_view>

/// The kinds that a scene names, and their words. The renderer's settings hold the same: a kind has one enum.
namespace mirrorball {

enum class SurfaceLobe { Mirror, Phong, Ggx };

/// How a painted sphere map M, of opacity a, meets the reflected radiance R or the color C of the surface.
enum class SphereMapUse {
    Replace,  ///< M + (1 - a) C
    Multiply, ///< (M + 1 - a) C
    Over,     ///< M + (1 - a) R: the two passes of 003 section 6.1
    Tint,     ///< (M + 1 - a) R
    Add,      ///< M + R: a map of highlights or lights over what the surface shows already, 003 section 5
};

/// Whether the map lies on a color of its own and the material below is not looked at.
constexpr bool hidesMaterial(SphereMapUse use)
{
    switch (use) {
    case SphereMapUse::Replace:
    case SphereMapUse::Multiply:
        return true;
    case SphereMapUse::Over:
    case SphereMapUse::Tint:
    case SphereMapUse::Add:
        break;
    }
    return false;
}

enum class SphereMapLevels { Authored, Plain };

/// Where the place in a sphere map is computed: at every pixel, or at vertices and interpolated between them as in 1999.
enum class LookupAt { Pixel, Vertex };

/// Whose axes a lookup is measured in.
enum class MapSpace {
    World, ///< the map stands still while the camera turns
    Eye,   ///< it turns with the camera, as a sphere map does that was photographed from the viewer's place (003 section 3.4.1)
};

/// The bodies that are built in.
enum class GeometryKind { Teapot, Torus, Sphere, Box, Window };

/// Orthographic shows the camera's target at the same size.
enum class Projection { Perspective, Orthographic };

/// What stands behind the object; none is transparent black. The blur is in the map: environment and blurred are drawn alike.
enum class Backdrop { Environment, Blurred, Color, None };

/// Whether the background is looked up in a map.
constexpr bool isEnvironment(Backdrop kind)
{
    switch (kind) {
    case Backdrop::Environment:
    case Backdrop::Blurred:
        return true;
    case Backdrop::Color:
    case Backdrop::None:
        break;
    }
    return false;
}

enum class ToneChoice { Auto, None, Reinhard, Filmic };

/// The material, or a debug view of what it is computed from. Debug colors are meant for the display: neither exposed nor tone-mapped.
enum class Shading {
    Material,
    Wireframe,   ///< the triangles
    Normals,     ///< world space, [-1, 1] to [0, 1]: x red, y green, z blue
    TexCoords,   ///< u red, v green, under a chequer of 1/16
    Seams,       ///< of the specular map's parameterization: its charts in colors, lines where they meet
    Mips,        ///< the level that the specular lookup reads, in the colors of preview::levelColor()
    NormalLines, ///< a line along the normal of every vertex, or of some where there are many
    Bounds,      ///< the box along the axes that holds the object
};

enum class ExportKind { Source, Specular, Diffuse, Chain, Painted };

/// The words of files and command line for an enum's values, in their order.
std::span<const std::string_view> words(SurfaceLobe);      // mirror phong ggx
std::span<const std::string_view> words(SphereMapUse);     // replace multiply over tint add
std::span<const std::string_view> words(SphereMapLevels);  // authored plain
std::span<const std::string_view> words(LookupAt);         // pixel vertex
std::span<const std::string_view> words(MapSpace);         // world eye
std::span<const std::string_view> words(GeometryKind);     // teapot torus sphere box window
std::span<const std::string_view> words(Projection);       // perspective orthographic
std::span<const std::string_view> words(Backdrop);         // environment blurred color none
std::span<const std::string_view> words(Shading);          // material wireframe normals texcoords seams mips normal-lines bounds
std::span<const std::string_view> words(ExportKind);       // source specular diffuse chain painted
std::span<const std::string_view> words(Parameterization); // latlong cube sphere angular paraboloid octahedral
std::span<const std::string_view> words(FresnelKind);      // none dielectric conductor
std::span<const std::string_view> words(Combine);          // add coat
std::span<const std::string_view> words(Method);           // auto reference spectral direct hierarchical importance paraboloid mip sh9
std::span<const std::string_view> words(ToneChoice);       // auto none reinhard filmic

} // namespace mirrorball
