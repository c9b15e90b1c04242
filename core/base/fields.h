#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>

/// What files, command line and forms know about one member of a settings struct.
///
/// Such a struct has a static template `visitFields(self, visit)` that calls `visit(Field, member)` for each member, so that an option
/// is spelled once. Enums have their words in an overload of `words(E)`, in the order of their values.
namespace mirrorball {

struct Field {
    std::string_view name;                            ///< the key in a file
    std::string_view help;                            ///< one line, no full stop
    double low = -std::numeric_limits<double>::max(); ///< numbers: the range, both ends included; lists: how many entries
    double high = std::numeric_limits<double>::max();
    std::string_view unit{};
};

/// Keys of a file that this version does not know, with their JSON text: kept, so that a newer file survives an older program. A settings
/// struct that is read from files has a member `unknown` of this type.
using UnknownKeys = std::map<std::string, std::string>;

} // namespace mirrorball
