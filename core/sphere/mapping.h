#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

/// A mapping is one row: all that code beyond its own files asks it for. It stands in the header of that name (latlong, cube_map,
/// sphere_map, angular_map, dual_paraboloid, octahedral), and mapping.cpp puts the rows into a table.
namespace mirrorball {

enum class Parameterization { Latlong, Cube, Sphere, Angular, Paraboloid, Octahedral };

inline constexpr std::array allParameterizations{Parameterization::Latlong, Parameterization::Cube,       Parameterization::Sphere,
                                                 Parameterization::Angular, Parameterization::Paraboloid, Parameterization::Octahedral};

struct MapLayout; // parameterization.h
struct Texel;

/// What the charts of an image are, and with that what lies beyond their edges.
enum class Charts {
    Whole,  ///< the image is one chart, and a step over its edge leads to another texel of it
    Faces,  ///< the faces of a cube, stacked: a step over an edge leads to a neighbor, and at a corner only three texels meet
    Disc,   ///< one inscribed disc, whose rim is the single direction -Z
    Halves, ///< two inscribed discs side by side, the front (z >= 0) on the left; each continues in the other: q in q / |q|^2
};

/// Where a chart lies on the sheet that a map is unfolded to, in squares of N texels.
struct SheetCell {
    int column = 0;
    int row = 0;
};

/// No member has a default: the compiler names the row that leaves one out. The functions are those that parameterization.h declares.
struct Mapping {
    Parameterization kind;
    std::string_view name; ///< the KIND word of the command line; its functions in shaders begin with it (shaderFunction)
    std::string_view axes; ///< for side-cars: where the axes lie
    std::string_view seen; ///< for what is assumed of a file: how the picture shows the world

    Charts charts;
    int columns, rows;  ///< of the image, in squares of N texels
    int chartColumns;   ///< squares of N texels side by side that are one chart
    bool hasBorder;     ///< whether texels may be kept free around the discs
    bool rowsAreAlike;  ///< whether all texels of a row have one solid angle
    bool oddSizesFold;  ///< whether folds, where directions turn a corner, run through texels of a map of odd size
    int quarterTurns;   ///< that N texels span through the front of the map
    int leastQuarter;   ///< N over this is about how many texels a quarter turn spans where it spans the fewest
    double longestSide; ///< a texel's, in radians times N, where it hardly depends on the place; 0 where texels are about square
    int latlongRows;    ///< N times this is the height of a latlong that keeps the map's texels apart

    int sheetColumns, sheetRows;           ///< of the sheet that people look at, in squares of N texels
    std::span<const SheetCell> sheetCells; ///< of the charts, stacked in the image; none where the sheet is the image as it is

    glm::dvec3 (*direction)(const MapLayout& layout, const glm::dvec2& p);
    glm::dvec2 (*coordinate)(const MapLayout& layout, const glm::dvec3& d);
    double (*density)(const MapLayout& layout, const glm::dvec2& p);
    double (*solidAngle)(const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max);
    Texel (*acrossSeam)(const MapLayout& layout, Texel chart, int x, int y);

    constexpr bool hasDiscs() const { return charts == Charts::Disc || charts == Charts::Halves; }
    constexpr int chartCount() const { return columns / chartColumns * rows; }
};

/// The rows in the order of the enum.
extern const std::array<Mapping, allParameterizations.size()> mappings;

inline const Mapping& mapping(Parameterization kind) { return mappings[static_cast<size_t>(kind)]; }

} // namespace mirrorball
