#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// What files, command line and forms know about one member of a settings struct.
///
/// Such a struct has a static template `visitFields(self, visit)` that calls `visit(Field, member)` for each member, so that an option
/// is spelled once. Enums have their words in an overload of `words(E)`, in the order of their values; wordOf() and fromWord() read it.
namespace mirrorball {

struct Field {
    std::string_view name;                            ///< the key in a file
    std::string_view help;                            ///< one line, no full stop
    double low = -std::numeric_limits<double>::max(); ///< numbers: the range, both ends included; lists: how many entries
    double high = std::numeric_limits<double>::max();
    std::string_view unit{};
};

template <typename Enum>
std::string_view wordOf(Enum value)
{
    return words(value)[static_cast<size_t>(value)];
}

/// Nothing for a word that is none of them.
template <typename Enum>
std::optional<Enum> fromWord(std::string_view word)
{
    for (size_t i = 0; i < words(Enum{}).size(); ++i)
        if (words(Enum{})[i] == word)
            return static_cast<Enum>(i);
    return std::nullopt;
}

/// Keys of a file that this version does not know, with their JSON text: kept, so that a newer file survives an older program. A settings
/// struct that is read from files has a member `unknown` of this type.
using UnknownKeys = std::map<std::string, std::string>;

} // namespace mirrorball
