#pragma once

#include "flecks.h"
#include "scene_kinds.h"

#include "core/base/fields.h"
#include "core/filter/lookup_choice.h"
#include "core/image/probe_reading.h"
#include "core/spheremap/document/embedded_sphere_map.h"

#include <glm/glm.hpp>

#include <string>

/// What a scene's surface is made of. Plain values, with their fields.
namespace mirrorball {

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

/// A picture of normals on the mesh by its texture coordinates, in tangent space: red towards u, green towards v, blue outwards, as OpenGL
/// has it.
struct NormalMapSettings {
    std::string source{}; ///< an image file, whose path starts at the scene's folder
    double strength = 1.0;
    UnknownKeys unknown{};

    bool operator==(const NormalMapSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"source", "normal map of tangent space by the mesh's texture coordinates, +Y up as in OpenGL; empty: none"},
              self.source);
        visit(Field{"strength", "how far normals tilt, times the map's own; 0: not at all", 0, 4}, self.strength);
    }
};

/// A lobe that knows the view, in place of the specular lobe and the Fresnel term: the picture reads it as a few lookups into an ordinary
/// ggx chain, as an engine would (lookup_table.h), or exactly, from maps of its own (view_stack.h).
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
        visit(Field{"kind",
                    "fitted: lookups that are fitted to the lobe; split-sum, three, filament: what those show, to compare; exact: the "
                    "integral over the probe, the truth for all of them"},
              self.kind);
        visit(Field{"lookups", "fitted: how many into a ggx chain stand for the lobe at each angle of view; 0: the split sum", 0, 8},
              self.lookups);
    }
};

/// Flecks, and where there are how many.
struct FleckSettings {
    Flecks cells{};
    std::string pattern{}; ///< an image file, whose path starts at the scene's folder
    UnknownKeys unknown{};

    bool operator==(const FleckSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        Flecks::visitFields(self.cells, visit);
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

/// A clear layer over all of the material below: w F L_c + (1 - w F) L, with w its weight, F of a dielectric and L_c the light that its own
/// lobe reflects. What it reflects the layers below do not get; the light's way through it is left out. Source: 000 section 3.1.1, of two
/// layers that both reflect. Or one lobe more, which takes nothing from them: w F L_c + L. Source: 000 section 3.2, of several prefiltered
/// maps that are added.
struct ClearCoatSettings {
    double weight = 0.0;
    double index = 1.5;
    Combine combine = Combine::Coat;
    SurfaceLobe lobe = SurfaceLobe::Mirror;
    double exponent = 5000.0;
    double roughness = 0.1;
    UnknownKeys unknown{};

    bool operator==(const ClearCoatSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"weight", "share of the surface that has it; 0: none", 0, 1}, self.weight);
        visit(Field{"index", "index of refraction of the layer", 1e-3, 1e9}, self.index);
        visit(Field{"combine", "coat: what it reflects does not get below it; add: its light comes on top, a lobe more"}, self.combine);
        visit(Field{"lobe", "mirror, or how a glossy layer spreads the reflection"}, self.lobe);
        visit(Field{"exponent", "phong: the larger, the sharper", 0, 1e9}, self.exponent);
        visit(Field{"roughness", "ggx: 0 is a mirror, 1 fully rough; alpha is its square", 0, 1}, self.roughness);
    }
};

/// A material: F L_m + L_d (add) or F L_m + (1 - F) L_d (coat), with L_m the specular and L_d the diffuse part. With a BRDF, F L_m is the
/// light that it reflects and F its directional albedo. Over it a clear coat.
struct Material {
    SpecularSettings specular{};
    FresnelSettings fresnel{};
    BrdfSettings brdf{};
    Combine combine = Combine::Add;
    DiffuseSettings diffuse{};
    ClearCoatSettings clearCoat{};
    NormalMapSettings normalMap{};
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
        visit(Field{"clear_coat", "a clear layer over all of it, with a lobe of its own"}, self.clearCoat);
        visit(Field{"normal_map", "normals of a finer surface than the mesh"}, self.normalMap);
        visit(Field{"lambda", "least mip level of the reflection: blurs it without filtering", 0, 16}, self.lambda);
        visit(Field{"lambda_grazing",
                    "with lambda: sharper where the surface is seen at a grazing angle; 1 as rough surfaces do, more exaggerates", 0, 8},
              self.lambdaGrazing);
        visit(Field{"lod_bias", "moves the mip level of the reflection by this much; lambda then holds it from below", -16, 16},
              self.lodBias);
        visit(Field{"sphere_map", "a painted sphere map"}, self.sphereMap);
    }
};

} // namespace mirrorball
