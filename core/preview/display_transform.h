#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// Display through OpenColorIO: what its configuration makes of scene-linear Rec.709, as GLSL and textures. No OpenGL here.
namespace mirrorball::preview {

/// Which of a configuration's transforms.
struct DisplayChoice {
    std::string config{};  ///< a .ocio file, or "env" for the one that $OCIO names
    std::string display{}; ///< empty: the configuration's default
    std::string view{};    ///< empty: the display's default
    bool operator==(const DisplayChoice&) const = default;
};

/// A table that the shader reads.
struct DisplayTable {
    std::string sampler{};                ///< the uniform's name
    int width = 0, height = 0, depth = 0; ///< height 1 and depth 1: one dimension; depth 1: two
    int channels = 3;
    bool isNearest = false;
    std::vector<float> values{};
};

struct DisplayTransform {
    std::string glsl{}; ///< defines vec4 ocioDisplay(vec4 scene)
    std::vector<DisplayTable> tables{};
    std::string display{}, view{}; ///< as chosen or by default
};

/// The transform from Rec.709 primaries, scene-linear, to the display's encoded values.
/// @throws InvalidArgument naming view.display.config, .display or .view and what there is
std::shared_ptr<const DisplayTransform> displayTransform(const DisplayChoice& choice);

/// What a configuration offers, for lists.
struct DisplayOffer {
    std::string display{};
    std::vector<std::string> views{}; ///< the default first
};
std::vector<DisplayOffer> displayOffers(const std::string& config);

} // namespace mirrorball::preview
