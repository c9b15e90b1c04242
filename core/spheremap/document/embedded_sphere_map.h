#pragma once

#include "sphere_map_document.h"

#include <filesystem>
#include <memory>
#include <string>

namespace mirrorball {

/// A sphere map inside another document, a scene: shared, because it may hold thousands of strokes and scenes are copied with every edit.
/// Compares by what it holds.
struct EmbeddedSphereMap {
    std::shared_ptr<const SphereMapDocument> document{}; ///< null: none

    explicit operator bool() const { return document != nullptr; }
    bool operator==(const EmbeddedSphereMap& other) const
    {
        return document == other.document || (document && other.document && *document == *other.document);
    }
};

/// @throws InvalidArgument naming the field
void checkFields(const std::string& path, const EmbeddedSphereMap& map);

/// The same as a file in `folder` keeps it, see storedIn() of a document.
EmbeddedSphereMap storedIn(const EmbeddedSphereMap& map, const std::filesystem::path& folder);

} // namespace mirrorball
