#include "mapping.h"

#include "angular_map.h"
#include "cube_map.h"
#include "dual_paraboloid.h"
#include "latlong.h"
#include "octahedral.h"
#include "sphere_map.h"

#include <utility>

namespace mirrorball {

namespace {

/// A switch, so that the compiler names a kind that has no row.
constexpr const Mapping* rowOf(Parameterization kind)
{
    switch (kind) {
    case Parameterization::Latlong:
        return &latlong::mapping;
    case Parameterization::Cube:
        return &cube_map::mapping;
    case Parameterization::Sphere:
        return &sphere_map::mapping;
    case Parameterization::Angular:
        return &angular_map::mapping;
    case Parameterization::Paraboloid:
        return &dual_paraboloid::mapping;
    case Parameterization::Octahedral:
        return &octahedral::mapping;
    }
    return nullptr;
}

template <size_t... index>
constexpr std::array<Mapping, sizeof...(index)> table(std::index_sequence<index...>)
{
    return {*rowOf(static_cast<Parameterization>(index))...};
}

constexpr size_t count = allParameterizations.size();

constexpr bool isInOrder(const std::array<Mapping, count>& rows)
{
    for (size_t i = 0; i < count; ++i)
        if (rows[i].kind != allParameterizations[i] || static_cast<size_t>(rows[i].kind) != i)
            return false;
    return true;
}

} // namespace

constexpr std::array<Mapping, count> mappings = table(std::make_index_sequence<count>());

static_assert(isInOrder(mappings), "each row carries its kind, and the rows stand in the order of the enum");
static_assert(rowOf(static_cast<Parameterization>(count)) == nullptr, "allParameterizations leaves a kind out");

} // namespace mirrorball
