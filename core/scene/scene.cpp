#include "scene.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/image/image_format.h"
#include "core/image/map_file.h"
#include "core/shading/brdf.h"
#include "core/shading/brdf_file.h"
#include "core/shading/conductor.h"
#include "core/spheremap/evaluation/evaluate.h"

#include <algorithm>
#include <array>
#include <set>

namespace mirrorball {

namespace {

using namespace std::string_view_literals;
constexpr std::array surfaceLobeWords{"mirror"sv, "phong"sv, "ggx"sv};
constexpr std::array sphereMapUseWords{"replace"sv, "multiply"sv, "over"sv, "tint"sv, "add"sv};
constexpr std::array sphereMapLevelsWords{"authored"sv, "plain"sv};
constexpr std::array lookupAtWords{"pixel"sv, "vertex"sv};
constexpr std::array mapSpaceWords{"world"sv, "eye"sv};
constexpr std::array geometryKindWords{"teapot"sv, "torus"sv, "sphere"sv, "box"sv, "window"sv};
constexpr std::array projectionWords{"perspective"sv, "orthographic"sv};
constexpr std::array backdropWords{"environment"sv, "blurred"sv, "color"sv, "none"sv};
constexpr std::array shadingWords{"material"sv, "wireframe"sv, "normals"sv,      "texcoords"sv,
                                  "seams"sv,    "mips"sv,      "normal-lines"sv, "bounds"sv};
constexpr std::array toneChoiceWords{"auto"sv, "none"sv, "reinhard"sv, "filmic"sv};
constexpr std::array exportKindWords{"source"sv, "specular"sv, "diffuse"sv, "chain"sv, "painted"sv};
constexpr std::array fresnelKindWords{"none"sv, "dielectric"sv, "conductor"sv};
constexpr std::array combineWords{"add"sv, "coat"sv};

template <typename E, size_t count, typename Values>
std::array<std::string_view, count> namesOf(const Values& values)
{
    std::array<std::string_view, count> names;
    std::transform(values.begin(), values.end(), names.begin(), [](E value) { return name(value); });
    return names;
}

void checkBorder(const std::string& path, const MapLayout& layout)
{
    if (layout.border > 0 && (!mapping(layout.kind).hasBorder || 2 * layout.border >= layout.size))
        throw InvalidArgument(path + ".border: must be 0 but for a paraboloid, where it must be less than half the size; it is " +
                              std::to_string(layout.border));
}

void checkPainted(const std::string& path, const ExportTarget& target)
{
    if (target.size > largestSphereMap)
        throw InvalidArgument(path + ".size: must be at most " + std::to_string(largestSphereMap) + " for a painted map; it is " +
                              std::to_string(target.size));
    if (target.border > 0 && (target.mips || 2 * target.border >= target.size))
        throw InvalidArgument(path + ".border: must be less than half the size for a painted map, and 0 with mips; it is " +
                              std::to_string(target.border));
}

Brdf readModel(const std::string& field, const std::string& model)
{
    try {
        return brdfFromText(model);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(field + ": " + error.what());
    }
}

void checkMaterial(const std::string& path, const Material& material)
{
    Material::visitFields(material, RangeChecker(path));
    if (material.fresnel.metal != "custom" && !conductorFromName(material.fresnel.metal)) {
        std::string known;
        for (const Conductor& metal : conductors())
            known += std::string(metal.name) + ", ";
        throw InvalidArgument(fieldPath(path, "fresnel.metal") + ": must be one of " + known + "custom; it is " +
                              inQuotes(material.fresnel.metal));
    }
    if (!material.brdf.isNone() && !isBrdfFile(material.brdf.model))
        readModel(fieldPath(path, "brdf.model"), material.brdf.model);
}

/// A word that is a file name on every system, and no path.
bool isPlainName(const std::string& text, std::string_view alsoAllowed)
{
    return !text.empty() && text.size() <= 200 && text.front() != '.' && std::all_of(text.begin(), text.end(), [&](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' ||
               alsoAllowed.find(c) != std::string_view::npos;
    });
}

void checkExports(const std::vector<ExportTarget>& exports)
{
    std::set<std::string> names, files;
    for (size_t i = 0; i < exports.size(); ++i) {
        const ExportTarget& target = exports[i];
        const std::string path = "exports[" + std::to_string(i) + "]";
        if (target.kind == ExportKind::Painted)
            checkPainted(path, target);
        else if (target.faceBorder() > target.size)
            throw InvalidArgument(path + ".border: must be at most the size for a cube; it is " + std::to_string(target.border));
        else
            checkBorder(path, target.layout());
        if (!isPlainName(target.name, ""))
            throw InvalidArgument(path + ".name: must be 1 to 200 letters, digits, - and _; it is " + inQuotes(target.name));
        if (!names.insert(target.name).second)
            throw InvalidArgument(path + ".name: must differ from the other exports' names; " + inQuotes(target.name) + " is taken");
        const std::string file = target.fileName();
        if (!isPlainName(file, ". %") || std::filesystem::path(file).extension().empty())
            throw InvalidArgument(path + ".file: must be a file name with an extension and without folders, such as \"" + target.name +
                                  ".exr\"; it is " + inQuotes(file));
        if (!isWritable(file))
            throw InvalidArgument(path + ".file: must end in a format that can be written, " + writtenExtensions() + "; it is " +
                                  inQuotes(file));
        if (namesFaces(file) && target.layout().kind != Parameterization::Cube)
            throw InvalidArgument(path +
                                  ".file: '%s' stands for the six faces of a cube, and the map is none; give a plain name, or '%d' for "
                                  "one file a level; it is " +
                                  inQuotes(file));
        if (!files.insert(std::filesystem::path(file).stem().string()).second)
            throw InvalidArgument(path + ".file: must differ from the other exports' files in more than the extension; " + inQuotes(file) +
                                  " does not");
    }
}

} // namespace

std::span<const std::string_view> words(SurfaceLobe) { return surfaceLobeWords; }
std::span<const std::string_view> words(SphereMapUse) { return sphereMapUseWords; }
std::span<const std::string_view> words(SphereMapLevels) { return sphereMapLevelsWords; }
std::span<const std::string_view> words(LookupAt) { return lookupAtWords; }
std::span<const std::string_view> words(MapSpace) { return mapSpaceWords; }
std::span<const std::string_view> words(GeometryKind) { return geometryKindWords; }
std::span<const std::string_view> words(Projection) { return projectionWords; }
std::span<const std::string_view> words(Backdrop) { return backdropWords; }
std::span<const std::string_view> words(ToneChoice) { return toneChoiceWords; }
std::span<const std::string_view> words(Shading) { return shadingWords; }
std::span<const std::string_view> words(ExportKind) { return exportKindWords; }
std::span<const std::string_view> words(FresnelKind) { return fresnelKindWords; }
std::span<const std::string_view> words(Combine) { return combineWords; }

std::span<const std::string_view> words(Parameterization)
{
    static const auto names = namesOf<Parameterization, allParameterizations.size()>(allParameterizations);
    return names;
}

std::span<const std::string_view> words(Method)
{
    static const auto names = namesOf<Method, allMethods.size()>(allMethods);
    return names;
}

void validate(const Scene& scene)
{
    Scene::visitFields(scene, RangeChecker(""));
    checkBorder("map", {scene.map.parameterization, scene.map.size, scene.map.border});
    checkMaterial("material", scene.material);
    checkExports(scene.exports);
    if (scene.probe.source.empty())
        throw InvalidArgument("probe.source: must be an image file or builtin:NAME; it is empty");
    if (scene.view.geometry.empty())
        throw InvalidArgument("view.geometry: must be teapot, torus, sphere, box, window or a mesh file; it is empty");
}

void validate(const Material& material) { checkMaterial("", material); }

std::string resolved(const Scene& scene, const std::string& path)
{
    return path.starts_with("builtin:") ? path : (scene.folder / path).string(); // an absolute path replaces the folder
}

std::optional<GeometryKind> builtinGeometry(std::string_view geometry)
{
    const auto found = std::find(geometryKindWords.begin(), geometryKindWords.end(), geometry);
    return found == geometryKindWords.end() ? std::nullopt : std::optional(static_cast<GeometryKind>(found - geometryKindWords.begin()));
}

bool showsWindow(const Scene& scene) { return builtinGeometry(scene.view.geometry) == GeometryKind::Window; }

CameraSettings initialCamera(std::string_view geometry)
{
    if (builtinGeometry(geometry) == GeometryKind::Window)
        return {.yawDeg = 12.0, .pitchDeg = 4.0, .distance = 3.2};
    return {};
}

template <typename Layer>
static Lobe lobeOf(const Layer& layer)
{
    switch (layer.lobe) {
    case SurfaceLobe::Phong:
        return phongLobe(layer.exponent);
    case SurfaceLobe::Ggx:
        return ggxLobe(layer.roughness * layer.roughness);
    case SurfaceLobe::Mirror:
        break;
    }
    return ggxLobe(0.0);
}

Lobe lobe(const SpecularSettings& specular) { return lobeOf(specular); }
Lobe lobe(const ClearCoatSettings& coat) { return lobeOf(coat); }

Brdf brdfOf(const Scene& scene)
{
    const std::string& model = scene.material.brdf.model;
    return readModel("material.brdf.model", isBrdfFile(model) ? resolved(scene, model) : model);
}

Fresnel fresnelTerm(const FresnelSettings& settings)
{
    Fresnel fresnel{.kind = settings.kind, .index = settings.index, .conductor = {settings.n, settings.k}};
    if (settings.kind == FresnelKind::Conductor && settings.metal != "custom") {
        const auto metal = conductorFromName(settings.metal);
        if (!metal)
            throw InvalidArgument("material.fresnel.metal: " + inQuotes(settings.metal) + " is no metal that is built in");
        fresnel.conductor = *metal;
    }
    return fresnel;
}

} // namespace mirrorball
