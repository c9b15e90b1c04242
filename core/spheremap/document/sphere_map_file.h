#pragma once

#include "sphere_map_document.h"

#include <filesystem>
#include <string>

/// Sphere maps as files (`*.spheremap`): JSON, UTF-8, "version": 1 and the fields of SphereMapDocument. Fields that are missing take their
/// defaults; keys and kinds of layers that are not known are kept. Files are not trusted, see field_json.h.
namespace mirrorball {

inline constexpr int sphereMapFileVersion = 1;

/// A file of recorded strokes (stroke_file.h) is read as a document of one paint layer. @throws FileError
SphereMapDocument loadSphereMap(const std::filesystem::path& path);
/// Writes every field, with the paths of storedIn() the new file's folder. The file appears whole or not at all. @throws InvalidArgument
/// naming the field that is out of range (nothing is written); WorkError
void saveSphereMap(const SphereMapDocument& document, const std::filesystem::path& path);

/// The same as text, for a clipboard, an undo record or another file. @throws InvalidArgument
SphereMapDocument sphereMapFromText(const std::string& text);
std::string sphereMapToText(const SphereMapDocument& document);

/// Changes the paths inside that are relative to document.folder so that they start at `folder`, which the document then has.
SphereMapDocument movedTo(SphereMapDocument document, const std::filesystem::path& folder);

/// The same as a file in `folder` keeps it: absolute paths into that folder become relative too, so that it can be moved with what it
/// needs.
SphereMapDocument storedIn(SphereMapDocument document, const std::filesystem::path& folder);

} // namespace mirrorball
