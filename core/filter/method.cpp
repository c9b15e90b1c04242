#include "method.h"

#include "method_row.h"

#include <algorithm>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 2> mipFilteringWords{"across-seams", "per-face"};

} // namespace

std::string_view name(Method method) { return rowOf(method).name; }

std::optional<Method> methodFromName(std::string_view word)
{
    for (const Method method : allMethods)
        if (name(method) == word)
            return method;
    return std::nullopt;
}

std::string_view helpOf(Method method) { return rowOf(method).help; }

std::span<const std::string_view> knobsOf(Method method) { return rowOf(method).knobs; }

bool hasKnob(Method method, std::string_view knob)
{
    const auto knobs = knobsOf(method);
    return std::find(knobs.begin(), knobs.end(), knob) != knobs.end();
}

std::string ownersOf(std::string_view knob)
{
    std::string owners;
    for (const Method method : allMethods)
        if (hasKnob(method, knob))
            owners += (owners.empty() ? "" : " or ") + std::string(name(method));
    return owners;
}

bool followsTolerance(Method method) { return rowOf(method).followsTolerance; }

std::span<const std::string_view> words(MipFiltering) { return mipFilteringWords; }

} // namespace mirrorball
