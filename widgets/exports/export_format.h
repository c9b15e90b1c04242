#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <vector>

namespace mirrorball::studio {

/// A file format with its sample type, as the export dialog offers it.
struct ExportFormat {
    QString text;
    QString extension; ///< ".exr"
    bool half = false;
    bool holdsLevels = false;
    bool isShown = false; ///< a display picture of 8 bits
    bool operator==(const ExportFormat&) const = default;
};

const std::vector<ExportFormat>& exportFormats();
/// The index of a target's format in exportFormats(), or -1 for an extension that is not among them.
int formatOf(const ExportTarget& target);
/// The target as a file of that format: its file name gets the extension.
ExportTarget withFormat(ExportTarget target, const ExportFormat& format);
/// The format in words, for a kind of map: a painted one is not tone-mapped.
QString formatText(const ExportFormat& format, ExportKind kind);
/// Whether a cube is written as six files.
bool hasFaceFiles(const ExportTarget& target);
/// One file or six: a "%s" comes into the file name, or leaves it.
enum class CubeFiles { One, Six };
ExportTarget withCubeFiles(ExportTarget target, CubeFiles files);
/// Whether each level is a file by request, where the format could hold them all.
bool hasLevelFiles(const ExportTarget& target);
/// One file or one a level: a "%d" comes into the file name, or leaves it.
enum class LevelFiles { One, Each };
ExportTarget withLevelFiles(ExportTarget target, LevelFiles files);
/// Whether a target can have coarser levels at all, with its format and file name.
bool canHaveMips(const ExportTarget& target);
/// With or without coarser levels.
enum class Mips { None, All };
ExportTarget withMips(ExportTarget target, Mips mips);
/// The target as a map of another kind: what means nothing for that kind is taken off.
ExportTarget withKind(ExportTarget target, ExportKind kind);
/// What a new export of a scene begins with: the map that the picture reads, or a matcap as other programs take it - a picture, or where
/// its levels are painted by hand, all of them in one file.
ExportTarget newTarget(const Scene& scene, ExportKind kind);
/// A name that no target has: "specular", "specular-2", ...
std::string freeName(const std::vector<ExportTarget>& targets, const std::string& wanted);

} // namespace mirrorball::studio
