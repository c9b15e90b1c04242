#include "obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace mirrorball::helper {
namespace {

/// Counts of v, vt and vn.
using Counts = std::array<long, 3>;

std::string_view nextLine(std::string_view& text)
{
    const size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end == text.npos ? text.size() : end + 1);
    text.remove_prefix(line.size());
    return line;
}

std::string_view nextWord(std::string_view& line)
{
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r\n"), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(" \t\r\n"));
    line.remove_prefix(word.size());
    return word;
}

void count(std::string_view line, Counts& counts)
{
    const std::string_view word = nextWord(line);
    counts[0] += word == "v";
    counts[1] += word == "vt";
    counts[2] += word == "vn";
}

/// "3", "3/1", "3//2" or "3/1/2" of what there is.
bool isCorner(std::string_view word, const Counts& before, const Counts& all)
{
    for (size_t i = 0; i < 3; ++i) {
        const std::string_view number = word.substr(0, word.find('/'));
        long index = 0;
        const auto read = std::from_chars(number.data(), number.data() + number.size(), index);
        const bool isThere = read.ec == std::errc() && read.ptr == number.data() + number.size() &&
                             (index > 0 ? index <= all[i] : index < 0 && -index <= before[i]);
        if (!isThere && (i != 1 || !number.empty())) // only the middle one may be left out
            return false;
        if (number.size() == word.size())
            return true;
        word.remove_prefix(number.size() + 1);
        if (i == 0 && word.empty()) // "3/", which some write
            return true;
    }
    return false;
}

bool isBadFace(std::string_view line, const Counts& before, const Counts& all)
{
    if (nextWord(line) != "f")
        return false;
    for (std::string_view word = nextWord(line); !word.empty() && word.front() != '#'; word = nextWord(line))
        if (word != "\\" && !isCorner(word, before, all))
            return true;
    return false;
}

} // namespace

ObjText withoutBadFaces(const std::string& text)
{
    Counts all{}, before{};
    for (std::string_view rest = text; !rest.empty();)
        count(nextLine(rest), all);
    ObjText result;
    result.text.reserve(text.size());
    bool continues = false; // a line whose last character is a backslash goes on
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = nextLine(rest);
        count(line, before);
        const bool isBad = !continues && isBadFace(line, before, all);
        const size_t last = line.find_last_not_of(" \t\r\n");
        continues = last != line.npos && line[last] == '\\';
        if (isBad && !continues)
            ++result.dropped;
        else
            result.text += line;
    }
    return result;
}

} // namespace mirrorball::helper
