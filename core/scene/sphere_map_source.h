#pragma once

#include "scene.h"

#include "core/base/job.h"
#include "core/spheremap/document/sphere_map_document.h"
#include "core/spheremap/evaluation/sphere_map_cache.h"
#include "core/spheremap/evaluation/sphere_map_texels.h"

#include <string>
#include <string_view>

/// From the word in a scene to the texels of a sphere map.
namespace mirrorball {

/// Whether a source is a file; otherwise it is the name of a preset.
inline bool isSphereMapFile(std::string_view source) { return source.find_first_of("./\\") != std::string_view::npos; }

/// Whether a source is a picture of a sphere map.
bool isSphereMapPicture(std::string_view source);

/// The document of a source; a picture becomes a document of one image layer. @throws as readSphereMap()
SphereMapDocument readSphereMapDocument(const Scene& scene, const std::string& field, const std::string& source);

/// The texels of a document. @throws as evaluateLevels()
SphereMapTexels sphereMapTexels(const SphereMapDocument& document, int size, SphereMapLevels levels, const JobControl& job = {});
/// The same while the document is edited: @param cache keeps what an edit does not reach, and says the size
SphereMapTexels sphereMapTexels(SphereMapCache& cache, const SphereMapDocument& document, SphereMapLevels levels,
                                const JobControl& job = {});

/// The texels of a source: a document is evaluated at `size`; a square picture of a sphere map is taken as it is, looked up by normal.
/// @param field for messages, "material.sphere_map.source"
/// @throws InvalidArgument for a preset that is not known; FileError
SphereMapTexels readSphereMap(const Scene& scene, const std::string& field, const std::string& source, int size, SphereMapLevels levels,
                              const JobControl& job = {});

} // namespace mirrorball
