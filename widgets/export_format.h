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
    bool operator==(const ExportFormat&) const = default;
};

const std::vector<ExportFormat>& exportFormats();
/// The index of a target's format in exportFormats(), or -1 for an extension that is not among them.
int formatOf(const ExportTarget& target);
/// The target as a file of that format: its file name gets the extension.
ExportTarget withFormat(ExportTarget target, const ExportFormat& format);
/// Whether a cube is written as six files.
bool hasFaceFiles(const ExportTarget& target);
/// One file or six: a "%s" comes into the file name, or leaves it.
enum class CubeFiles { One, Six };
ExportTarget withCubeFiles(ExportTarget target, CubeFiles files);
/// A name that no target has: "specular", "specular-2", ...
std::string freeName(const std::vector<ExportTarget>& targets, const std::string& wanted);

} // namespace mirrorball::studio
