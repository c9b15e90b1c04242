#include "reading_options.h"

#include "command.h"

#include "core/base/error.h"
#include "core/base/field_json.h"

#include <algorithm>
#include <cstdio>
#include <locale>
#include <sstream>
#include <type_traits>

namespace mirrorball::cli {

namespace {

std::string readingOption(const Field& field) { return field.name == "parameterization" ? "--from" : optionOf(field); }

/// Puts what was typed into a field.
struct Parser {
    const std::map<std::string, std::string>& typed;

    template <typename Value>
    void operator()(const Field& field, Value& value) const
    {
        const std::string option = readingOption(field);
        const auto given = typed.find(option);
        if (given == typed.end() || given->second.empty())
            return;
        const std::string& text = given->second;
        if constexpr (std::is_same_v<Value, std::optional<Parameterization>>)
            value = parseKind(option, text);
        else if constexpr (std::is_same_v<Value, std::string>)
            value = text;
        else if constexpr (std::is_same_v<Value, glm::dvec3>)
            value = parseRotation(option, text);
        else if constexpr (std::is_enum_v<Value>)
            value = word(option, text, value);
        else
            value = number(option, text, field);
    }

    template <typename Enum>
    static Enum word(const std::string& option, const std::string& text, Enum)
    {
        if (const std::optional<Enum> known = fromWord<Enum>(text))
            return *known;
        throw InvalidArgument(option + ": '" + text + "' is none; choose one of " + field_json::listed(words(Enum{})));
    }

    static double number(const std::string& option, const std::string& text, const Field& field)
    {
        std::istringstream stream(text);
        stream.imbue(std::locale::classic());
        double found = 0.0;
        if (stream >> found && stream.peek() == std::istringstream::traits_type::eof() && found >= field.low && found <= field.high)
            return found;
        std::ostringstream message;
        message << option << ": must be a number from " << field.low << " to " << field.high << "; it is '" << text << "'";
        throw InvalidArgument(message.str());
    }
};

} // namespace

std::string optionOf(const Field& field)
{
    std::string option = "--" + std::string(field.name);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

void ReadingOptions::addTo(CLI::App& command, std::string_view leftOut)
{
    ProbeReading initial;
    ProbeReading::visitFields(initial, [&](const Field& field, auto& value) {
        if (readingOption(field) == leftOut)
            return;
        std::string help(field.help);
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, std::optional<Parameterization>>)
            help = "parameterization of the input, where it is not to be found out (KIND)";
        else if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>)
            for (size_t i = 0; i < words(value).size(); ++i)
                help += (i == 0 ? " (" : " | ") + std::string(words(value)[i]) + (i + 1 == words(value).size() ? ")" : "");
        else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, glm::dvec3>)
            help += " (Y,X,Z in degrees, or a quaternion w,x,y,z)";
        command.add_option(readingOption(field), m_typed[readingOption(field)], help);
    });
}

ProbeReading ReadingOptions::parse(const ProbeReading& otherwise) const
{
    ProbeReading reading = otherwise;
    ProbeReading::visitFields(reading, Parser{m_typed});
    return reading;
}

void printNotes(const std::string& probe, const std::vector<std::string>& notes)
{
    for (const std::string& note : notes)
        std::fprintf(stderr, "mirrorball: note: %s: %s\n", probe.c_str(), note.c_str());
}

} // namespace mirrorball::cli
