#pragma once

#include <QString>

#include <filesystem>
#include <string>
#include <string_view>

/// Text and paths between Qt and core, and core's words in the user's language.
namespace mirrorball::studio {

inline QString toQString(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }
inline std::filesystem::path toPath(const QString& path) { return std::filesystem::path(path.toStdU16String()); }
inline QString fromPath(const std::filesystem::path& path) { return QString::fromStdU16String(path.u16string()); }

/// A field's name, help or unit, or an enum's word, in the user's language: "exponent" gives "Exponent".
QString fieldText(std::string_view text);
/// The same with its first letter in upper case: for labels, items and tooltips.
QString labelText(std::string_view text);

} // namespace mirrorball::studio
