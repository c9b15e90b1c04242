#include "field_checks.h"

#include <limits>
#include <sstream>

namespace mirrorball {

std::string numberText(double value)
{
    std::ostringstream text;
    text.precision(9);
    text << value;
    return text.str();
}

std::string inQuotes(std::string_view text)
{
    constexpr size_t longest = 60;
    std::string result = "\"";
    for (const char c : text.substr(0, longest))
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return result + (text.size() > longest ? "...\"" : "\"");
}

void checkRange(const std::string& path, const Field& field, double value)
{
    if (value >= field.low && value <= field.high)
        return;
    std::ostringstream must;
    must.precision(9);
    if (field.high < std::numeric_limits<double>::max())
        must << "from " << field.low << " to " << field.high;
    else
        must << "a finite number";
    if (!field.unit.empty())
        must << ' ' << field.unit;
    throw InvalidArgument(path + ": must be " + must.str() + "; it is " + numberText(value));
}

size_t mostEntries(const Field& field) { return field.high < std::numeric_limits<double>::max() ? static_cast<size_t>(field.high) : 1000; }

void checkCount(const std::string& path, const Field& field, size_t count)
{
    const size_t most = mostEntries(field);
    if (count > most)
        throw InvalidArgument(path + ": must be a list of at most " + std::to_string(most) + "; it has " + std::to_string(count));
    if (static_cast<double>(count) < field.low)
        throw InvalidArgument(path + ": must be a list of at least " + numberText(field.low) + "; it has " + std::to_string(count));
}

} // namespace mirrorball
