#include "teapot_patches.h"

#include <span>

// Newell measured the pot as profiles turned about the axis, and a handle and a spout that are their own mirror images in z = 0.
// The table keeps that structure. It is the data set that every graphics library carries as 306 points and 32 patches: his 28
// patches flattened to the usual proportions, and the bottom's 4, which were added later. The published points of the knob's tip lie
// up to 0.002 off the axis, which leaves a pinhole there; here the tip is one point.
namespace mirrorball::preview {

namespace {

constexpr double quarterCircle = 0.56; // Newell's offset for a quarter circle of radius 1; the best fit is 0.5523

// Radius and height of the four rows of a surface of revolution, from the top down, and the share of quads along them.
struct Profile {
    std::array<glm::dvec2, 4> rows;
    double share;
};

constexpr Profile body[] = {
    {{{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}}, 0.4}, // rim
    {{{{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}}}, 0.5},           // shoulder
    {{{{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}}}, 0.8},           // belly
};
constexpr Profile bottom[] = {
    {{{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0.0}, {0.0, 0.0}}}, 0.6},
};
constexpr Profile lid[] = {
    {{{{0.0, 3.15}, {0.8, 3.15}, {0.0, 2.85}, {0.2, 2.7}}}, 0.8}, // knob
    {{{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}}, 0.8},  // cover
};

// Half of a tube: four cross sections from its root on, each given by the (x, y) of its two ends in the plane z = 0 and its half width.
struct Section {
    glm::dvec2 first, last;
    double halfWidth;
};
using Tube = std::array<Section, 4>;

constexpr Tube handle[] = {
    {{{{-1.6, 2.025}, {-1.5, 2.25}, 0.3},
      {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
      {{-2.7, 2.025}, {-3.0, 2.25}, 0.3},
      {{-2.7, 1.8}, {-3.0, 1.8}, 0.3}}},
    {{{{-2.7, 1.8}, {-3.0, 1.8}, 0.3},
      {{-2.7, 1.575}, {-3.0, 1.35}, 0.3},
      {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
      {{-2.0, 0.9}, {-1.9, 0.6}, 0.3}}},
};
constexpr Tube spout[] = {
    {{{{1.7, 1.425}, {1.7, 0.6}, 0.66},
      {{2.6, 1.425}, {3.1, 0.825}, 0.66},
      {{2.3, 2.1}, {2.4, 2.025}, 0.25},
      {{2.7, 2.4}, {3.3, 2.4}, 0.25}}},
    {{{{2.7, 2.4}, {3.3, 2.4}, 0.25},
      {{2.8, 2.475}, {3.525, 2.49375}, 0.25},
      {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
      {{2.8, 2.4}, {3.2, 2.4}, 0.15}}},
};

// A profile swept through the quarter from +X to -Z, then turned on about +Y by `quarter` right angles.
TeapotPatch revolved(const Profile& profile, int quarter)
{
    TeapotPatch patch{.points = {}, .uShare = 1.0, .vShare = profile.share};
    for (size_t v = 0; v < 4; ++v) {
        const double r = profile.rows[v].x, h = quarterCircle * r;
        const glm::dvec2 arc[4] = {{r, 0.0}, {r, -h}, {h, -r}, {0.0, -r}}; // (x, z)
        for (size_t u = 0; u < 4; ++u) {
            glm::dvec2 xz = arc[u];
            for (int i = 0; i < quarter; ++i)
                xz = {xz.y, -xz.x};
            patch.points[4 * v + u] = {xz.x, profile.rows[v].y, xz.y};
        }
    }
    return patch;
}

// The half of a tube on the side of -Z (side = -1), or its mirror image on the side of +Z (side = 1), run through the other way
// round so that the normal still points outward.
TeapotPatch halfTube(const Tube& tube, int side, double uShare, double vShare)
{
    TeapotPatch patch{.points = {}, .uShare = uShare, .vShare = vShare};
    for (size_t v = 0; v < 4; ++v) {
        const Section& section = tube[v];
        const glm::dvec3 row[4] = {
            {section.first, 0.0}, {section.first, side * section.halfWidth}, {section.last, side * section.halfWidth}, {section.last, 0.0}};
        for (size_t u = 0; u < 4; ++u)
            patch.points[4 * v + u] = row[side < 0 ? u : 3 - u];
    }
    return patch;
}

} // namespace

TeapotPatches teapotPatches()
{
    TeapotPatches patches{};
    auto next = patches.begin();
    const auto addRevolved = [&](std::span<const Profile> part) {
        for (const Profile& profile : part)
            for (int quarter = 0; quarter < 4; ++quarter)
                *next++ = revolved(profile, quarter);
    };
    const auto addTube = [&](std::span<const Tube> part, double uShare, double vShare) {
        for (const Tube& tube : part)
            for (const int side : {-1, 1})
                *next++ = halfTube(tube, side, uShare, vShare);
    };
    addRevolved(bottom);
    addRevolved(lid);
    addTube(handle, 0.6, 0.8);
    addRevolved(body);
    addTube(spout, 0.8, 1.0);
    return patches;
}

} // namespace mirrorball::preview
