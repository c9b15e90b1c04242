#include "sphere_map_source.h"

#include "core/base/error.h"
#include "core/base/field_checks.h"
#include "core/image/image_io.h"
#include "core/image/picture_fit.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "core/spheremap/layers/image_layer.h"

#include <filesystem>

namespace mirrorball {

namespace {

/// Its alpha is opacity.
SphereMapTexels readPicture(const std::string& path, Fit fit, const JobControl& job)
{
    const auto reader = openImage(path, {}, Channels::ColorAndOpacity);
    const ImageFileInfo& info = reader->info();
    const bool isSquare = info.width == info.height;
    if ((!isSquare && fit == Fit::None) || squareSize(info.width, info.height, fit) > largestSphereMap)
        throw FileError(path, "is no picture of a sphere map, which is square and has at most " + std::to_string(largestSphereMap) +
                                  " texels an edge; crop it, set material.sphere_map.fit to crop, or make a .spheremap of it");
    Image rgba = readAll(*reader, job, Channels::ColorAndOpacity);
    return {.levels = plainChain(isSquare ? std::move(rgba) : squared(rgba, fit, squareSize(info.width, info.height, fit), job), job)};
}

} // namespace

bool isSphereMapPicture(std::string_view source)
{
    return isSphereMapFile(source) && std::filesystem::path(source).extension() != ".spheremap";
}

SphereMapDocument readSphereMapDocument(const Scene& scene, const std::string& field, const std::string& source)
{
    if (isSphereMapFile(source)) {
        const std::string path = resolved(scene, source);
        return isSphereMapPicture(source)
                   ? SphereMapDocument{.layers = {{.content =
                                                       ImageLayer{.source = path, .fit = scene.material.sphereMap.fit, .inset = 0.0}}}}
                   : loadSphereMap(path);
    }
    if (const SphereMapPreset* preset = findSphereMapPreset(source))
        return preset->document;
    std::string known;
    for (const SphereMapPreset& preset : sphereMapPresets())
        known += (known.empty() ? "" : ", ") + preset.name;
    throw InvalidArgument(field + ": " + inQuotes(source) + " is neither a preset (" + known + ") nor a file");
}

SphereMapTexels sphereMapTexels(const SphereMapDocument& document, int size, SphereMapLevels levels, const JobControl& job)
{
    if (levels == SphereMapLevels::Authored && hasAuthoredLevels(document))
        return {.levels = evaluateLevels(document, size, job), .index = document.index, .hasAuthoredLevels = true};
    return {.levels = plainChain(evaluate(document, {.size = size}, job), job), .index = document.index};
}

SphereMapTexels sphereMapTexels(SphereMapCache& cache, const SphereMapDocument& document, SphereMapLevels levels, const JobControl& job)
{
    cache.update(document, job);
    if (levels == SphereMapLevels::Authored && hasAuthoredLevels(document))
        return {.levels = levelsFrom(cache.image(), document, cache.options(), job), .index = document.index, .hasAuthoredLevels = true};
    return {.levels = plainChain(cache.image(), job), .index = document.index};
}

SphereMapTexels readSphereMap(const Scene& scene, const std::string& field, const std::string& source, int size, SphereMapLevels levels,
                              const JobControl& job)
{
    if (isSphereMapPicture(source))
        return readPicture(resolved(scene, source), scene.material.sphereMap.fit, job);
    return sphereMapTexels(readSphereMapDocument(scene, field, source), size, levels, job);
}

} // namespace mirrorball
