#include "engine_profile.h"

#include "core/base/error.h"

#include <array>
#include <bit>

namespace mirrorball {

namespace {

constexpr int largestLatlong = 8192; ///< the widest texture that graphics cards of today take is 16384
constexpr EngineFile latlongHdr{.content = EngineContent::Latlong, .file = "{name}.hdr"};

EngineFile text(std::string_view file) { return {.content = EngineContent::Text, .file = file}; }

EngineFile shJson() { return {.content = EngineContent::Sh, .file = "{name}_sh.json"}; }

// Orientations, laws and containers: seen in the programs (tests/engines), but for those without `proven`. model-viewer looks latlongs up
// as three.js does, Godot as ours stand. The others follow from their sources: Bevy's environment_map.wgsl samples (x, y, -z), its last
// level is roughness 1; Unity's skybox shader has longitude atan2(z, x), and its glTF importers negate x; Unreal's LookupLongLatDouble has
// atan2(x, -z) after its swap of y and z, which is also its glTF importer's.

/// What runs in a page.
std::vector<EngineProfile> webEngines()
{
    return {
        {.word = "three",
         .title = "three.js",
         .proven = "0.187.0",
         .how = "A prefiltered cube that its PMREM shader reads as it is, loaded by a few lines with ktx-parse; the latlong for "
                "applications that let three.js filter; light probe coefficients.",
         .files = {{.content = EngineContent::SpecularCube, .file = "{name}_pmrem.ktx2"}, latlongHdr, shJson(), text("{name}_three.js")},
         .latlongYawDeg = -90.0,
         .cube = mirroredInX(),
         .law = RoughnessLaw::Filament,
         .lastSize = 8,
         .note = "KTX2Loader of three.js ignores the faces of cubes with float texels; use the lines in the script."},
        {.word = "model-viewer",
         .title = "model-viewer",
         .proven = "4.4.0",
         .how = "The latlong, turned as its environment lookup asks; it filters by itself.",
         .files = {latlongHdr, text("{name}.html")},
         .latlongYawDeg = -90.0},
        {.word = "filament",
         .title = "Filament",
         .proven = "1.53.4",
         .how = "Prefiltered light with irradiance coefficients, and the skybox, as cmgen names them.",
         .files = {{.content = EngineContent::SpecularCube, .file = "{name}_ibl.ktx", .texels = TexelFormat::R11G11B10},
                   {.content = EngineContent::Skybox, .file = "{name}_skybox.ktx", .texels = TexelFormat::R11G11B10},
                   {.content = EngineContent::Sh, .file = "{name}_sh.txt"},
                   text("{name}_filament.js")},
         .takesLatlong = false,
         .law = RoughnessLaw::Filament,
         .smallest = 32,
         .lastSize = 16,
         .note = "Intensity 1 with exposure (1, 1.2, 100) shows radiance as it is."},
        {.word = "babylon",
         .title = "Babylon.js",
         .proven = "9.35.0",
         .how = "One environment file with every level and the diffuse polynomial.",
         .files = {{.content = EngineContent::BabylonEnv, .file = "{name}.env"}, text("{name}_babylon.js")},
         .cube = mirroredInX(),
         .law = RoughnessLaw::Babylon,
         .note = "A right-handed scene shows it turned by 180 degrees about Y, as it does panoramas; the script sets the turn."},
        {.word = "playcanvas",
         .title = "PlayCanvas",
         .proven = "2.23.3",
         .how = "The atlas that its shader reads as it is, and the skybox as a cube.",
         .files = {{.content = EngineContent::Atlas, .file = "{name}_atlas.png"},
                   {.content = EngineContent::Skybox, .file = "{name}_skybox.dds"},
                   text("{name}_playcanvas.js")},
         .cube = mirroredInX(),
         .law = RoughnessLaw::PlayCanvas,
         .note = "The atlas has 512 x 512 texels whatever the size; the size is the skybox's."}};
}

/// Game engines, tools, and descriptions of scenes that several of them read.
std::vector<EngineProfile> engines()
{
    return {{.word = "bevy",
             .title = "Bevy",
             .how = "A diffuse and a specular cube for EnvironmentMapLight.",
             .files = {{.content = EngineContent::DiffuseCube, .file = "{name}_diffuse.ktx2", .size = 32},
                       {.content = EngineContent::SpecularCube, .file = "{name}_specular.ktx2"},
                       text("{name}_bevy.rs")},
             .takesLatlong = false,
             .cube = mirroredInZ(),
             .law = RoughnessLaw::Linear},
            {.word = "blender",
             .title = "Blender",
             .proven = "3.4.1",
             .how = "The latlong for the world and the viewport's studio lights; the scene's painted sphere map as a MatCap.",
             .files = {{.content = EngineContent::Latlong, .file = "studiolights/world/{name}.exr"}, text("{name}_blender.py")},
             .latlongYawDeg = -90.0},
            {.word = "godot",
             .title = "Godot",
             .proven = "3.2.3",
             .how = "The latlong for a PanoramaSky; Godot filters by itself.",
             .files = {latlongHdr, text("{name}_godot.gd")}},
            {.word = "unity",
             .title = "Unity",
             .how = "The latlong, imported as a cube with specular convolution; Unity filters by itself.",
             .files = {latlongHdr, text("Editor/{name}Import.cs")},
             .latlongYawDeg = 90.0,
             .note = "Turned for scenes whose glTF importer negates x."},
            {.word = "unreal",
             .title = "Unreal Engine",
             .how = "The latlong for a sky light; Unreal filters by itself.",
             .files = {latlongHdr, text("{name}_unreal.py")},
             .latlongYawDeg = 180.0,
             .note = "Turned for scenes whose glTF importer swaps y and z."},
            {.word = "usd",
             .title = "OpenUSD",
             .how = "A DomeLight with the latlong.",
             .files = {{.content = EngineContent::Latlong, .file = "{name}.exr"}, text("{name}.usda")}},
            {.word = "materialx",
             .title = "MaterialX",
             .how = "An environment light with the latlong, as MaterialXView takes it.",
             .files = {latlongHdr, text("{name}.mtlx")},
             .latlongYawDeg = 180.0}};
}

} // namespace

std::string_view name(EngineContent content)
{
    static constexpr std::array<std::string_view, 8> names{"latlong",     "skybox", "specular cube",       "diffuse cube",
                                                           "environment", "atlas",  "spherical harmonics", "script"};
    return names[static_cast<size_t>(content)];
}

std::span<const EngineProfile> engineProfiles()
{
    static const std::vector<EngineProfile> rows = [] {
        std::vector<EngineProfile> all = webEngines();
        for (EngineProfile& row : engines())
            all.push_back(std::move(row));
        return all;
    }();
    return rows;
}

const EngineProfile& engineProfile(std::string_view word, std::string_view option)
{
    std::string known;
    for (const EngineProfile& profile : engineProfiles()) {
        if (profile.word == word)
            return profile;
        known += (known.empty() ? "" : ", ") + std::string(profile.word);
    }
    throw InvalidArgument(std::string(option) + ": '" + std::string(word) + "' is no engine; choose one of " + known);
}

int chainLevels(const EngineProfile& profile, int size)
{
    return std::bit_width(static_cast<unsigned>(size)) - std::bit_width(static_cast<unsigned>(profile.lastSize)) + 1;
}

int checkedSize(const EngineProfile& profile, int size, std::string_view option)
{
    if (size == 0)
        return profile.law ? profile.size : 0;
    const std::string title(profile.title);
    if (!profile.law && (size < profile.smallest || size > largestLatlong))
        throw InvalidArgument(std::string(option) + ": " + title + " takes a latlong whose height is from " +
                              std::to_string(profile.smallest) + " to " + std::to_string(largestLatlong) + "; it is " +
                              std::to_string(size));
    if (profile.law && (size < profile.smallest || size > profile.largest || !std::has_single_bit(static_cast<unsigned>(size))))
        throw InvalidArgument(std::string(option) + ": " + title + " takes cube faces whose edge is a power of two from " +
                              std::to_string(profile.smallest) + " to " + std::to_string(profile.largest) + "; it is " +
                              std::to_string(size));
    return size;
}

} // namespace mirrorball
