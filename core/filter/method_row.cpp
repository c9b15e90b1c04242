#include "method_row.h"

#include <array>

namespace mirrorball {

namespace {

struct Entry {
    Method method;
    const MethodRow& row;
};

constexpr std::array rows{
    Entry{Method::Auto, autoMethod},
    Entry{Method::Reference, referenceMethod},
    Entry{Method::Spectral, spectralMethod},
    Entry{Method::Direct, directMethod},
    Entry{Method::Hierarchical, hierarchicalMethod},
    Entry{Method::Importance, importanceMethod},
    Entry{Method::Paraboloid, paraboloidMethod},
    Entry{Method::Mip, mipMethod},
    Entry{Method::Sh9, sh9Method},
};

consteval bool areInOrder()
{
    if (rows.size() != allMethods.size())
        return false;
    for (size_t i = 0; i < rows.size(); ++i)
        if (rows[i].method != allMethods[i] || static_cast<size_t>(rows[i].method) != i)
            return false;
    return true;
}
static_assert(areInOrder(), "every method has its row, in the order of Method and of allMethods");

} // namespace

const MethodRow& rowOf(Method method) { return rows[static_cast<size_t>(method)].row; }

} // namespace mirrorball
