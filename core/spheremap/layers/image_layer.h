#pragma once

#include "core/image/probe_reading.h"
#include "core/spheremap/document/layer_kind.h"
#include "core/spheremap/math/level.h"
#include "core/spheremap/math/span.h"

#include <glm/glm.hpp>

#include <string>

namespace mirrorball {

/// What of a picture is used. Blender's matcaps have two passes, `diffuse`, which takes the color of the object, and `specular`, which
/// lies over it; a file without such passes is all diffuse, one with a specular pass alone has a black diffuse one.
enum class ImagePass { All, Diffuse, Specular };
std::span<const std::string_view> words(ImagePass); // all diffuse specular

/// A picture of a ball from a file: any matcap. Shows tint * diffuse + specular. Its alpha is opacity.
struct ImageLayer {
    static constexpr LayerKind kind{"image", "Image", "a picture of a ball from a file, such as a matcap"};
    std::string source{};
    ImagePass pass = ImagePass::All;
    glm::dvec3 tint{1.0};
    double exposure = 0.0;
    double turnDeg = 0.0;
    bool flip = false;
    Fit fit = Fit::None;
    double inset = 0.01;
    UnknownKeys unknown{};

    bool operator==(const ImageLayer&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"source", "image file; the disc is inscribed in it"}, self.source);
        visit(Field{"pass", "all, or one of the two passes of Blender's matcaps"}, self.pass);
        visit(Field{"tint", "color of the diffuse pass, linear RGB", 0, 1000}, self.tint);
        visit(Field{"exposure", "brightness: times 2^exposure", -64, 64, "EV"}, self.exposure);
        visit(Field{"turn", "counterclockwise", -360, 360, "degrees"}, self.turnDeg);
        visit(Field{"flip", "exchanges left and right"}, self.flip);
        visit(Field{"fit", "a picture that is not square: stretched, padded, or cropped about its middle; none: refused"}, self.fit);
        visit(Field{"inset", "how much of the picture's rim is cut away, where it is cut out badly", 0, 0.5, "disc radii"}, self.inset);
    }
};

/// @throws FileError for a file that is missing, damaged, or not square where layer.fit is none
SpanGenerator prepare(const ImageLayer& layer, const Level& level);

/// A path of a document as it can be opened: relative ones start at the level's folder; "builtin:NAME" and absolute ones stay.
std::string assetPath(const Level& level, const std::string& source);
/// What tells one state of a file from another: its path and its time of change.
std::string assetKey(const std::string& path);

} // namespace mirrorball
