#pragma once

#include "core/base/opened_file.h"

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
/// What else is wrong with a header OpenEXR says. @throws FileError for an attribute that is larger than the rest of its file
void checkAttributes(OpenedFile& file);

} // namespace mirrorball::exr
