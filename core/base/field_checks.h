#pragma once

#include "error.h"
#include "fields.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// What the readers of files and the checks of settings in memory share.
namespace mirrorball {

struct AnyVisitor {
    template <typename T>
    void operator()(const Field&, T&) const
    {
    }
};

/// Whether T is a settings struct with visitFields.
template <typename T>
concept hasFields = requires(T& value)
{
    T::visitFields(value, AnyVisitor{});
};

inline std::string fieldPath(const std::string& parent, std::string_view name)
{
    return parent.empty() ? std::string(name) : parent + "." + std::string(name);
}

/// A number as a person would write it.
std::string numberText(double value);

/// Text of a file inside an error message: in quotes, on one line, shortened.
std::string inQuotes(std::string_view text);

/// @throws InvalidArgument naming the field unless value is finite and within its range
void checkRange(const std::string& path, const Field& field, double value);

/// Entries that a list may have: the field's range where it states one, at most 1000 otherwise.
size_t mostEntries(const Field& field);

/// @throws InvalidArgument naming the field unless a list may have so many entries
void checkCount(const std::string& path, const Field& field, size_t count);

/// Checks every number of a settings struct against its range, those of structs inside it and of lists of them too. A type that is none
/// of these but has an overload of `checkFields(path, value)` is checked by that.
class RangeChecker {
public:
    explicit RangeChecker(std::string path) : m_path(std::move(path)) {}

    template <typename T>
    void operator()(const Field& field, const T& value) const
    {
        check(fieldPath(m_path, field.name), field, value);
    }

private:
    template <typename T>
    static void check(const std::string& path, const Field& field, const T& value)
    {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
            checkRange(path, field, static_cast<double>(value));
        } else if constexpr (std::is_same_v<T, glm::dvec3>) {
            for (int c = 0; c < 3; ++c)
                checkRange(path, field, value[c]);
        } else if constexpr (hasFields<T>) {
            T::visitFields(value, RangeChecker(path));
        } else if constexpr (requires { checkFields(path, value); }) {
            checkFields(path, value);
        }
    }
    template <typename T>
    static void check(const std::string& path, const Field& field, const std::vector<T>& list)
    {
        checkCount(path, field, list.size());
        for (size_t i = 0; i < list.size(); ++i)
            check(path + "[" + std::to_string(i) + "]", field, list[i]);
    }
    template <typename T>
    static void check(const std::string& path, const Field& field, const std::optional<T>& value)
    {
        if (value)
            check(path, field, *value);
    }

    std::string m_path;
};

} // namespace mirrorball
