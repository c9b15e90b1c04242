#pragma once

#include "scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Scenes and materials as files: JSON, UTF-8. A scene file (`*.mirrorball`) holds "version": 1 and the fields of Scene; a material file
/// holds the fields of Material. Fields that are missing take their defaults; keys that are not known are kept.
///
/// Files are not trusted: they may hold at most 128 MiB, nested at most 64 deep, no key twice in an object. Whatever is wrong gives one
/// line with the file, the field, what it must be and what it is.
namespace mirrorball {

inline constexpr int sceneFileVersion = 1;

/// @throws FileError
Scene loadScene(const std::filesystem::path& path);
/// Writes every field. Paths inside that are relative to scene.folder are written relative to the new file's folder, and so are absolute
/// ones into that folder, those of an embedded sphere map too: the folder may be moved as a whole. The file appears whole or not at all.
/// @throws InvalidArgument naming the field that is out of range (nothing is written); WorkError
void saveScene(const Scene& scene, const std::filesystem::path& path);

/// The material of a material file, or of a scene file. Its relative paths, which start at that file's folder, become absolute: the
/// material is for a scene elsewhere. @throws FileError
Material loadMaterial(const std::filesystem::path& path);
/// Writes the scene's material, with its paths as saveScene() does. @throws InvalidArgument, WorkError
void saveMaterial(const Scene& scene, const std::filesystem::path& path);

/// One field of a scene as files, command line and forms name it.
struct FieldEntry {
    std::string path{}; ///< "material.specular.exponent"
    Field field{};
    std::vector<std::string_view> words{}; ///< of an enum or of true and false; empty otherwise
};
/// All fields of a scene but those of its exports, in the order of the file.
std::vector<FieldEntry> sceneFields();
/// Those of its first export: "exports[0].name".
std::vector<FieldEntry> exportFields();

/// One field, or a group of them, as the JSON text that a file has; all of the scene where the path is empty.
/// @throws InvalidArgument naming what there is
std::string fieldText(const Scene& scene, const std::string& path);

/// Sets one field by its path ("material.specular.exponent", "exports[0].size") to a value written as in a file; quotes around words may
/// be left out. What the command line's options do. @throws InvalidArgument naming the field
void setField(Scene& scene, const std::string& path, const std::string& value);

} // namespace mirrorball
