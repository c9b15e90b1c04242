#include "material_presets.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mirrorball {

namespace {

FresnelSettings metal(const char* name) { return {.kind = FresnelKind::Conductor, .metal = name}; }

SpecularSettings ggx(double roughness) { return {.lobe = SurfaceLobe::Ggx, .roughness = roughness}; }

DiffuseSettings paint(double red, double green, double blue) { return {.weight = 1.0, .color = {red, green, blue}}; }

/// A surface that only reflects.
Material reflecting(SpecularSettings specular, FresnelSettings fresnel = {})
{
    return {.specular = std::move(specular), .fresnel = std::move(fresnel)};
}

/// Paint under a dielectric coat.
Material coated(SpecularSettings specular, double index, DiffuseSettings below)
{
    return {.specular = std::move(specular),
            .fresnel = {.kind = FresnelKind::Dielectric, .index = index},
            .combine = Combine::Coat,
            .diffuse = std::move(below)};
}

/// Any of them under a clear, mirroring layer.
Material lacquered(Material below)
{
    below.clearCoat.weight = 1.0;
    return below;
}

/// A surface whose lobe knows the view.
Material viewDependent(const char* model) { return {.brdf = {.model = model}}; }

/// Paint under a layer of such a lobe, which gets the light that the layer does not reflect.
Material layered(const char* model, DiffuseSettings below)
{
    return {.brdf = {.model = model}, .combine = Combine::Coat, .diffuse = std::move(below)};
}

Material matt(DiffuseSettings diffuse) { return {.specular = {.weight = 0.0}, .diffuse = std::move(diffuse)}; }

std::vector<MaterialPreset> makePresets()
{
    std::vector<MaterialPreset> presets;
    const auto add = [&](const char* name, const char* description, Material material) {
        presets.push_back({name, description, std::move(material)});
    };
    const SpecularSettings mirror{};
    add("mirror", "A perfect mirror: shows the environment as it is.", {});
    add("chrome", "Polished chromium: a mirror with the cool tint of the metal.", reflecting(mirror, metal("chromium")));
    add("silver", "Polished silver: the brightest of the metals.", reflecting(mirror, metal("silver")));
    add("gold", "Polished gold with a faint bloom.", reflecting(ggx(0.12), metal("gold")));
    add("copper", "Satin copper: a soft, reddish reflection.", reflecting(ggx(0.25), metal("copper")));
    add("brushed-metal", "Brushed aluminium: a broad Phong highlight with exponent 60.",
        reflecting({.lobe = SurfaceLobe::Phong, .exponent = 60.0}, metal("aluminium")));
    add("satin", "Satin-finished light metal: a ggx lobe of roughness 0.4 that mirrors alike at every angle.",
        reflecting({.lobe = SurfaceLobe::Ggx, .roughness = 0.4, .color = {0.86, 0.86, 0.88}}));
    add("glass", "Dark glass: clear in front, mirroring towards the edges.", coated(mirror, 1.5, paint(0.012, 0.018, 0.016)));
    add("car-paint", "Deep red lacquer under a clear, mirroring coat.", coated(mirror, 1.5, paint(0.42, 0.012, 0.02)));
    add("candy-paint", "Candy paint: a glossy, colored metal under a clear, mirroring coat.",
        lacquered(reflecting({.lobe = SurfaceLobe::Ggx, .roughness = 0.45, .color = {0.72, 0.03, 0.06}}, metal("aluminium"))));
    add("black-lacquer", "Piano lacquer: black, and a sharp reflection on top.", coated(mirror, 1.6, paint(0.006, 0.006, 0.007)));
    add("porcelain", "Glazed white porcelain: bright and matt below, mirroring above.", coated(mirror, 1.5, paint(0.86, 0.85, 0.82)));
    add("pearl", "Pearl: a soft sheen over cream.",
        coated({.lobe = SurfaceLobe::Ggx, .roughness = 0.3, .weight = 1.6, .color = {1.0, 0.95, 0.98}}, 1.68, paint(0.78, 0.71, 0.66)));
    add("plastic-red", "Red plastic with a soft highlight.", coated(ggx(0.28), 1.46, paint(0.62, 0.03, 0.025)));
    add("rubber", "Black rubber: almost no highlight but at grazing angles.", coated(ggx(0.65), 1.5, paint(0.03, 0.03, 0.032)));
    add("satin-gold", "Satin gold: a wide lobe that stretches and brightens towards grazing angles.",
        viewDependent("ggx:roughness=0.5,metal=gold"));
    add("cast-aluminium", "Cast aluminium: rough, with the tail of ggx.", viewDependent("ggx:roughness=0.7,metal=aluminium"));
    add("blasted-copper", "Sand-blasted copper: Beckmann's facets, which shift the color at grazing angles.",
        viewDependent("beckmann:alpha=0.35,metal=copper"));
    add("satin-lacquer", "Dark green satin lacquer: a dull layer over paint, mirroring at grazing angles.",
        layered("ggx:roughness=0.45,ior=1.5", paint(0.01, 0.1, 0.04)));
    add("matte", "Matt white: nothing but diffuse light.", matt(paint(0.8, 0.8, 0.8)));
    add("clay", "Fired clay: matt and warm.", matt(paint(0.55, 0.25, 0.14)));
    return presets;
}

} // namespace

std::span<const MaterialPreset> materialPresets()
{
    static const std::vector<MaterialPreset> presets = makePresets();
    return presets;
}

const MaterialPreset* findMaterialPreset(std::string_view name)
{
    const auto presets = materialPresets();
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const MaterialPreset& p) { return p.name == name; });
    return found == presets.end() ? nullptr : &*found;
}

} // namespace mirrorball
