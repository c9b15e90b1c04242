#include "obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

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

bool exists(std::string_view number, long before, long all)
{
    long index = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), index);
    return read.ec == std::errc() && read.ptr == number.data() + number.size() &&
           (index > 0 ? index <= all : index < 0 && index >= -before);
}

/// A face as its corners' words: "3", "3/1", "3//2" or "3/1/2".
struct Face {
    std::vector<std::array<std::string_view, 3>> corners{};
    std::array<bool, 3> areThere{true, true, true}; ///< in every corner, where they are named at all: place, texture coordinate, normal
};

Face faceOf(std::string_view words, const Counts& before, const Counts& all)
{
    Face face;
    for (std::string_view word = nextWord(words); !word.empty() && word.front() != '#'; word = nextWord(words)) {
        if (word == "\\")
            continue;
        std::array<std::string_view, 3>& corner = face.corners.emplace_back();
        for (size_t i = 0; i < 3; ++i) {
            corner[i] = word.substr(0, word.find('/'));
            word.remove_prefix(std::min(corner[i].size() + 1, word.size()));
            if ((i == 0 || !corner[i].empty()) && !exists(corner[i], before[i], all[i]))
                face.areThere[i] = false;
        }
        if (!word.empty())
            face.areThere[0] = false;
    }
    return face;
}

/// The face without the texture coordinates or normals that are not there.
std::string written(const Face& face)
{
    std::string line = "f";
    for (const auto& corner : face.corners) {
        const std::string_view coordinate = face.areThere[1] ? corner[1] : "", normal = face.areThere[2] ? corner[2] : "";
        line += ' ';
        line += corner[0];
        if (!coordinate.empty() || !normal.empty())
            (line += '/') += coordinate;
        if (!normal.empty())
            (line += '/') += normal;
    }
    return line + '\n';
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
        std::string_view words = line;
        const bool isFace = !continues && nextWord(words) == "f";
        const size_t last = line.find_last_not_of(" \t\r\n");
        continues = last != line.npos && line[last] == '\\';
        const Face face = isFace ? faceOf(words, before, all) : Face{};
        if (continues || face.areThere == Face{}.areThere)
            result.text += line;
        else if (face.areThere[0])
            result.text += written(face);
        else
            ++result.dropped;
    }
    return result;
}

} // namespace mirrorball::helper
