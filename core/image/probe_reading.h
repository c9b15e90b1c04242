#pragma once

#include "core/base/fields.h"
#include "core/sphere/parameterization.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// How a probe's file is to be read, and what was assumed where nobody said. One struct each, which commands, scenes and forms share.
namespace mirrorball {

/// Which rectangle of an OpenEXR file is the picture.
enum class PictureWindow { Display, Data };
/// What is done with a picture whose shape is not that of its map.
enum class Fit { None, Stretch, Pad, Crop };
/// What lies outside the angles of view.
enum class BeyondView { Black, Mirrored };
/// The axis whose sign is changed.
enum class MirrorAxis { None, X, Y, Z };

std::span<const std::string_view> words(PictureWindow); // display data
std::span<const std::string_view> words(Fit);           // none stretch pad crop
std::span<const std::string_view> words(BeyondView);    // black mirrored
std::span<const std::string_view> words(MirrorAxis);    // none x y z

/// How a file is to be read. What is left as it is here is taken from the file itself.
struct ProbeReading {
    std::optional<Parameterization> parameterization{}; ///< empty: found out from the file
    std::string part{};
    std::string layer{};
    PictureWindow window = PictureWindow::Display;
    std::string colorSpace{};
    Fit fit = Fit::None;
    double horizontalAngleDeg = 0.0;
    double verticalAngleDeg = 0.0;
    BeyondView beyond = BeyondView::Black;
    std::string faces{};
    MirrorAxis mirror = MirrorAxis::None;
    glm::dvec3 rotateDeg{0.0}; ///< about Y, X, Z

    bool operator==(const ProbeReading&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"parameterization", "how the file shows the sphere; auto: found out from the file"}, self.parameterization);
        visit(Field{"part", "which picture of a file that holds several: its number, from 0, or its name; empty: the one with the colors"},
              self.part);
        visit(Field{"layer", "which layer's channels are the colors; empty: chosen, default: those without a name"}, self.layer);
        visit(Field{"window", "OpenEXR: display is the picture, black where the file holds no data; data is only what it holds"},
              self.window);
        visit(Field{"color_space", "of the file's colors: linear, srgb, gamma1.8, gamma2.2, display-p3, adobe-rgb, acescg, ..., or a "
                                   "space of the OpenColorIO configuration that $OCIO names; empty: as the file says"},
              self.colorSpace);
        visit(Field{"fit", "a picture whose shape is not its map's: stretched, padded with black to its angles of view, or cropped"},
              self.fit);
        visit(Field{"horizontal_angle", "that the picture spans; 0: found from the shape", 0, 360, "degrees"}, self.horizontalAngleDeg);
        visit(Field{"vertical_angle", "that the picture spans; 0: found from the shape", 0, 180, "degrees"}, self.verticalAngleDeg);
        visit(Field{"beyond", "outside the angles of view: black, or mirrored from the other side, as for a fisheye hemisphere"},
              self.beyond);
        visit(Field{"faces", "cube faces in the order in which the file has them, px nx py ny pz nz, each with :90, :180 or :270 where it "
                             "lies turned; empty: as the arrangement has them"},
              self.faces);
        visit(Field{"mirror", "the axis whose sign the file has the other way round"}, self.mirror);
        visit(Field{"rotate", "turns the probe about Y, X and Z, Z first: levels a horizon", -36000, 36000, "degrees"}, self.rotateDeg);
    }
};

/// The probe's orientation: d of the file is at orientation(reading) d of the map. Ry Rx Rz times the mirroring, which comes first. A turn
/// about Y is a yaw as direction.h has it, about X one from +Y towards +Z, about Z one from +X towards +Y.
glm::dmat3 orientation(const ProbeReading& reading);

/// Angles of `Y,X,Z` in degrees, or those of a quaternion `w,x,y,z`, which need not be of unit length.
/// @throws InvalidArgument that begins with `option`
glm::dvec3 parseRotation(const std::string& option, const std::string& text);

enum class Certainty { Certain, Likely, Guess };
std::string_view name(Certainty certainty); // certain likely guess

/// One thing that was decided about a file: part, layer, windows, encoding, alpha, orientation, parameterization, handedness.
struct Assumption {
    std::string topic{};
    std::string value{}; ///< what it was taken for
    std::string why{};   ///< how that was decided
    Certainty certainty = Certainty::Certain;
    std::vector<std::string> others{}; ///< what else could have been chosen
    bool operator==(const Assumption&) const = default;
};

/// Puts an assumption in the place of that on the same topic.
void assume(std::vector<Assumption>& assumptions, Assumption assumption);

/// What was chosen, in one clause, of those topics that a file can well have otherwise: "part 1 (beauty) of 2; layer default".
std::string summary(const std::vector<Assumption>& assumptions);

} // namespace mirrorball
