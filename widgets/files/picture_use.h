#pragma once

#include <QString>

#include <optional>

namespace mirrorball::studio {

/// What a picture can become in a scene.
enum class PictureUse {
    Probe,     ///< the light
    SphereMap, ///< the look of the material: linked, it stays in its file
    Layer,     ///< a layer of the scene's own sphere map
};

/// Where something is dropped, or pasted.
enum class DropPlace {
    Layers,          ///< the list of layers
    SphereMap,       ///< the disc, or what stands around it
    BesideSphereMap, ///< elsewhere while the dock of the sphere map is in front
    Elsewhere,
};

/// What a picture's header tells of its use.
struct PictureFacts {
    bool isSquare = false;
    bool mayBeBall = false;     ///< square, and silent about what it is: a light probe or the picture of a ball
    bool saysSphereMap = false; ///< it was exported as the picture of a sphere map
    int levels = 1;             ///< more: it may be prefiltered
};
/// Reads the header alone. Nothing where it cannot be read, or where the path stands for several files.
std::optional<PictureFacts> pictureFacts(const QString& path);

/// How a picture is used that comes to a place. Nothing: it has to be asked for.
std::optional<PictureUse> useOfPicture(const PictureFacts& facts, DropPlace place);

} // namespace mirrorball::studio
