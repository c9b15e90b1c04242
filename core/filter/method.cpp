#include "method.h"

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, allMethods.size()> methodNames{"auto",       "reference",  "spectral", "direct", "hierarchical",
                                                                      "importance", "paraboloid", "mip",      "sh9"};
constexpr std::array<std::string_view, 2> mipFilteringWords{"across-seams", "per-face"};

} // namespace

std::string_view name(Method method) { return methodNames[static_cast<size_t>(method)]; }

std::optional<Method> methodFromName(std::string_view word)
{
    for (const Method method : allMethods)
        if (name(method) == word)
            return method;
    return std::nullopt;
}

std::span<const std::string_view> words(MipFiltering) { return mipFilteringWords; }

} // namespace mirrorball
