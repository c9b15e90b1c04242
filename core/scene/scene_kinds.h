#pragma once

#include "core/filter/lookup_choice.h"
#include "core/filter/method.h"
#include "core/image/color.h"
#include "core/shading/fresnel.h"
#include "core/sphere/parameterization.h"

#include <span>
#include <string_view>

/// The kinds that a scene names, and their words.
namespace mirrorball {

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

} // namespace mirrorball
