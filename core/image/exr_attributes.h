#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace mirrorball::exr {

/// A type of attribute, and how many bytes OpenEXR reads of one, whatever size stands before it.
struct FixedSize {
    std::string_view type{};
    int bytes = 0;
};
std::span<const FixedSize> fixedSizes();

/// Looks at the sizes of a header's attributes before OpenEXR does, which takes memory for a text and fills it with zeros, gigabytes of
/// them, before it finds that the file ends there.
/// @return the path, for where it is handed on. What else is wrong with a header OpenEXR says.
/// @throws FileError for an attribute that is larger than the rest of its file
const std::filesystem::path& withPlausibleAttributes(const std::filesystem::path& path);

} // namespace mirrorball::exr
