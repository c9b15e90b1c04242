#include "lobe_words.h"

#include "core/base/error.h"
#include "core/base/field_json.h"
#include "core/filter/lobe_row.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace mirrorball {

namespace {

/// "phong:EXPONENT, ggx:ALPHA or diffuse": what a word may be, those with a number first.
std::string forms()
{
    std::vector<std::string> all;
    for (const LobeRow& row : lobeRows) {
        if (!row.make)
            continue;
        all.emplace_back(row.word);
        if (row.value)
            all.back() += ':';
        for (const char c : row.parameter)
            all.back() += static_cast<char>(c - 'a' + 'A');
    }
    std::stable_partition(all.begin(), all.end(), [](const std::string& form) { return form.find(':') != std::string::npos; });
    return field_json::listed(std::vector<std::string_view>(all.begin(), all.end()));
}

double number(std::string_view word, std::string_view digits)
{
    double value = 0.0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (status != std::errc{} || end != digits.data() + digits.size())
        throw InvalidArgument("lobe: '" + std::string(word) + "' must be " + forms());
    return value;
}

} // namespace

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

Lobe lobeFromWord(std::string_view word)
{
    const size_t colon = word.find(':');
    const std::string_view kind = word.substr(0, colon);
    const std::string_view digits = colon == std::string_view::npos ? std::string_view{} : word.substr(colon + 1);
    try {
        for (const LobeRow& row : lobeRows)
            if (row.make && kind == row.word && (row.value || word == row.word))
                return row.make(row.value ? number(word, digits) : 0.0);
    } catch (const InvalidArgument& error) { // the range is wrong: say of which word
        const std::string message = error.what();
        throw InvalidArgument(message.starts_with("lobe: ") ? message : "lobe: '" + std::string(word) + "': " + message);
    }
    throw InvalidArgument("lobe: '" + std::string(word) + "' must be " + forms());
}

std::vector<Lobe> lobesFromWords(std::string_view list)
{
    std::vector<Lobe> lobes;
    for (const std::string_view word : split(list, ','))
        lobes.push_back(lobeFromWord(word));
    return lobes;
}

} // namespace mirrorball
