#include "reading.h"

#include "arrays.h"
#include "json_text.h"

#include "core/base/error.h"
#include "core/base/field_json.h"
#include "core/scene/scene.h" // the words of Parameterization

#include <algorithm>
#include <type_traits>
#include <vector>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

std::string keywordOf(const Field& field) { return field.name == "parameterization" ? "kind" : std::string(field.name); }

template <typename Words>
std::string listOf(const Words& words)
{
    std::string list;
    for (const std::string_view word : words)
        list += (list.empty() ? "" : ", ") + std::string(word);
    return list;
}

std::string shown(const py::handle& value) { return py::str(value).cast<std::string>(); }

/// Puts a keyword's value into its field.
struct Taker {
    const py::kwargs& keywords;
    std::vector<std::string> known{};

    template <typename Value>
    void operator()(const Field& field, Value& value)
    {
        const std::string keyword = keywordOf(field);
        known.push_back(keyword);
        if (!keywords.contains(keyword.c_str()))
            return;
        const py::object given = keywords[keyword.c_str()];
        if (given.is_none())
            return;
        if constexpr (std::is_same_v<Value, std::optional<Parameterization>>) {
            value = toKind(shown(given), keyword);
        } else if constexpr (std::is_same_v<Value, std::string>) {
            value = shown(given); // a part may be a number
        } else if constexpr (std::is_same_v<Value, glm::dvec3>) {
            std::string text;
            if (py::isinstance<py::str>(given) || !py::isinstance<py::iterable>(given))
                text = shown(given);
            else
                for (const py::handle& number : given)
                    text += (text.empty() ? "" : ",") + shown(number);
            value = parseRotation(keyword, text);
        } else {
            const field_json::Json json = field_json::parse(toJsonText(given), keyword);
            field_json::Reader::read(keyword, field, json, value);
        }
    }
};

} // namespace

ProbeReading toReading(const std::string& function, const py::kwargs& keywords)
{
    ProbeReading reading;
    Taker taker{keywords};
    ProbeReading::visitFields(reading, taker);
    for (const auto& [name, value] : keywords)
        if (std::find(taker.known.begin(), taker.known.end(), shown(name)) == taker.known.end())
            throw py::type_error(function + "() got an unexpected keyword argument '" + shown(name) + "'; how a file is read is told by " +
                                 listOf(taker.known));
    return reading;
}

std::string withReadingHelp(const std::string& text)
{
    std::string help = text + "\n\nHow a file is to be read, by keywords; what is left out is taken from the file itself:\n";
    const ProbeReading initial;
    ProbeReading::visitFields(initial, [&](const Field& field, const auto& value) {
        help += "  " + keywordOf(field) + ": ";
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, std::optional<Parameterization>>)
            help += "how the file shows the sphere: " + listOf(words(Parameterization{}));
        else
            help += std::string(field.help);
        if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>)
            help += ": " + listOf(words(value));
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, glm::dvec3>)
            help += "; (y, x, z), or a quaternion (w, x, y, z)";
        if (!field.unit.empty())
            help += " (" + std::string(field.unit) + ")";
        help += "\n";
    });
    return help;
}

} // namespace mirrorball::python
