#pragma once

#include "../error.h"
#include "../fields.h"

#include <string>
#include <string_view>

/// What the reader of scene files and the check of scenes in memory share.
namespace mirrorball {

struct AnyVisitor {
    template <typename T>
    void operator()(const Field&, T&) const
    {
    }
};

/// Whether T is a settings struct with visitFields.
template <typename T>
concept hasFields = requires(T& value) { T::visitFields(value, AnyVisitor{}); };

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

} // namespace mirrorball
