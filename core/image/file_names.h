#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

/// Names of outputs that stand for several files.
namespace mirrorball {

/// What the marks of a name become.
struct NameWords {
    std::string_view face{};    ///< `%s`; empty: the mark stays
    std::optional<int> level{}; ///< `%d`, or `%0Nd` with zeros in front up to N digits
    std::optional<int> frame{}; ///< a run of `#`, with zeros in front up to its length
};

/// The file that a name with marks means. `%%` is a percent sign; every other text, percent signs before other letters too, is kept as it
/// is. Only the last part of the path is looked at.
std::filesystem::path fileNamed(const std::filesystem::path& pattern, const NameWords& words);

/// Whether the name has a `%s`.
bool namesFaces(const std::filesystem::path& pattern);
/// Whether the name has a `%d` or `%0Nd`, which stands for the number of a level: one file a level then, of any format.
bool namesLevels(const std::filesystem::path& pattern);
/// Whether the name has a `#`.
bool namesFrames(const std::filesystem::path& pattern);

/// A `%d` right before a letter ("100%done.exr") may be no mark at all, and where there is only one level nothing tells.
/// @throws InvalidArgument saying how to write either
void refuseDoubtfulLevel(const std::filesystem::path& pattern);

} // namespace mirrorball
