#pragma once

#include "layer.h"

#include <filesystem>
#include <string>
#include <vector>

/// A sphere map as a document: a stack of layers, evaluated at any size (evaluate.h). A plain value, which files and the studio share.
namespace mirrorball {

inline constexpr int mostLayers = 1000;

struct SphereMapDocument {
    std::string title{};
    std::string description{};
    SphereMapIndex index = SphereMapIndex::Normal;
    std::vector<Layer> layers{}; ///< the bottom one first
    UnknownKeys unknown{};
    /// Where relative paths start from: the folder of the document's file. Not written into it. Empty: the current folder.
    std::filesystem::path folder{};

    bool operator==(const SphereMapDocument&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"title", "what a list shows"}, self.title);
        visit(Field{"description", "one sentence"}, self.description);
        visit(Field{"index", "what looks it up: the surface's normal, or the direction that the surface mirrors"}, self.index);
        visit(Field{"layers", "from the bottom to the top", 0, mostLayers}, self.layers);
    }
};

/// @throws InvalidArgument naming the field ("layers[3].content.width"), what it must be and what it is
void validate(const SphereMapDocument& document);

/// Whether a layer is different in the levels of a mip chain than an average of the level above would be: a width in pixels, or levels
/// that it leaves out.
bool hasAuthoredLevels(const SphereMapDocument& document);

} // namespace mirrorball
