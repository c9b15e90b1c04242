#include "method_row.h"

namespace mirrorball {

namespace {

/// A switch, so that the compiler names a method that has no row.
constexpr const MethodRow* find(Method method)
{
    switch (method) {
    case Method::Auto:
        return &autoMethod;
    case Method::Reference:
        return &referenceMethod;
    case Method::Spectral:
        return &spectralMethod;
    case Method::Direct:
        return &directMethod;
    case Method::Hierarchical:
        return &hierarchicalMethod;
    case Method::Importance:
        return &importanceMethod;
    case Method::Paraboloid:
        return &paraboloidMethod;
    case Method::Mip:
        return &mipMethod;
    case Method::Sh9:
        return &sh9Method;
    }
    return nullptr;
}

consteval bool areAll()
{
    for (size_t i = 0; i < allMethods.size(); ++i)
        if (static_cast<size_t>(allMethods[i]) != i)
            return false;
    return find(static_cast<Method>(allMethods.size())) == nullptr;
}
static_assert(areAll(), "allMethods has every method, in the order of the enum");

} // namespace

const MethodRow& rowOf(Method method) { return *find(method); }

} // namespace mirrorball
