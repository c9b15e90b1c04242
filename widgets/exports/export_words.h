#pragma once

#include "core/scene/export_estimate.h"
#include "core/scene/scene.h"

#include <QString>

#include <array>
#include <string>
#include <vector>

/// What the export dialog says of maps and files, in the user's language.
namespace mirrorball::studio {

/// The kinds in the order in which they are offered.
inline constexpr std::array exportKinds{ExportKind::Source, ExportKind::Specular, ExportKind::Diffuse, ExportKind::Chain,
                                        ExportKind::Painted};

QString kindText(ExportKind kind);
/// "3 files"
QString filesText(size_t count);
/// One map: its files, its levels, what they take.
QString mapText(const ExportEstimate& estimate);
/// All maps that are chosen, by name: files, bytes, and time where anything is computed.
/// @param sharedSeconds  of reading the probe, once for all that need it
QString totalText(const std::vector<ExportEstimate>& estimates, const std::vector<std::string>& chosen, double sharedSeconds);

} // namespace mirrorball::studio
