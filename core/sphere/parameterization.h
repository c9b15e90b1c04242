#pragma once

#include "direction.h"
#include "mapping.h"

#include "core/base/job.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How directions become texels. Each mapping has a file of its own (latlong, cube_map, sphere_map, angular_map, dual_paraboloid,
/// octahedral) that answers the same questions; this header asks the row (mapping.h) of the one that is named at run time.
namespace mirrorball {

/// "latlong", "cube", "sphere", "angular", "paraboloid", "octahedral": the KIND words of the command line.
std::string_view name(Parameterization p);
/// The inverse of name(). Empty for any other word.
std::optional<Parameterization> parameterizationFromName(std::string_view word);

/// A parameterization at a size: everything that fixes which direction a texel stands for.
///
/// Every disc has +Y at the top. +X is on the right in the sphere map and in both paraboloid halves, whose formulas have it there; on
/// the left in the angular map, which is a picture from inside like the latlong (angular_map.h).
///
/// Images: latlong 2N x N; cube N x 6N, faces +X -X +Y -Y +Z -Z from the top, each with OpenGL's face axes; sphere and angular
/// N x N; paraboloid 2N x N, the front half (z >= 0) on the left; octahedral N x N.
/// `border` (paraboloid only) is the ring of texels kept free outside each inscribed disc, so the disc's radius is N/2 - border.
struct MapLayout {
    Parameterization kind = Parameterization::Latlong;
    int size = 0;   ///< N, at least 1
    int border = 0; ///< texels, in [0, N/2); 0 for every kind but paraboloid

    int width() const { return mapping(kind).columns * size; }
    int height() const { return mapping(kind).rows * size; }
    int chartWidth() const { return mapping(kind).chartColumns * size; } ///< texels; a chart is `size` high
    bool operator==(const MapLayout&) const = default;
};

/// @throws InvalidArgument naming the field when the size or the border is out of range
void validate(const MapLayout& layout);

/// Position of one texel in the image of a layout.
struct Texel {
    int x = 0;
    int y = 0;
    bool operator==(const Texel&) const = default;
};

/// Unit direction of the continuous image position p, in texels: the center of texel (x, y) is (x + 1/2, y + 1/2).
/// Defined on the whole image: outside a disc the mapping is continued (paraboloid: the same formula; angular and sphere map: on
/// through the rim, back up the far side), so that color bleeds past the edge and a lookup there never reads garbage.
glm::dvec3 direction(const MapLayout& layout, const glm::dvec2& p);
inline glm::dvec3 texelDirection(const MapLayout& layout, int x, int y) { return direction(layout, {x + 0.5, y + 0.5}); }

/// Continuous image position of a unit direction; the inverse of direction() on the valid part of the image.
glm::dvec2 coordinate(const MapLayout& layout, const glm::dvec3& d);

/// Whether any part of the texel lies on the map proper (a disc's texels beyond its edge do not).
bool isInside(const MapLayout& layout, int x, int y);

/// Solid angle of the part of the texel that lies on the map, in steradians; 0 outside. Closed form (clipped at a disc's edge).
/// The sum over a map is 4 pi to 1e-12 relative, for the discs too.
double texelSolidAngle(const MapLayout& layout, int x, int y);

/// Solid angle of a rectangle of the image, in texels, that lies within one chart (face, half or whole map); its part outside a disc
/// does not count. What texelSolidAngle() is for any rectangle.
double solidAngle(const MapLayout& layout, const glm::dvec2& min, const glm::dvec2& max);

/// d omega / dA at an image position, in steradians per square texel; 0 outside a disc. Its root is the angle that a texel subtends there.
double density(const MapLayout& layout, const glm::dvec2& p);

/// The solid angles of all texels, computed once: charts that are alike (cube faces, latlong columns, paraboloid halves) share entries.
class SolidAngles {
public:
    explicit SolidAngles(const MapLayout& layout, const JobControl& job = {});
    double at(int x, int y) const
    {
        return m_values[static_cast<size_t>(y % m_rows) * static_cast<size_t>(m_columns) + static_cast<size_t>(x % m_columns)];
    }

private:
    int m_columns = 1;
    int m_rows = 1;
    std::vector<double> m_values{};
};

/// The texel that stands at (x, y) when that address lies over an edge: across a seam for latlong, cube, octahedral and paraboloid
/// halves; back inside for the discs. `chart` is the texel the step started from: it says which face or half (x, y) extends.
/// An address inside the map is returned as it is; in a disc, a texel is inside for this purpose when its center is (one that only
/// touches the disc may be half empty). Works for steps up to the width of a chart. Beyond a cube's corner, where no texel is, it
/// gives an existing one as far from the corner.
Texel acrossSeam(const MapLayout& layout, Texel chart, int x, int y);

} // namespace mirrorball
