#pragma once

#include "scene_kinds.h"

#include "core/base/fields.h"

#include <glm/glm.hpp>

#include <string>

/// How a scene is seen: camera, what stands behind the object, display. Plain values, with their fields.
namespace mirrorball {

/// Orbits the target: yaw 0, pitch 0 looks from +Z; yaw turns the eye towards +X, pitch towards +Y.
struct CameraSettings {
    double yawDeg = 25.0;
    double pitchDeg = 18.0;
    double rollDeg = 0.0;
    double distance = 3.4;
    double fieldOfViewDeg = 36.0;
    glm::dvec3 target{0.0};
    Projection projection = Projection::Perspective;
    UnknownKeys unknown{};

    bool operator==(const CameraSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"yaw", "longitude of the eye", -36000, 36000, "degrees"}, self.yawDeg);
        visit(Field{"pitch", "latitude of the eye", -90, 90, "degrees"}, self.pitchDeg);
        visit(Field{"roll", "turns the camera about its view, counterclockwise seen from behind it", -36000, 36000, "degrees"},
              self.rollDeg);
        visit(Field{"distance", "from the target; the object's radius is 1", 0.01, 1000}, self.distance);
        visit(Field{"fov", "angle of view from bottom to top", 1, 170, "degrees"}, self.fieldOfViewDeg);
        visit(Field{"target", "point that the eye looks at and orbits; the object's center is 0, 0, 0", -1000, 1000}, self.target);
        visit(Field{"projection", "perspective, or orthographic at the size the object has in perspective"}, self.projection);
    }
};

/// What stands behind the object.
struct BackdropSettings {
    Backdrop kind = Backdrop::Environment;
    double blur = 0.3;
    glm::dvec3 color{0.18};
    UnknownKeys unknown{};

    bool operator==(const BackdropSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"kind", "the environment, the environment blurred, one color, or none (transparent)"}, self.kind);
        visit(Field{"blur", "blurred: ggx roughness of the blur", 0.01, 1}, self.blur);
        visit(Field{"color", "color: linear RGB", 0, 1000}, self.color);
    }
};

/// A window in a room, view.geometry "window": what lies outside is the material's sphere map, and behind it up to two more, each a layer
/// at its depth. Source: 003 section 4
struct WindowSettings {
    double depth = 4.0;
    std::string middle{};
    double middleDepth = 12.0;
    std::string far{};
    double farDepth = 1000.0;
    UnknownKeys unknown{};

    bool operator==(const WindowSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"depth", "of the material's sphere map behind the pane; the pane is 1.2 wide", 0, 1e6}, self.depth);
        visit(Field{"middle", "sphere map behind that one, seen where it is transparent; empty: none"}, self.middle);
        visit(Field{"middle_depth", "its depth", 0, 1e6}, self.middleDepth);
        visit(Field{"far", "sphere map behind both; empty: none"}, self.far);
        visit(Field{"far_depth", "its depth", 0, 1e6}, self.farDepth);
    }
};

/// What brings radiance to the display: an OpenColorIO configuration's display and view in place of tone curve and sRGB.
struct DisplaySettings {
    std::string config{};
    std::string display{};
    std::string view{};
    UnknownKeys unknown{};

    bool operator==(const DisplaySettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"config", "OpenColorIO configuration: a .ocio file, or env for the one that $OCIO names; empty: tone curve and sRGB"},
              self.config);
        visit(Field{"display", "of the configuration; empty: its default"}, self.display);
        visit(Field{"view", "of the display; empty: its default"}, self.view);
    }
};

/// How the picture is taken.
struct ViewSettings {
    std::string geometry = "teapot";
    int tessellation = 0;
    Shading shading = Shading::Material;
    CameraSettings camera{};
    WindowSettings window{};
    ToneChoice tone = ToneChoice::Auto;
    double exposure = 0.0;
    DisplaySettings display{};
    bool dither = false; ///< pictures of scenes that say nothing of it stay as they were
    BackdropSettings background{};
    int width = 1280;
    int height = 720;
    UnknownKeys unknown{};

    bool operator==(const ViewSettings&) const = default;
    template <typename Self, typename Visit>
    static void visitFields(Self& self, Visit&& visit)
    {
        visit(Field{"geometry", "teapot, torus, sphere, box, window, or a mesh file (.obj .ply .stl .off .gltf .glb .fbx .dae .3ds)"},
              self.geometry);
        visit(Field{"tessellation", "quads along a quarter of a circumference; 0: as fine as the picture needs", 0, 256},
              self.tessellation);
        visit(
            Field{
                "shading",
                "the material, or what it is computed from: triangles, normals as colors or as lines, texture coordinates, seams or levels "
                "of the map, the bounding box"},
            self.shading);
        visit(Field{"camera", "where the eye is"}, self.camera);
        visit(Field{"window", "the window of the geometry of that name"}, self.window);
        visit(Field{"tone", "curve that brings radiance to the display; auto: a sphere map that replaces the material is shown as it was "
                            "painted, all else through filmic"},
              self.tone);
        visit(Field{"exposure", "brightness of the display picture: times 2^exposure", -64, 64, "EV"}, self.exposure);
        visit(Field{"display", "display through OpenColorIO"}, self.display);
        visit(Field{"dither", "8-bit pictures are rounded by a fine pattern of half a step, so that dark gradients show no bands"},
              self.dither);
        visit(Field{"background", "what stands behind the object"}, self.background);
        visit(Field{"width", "of the picture", 1, 16384, "pixels"}, self.width);
        visit(Field{"height", "of the picture", 1, 16384, "pixels"}, self.height);
    }
};

} // namespace mirrorball
