#pragma once

#include "core/image/environment_map.h"

#include <glm/glm.hpp>

#include <array>
#include <string>
#include <vector>

/// Which way the pictures of a stored map show an environment that is known.
namespace mirrorball {

/// A picture of N x N texels turned or mirrored. Bit 2: first mirrored left to right; bits 0 and 1: then quarter turns clockwise.
using FaceTurn = int;
inline constexpr FaceTurn allFaceTurns = 8;
inline constexpr FaceTurn rowsBottomUp = 6;    ///< mirrored top to bottom
inline constexpr FaceTurn columnsMirrored = 4; ///< mirrored left to right

/// Where texel (x, y) of the turned picture comes from.
struct TurnedTexel {
    int x = 0, y = 0;
};
TurnedTexel turnedTexel(FaceTurn turn, int n, int x, int y);

/// The face of the environment that a stored face shows, and how.
struct FacePlace {
    int face = 0;
    FaceTurn turn = 0;
    bool operator==(const FacePlace&) const = default;
};
using FacePlaces = std::array<FacePlace, 6>;

/// A way of storing a whole cube: texel (f, s, t) holds L(axes G(f, turned (s, t))), G the point of the face (cube_map.h).
struct CubeStorage {
    glm::dmat3 axes{1.0};
    FaceTurn turn = 0; ///< of every face alike
    FacePlaces places{};
};
/// The 48 signed permutations of the axes times the eight turns, the plainest first.
const std::vector<CubeStorage>& allCubeStorages();

/// What was found.
struct Orientation {
    CubeStorage storage{};         ///< the whole cube's way that is nearest
    FacePlaces places{};           ///< what each face shows; that of `storage` unless single faces differ
    std::vector<int> strayFaces{}; ///< stored faces that do not follow `storage`
    double yaw = 0.0;              ///< radians, in (-pi, pi]: the environment is turned by it before it is mirrored and stored
    double restYaw = 0.0;          ///< the part of it that moving texels to `places` does not undo
    double alpha = 0.0;            ///< about the width of the ggx lobe that the map shows the environment through
    double match = 0.0;            ///< 1: the pictures are those of the environment; 0: unrelated
    double nextMatch = 0.0;        ///< of the best storage that shows something else
    /// Whether the next best differs clearly more from the environment.
    bool certain() const { return match > 0.5 && 1.0 - nextMatch > 1.5 * (1.0 - match) + 0.005; }
    bool mirrored() const { return glm::determinant(storage.axes) < 0.0; }
};

/// Finds the orientation of a map that shows `probe`, filtered by any lobe, scaled, encoded or clipped: logarithms of luminance are
/// compared, over faces of at most 16 texels, for all 48 x 8 ways of storing a cube, for every exchange and turn of single faces, and for
/// every yaw. A map that is no cube is compared as one; its faces cannot stray.
/// @param stored  level 0 as stored; @param probe  a latlong
Orientation findOrientation(const EnvironmentMap& stored, const EnvironmentMap& probe, const JobControl& job = {});

/// The stored pictures moved to where our convention has them, but for the yaw. Texels are moved, never mixed.
Image inOurConvention(const Image& stored, const FacePlaces& places);

/// "+X", ..., "-Z"
std::string faceName(int face);
/// "turned 90 degrees clockwise", "mirrored left to right", ...; empty for 0
std::string describeTurn(FaceTurn turn);
/// One clause: "not mirrored", "mirrored in X", "mirrored in X, rows bottom up", "turned by 90 degrees about +Y", ...
std::string describe(const Orientation& orientation);

} // namespace mirrorball
