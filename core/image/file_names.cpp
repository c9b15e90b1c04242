#include "file_names.h"

#include "core/base/error.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace mirrorball {
namespace {

enum class Mark { Text, Percent, Face, Level, Frame };

/// A piece of a name, from the left.
struct Piece {
    Mark mark = Mark::Text;
    size_t length = 1; ///< in the pattern
    size_t digits = 0; ///< at least, of a number
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

Piece pieceAt(std::string_view name, size_t at)
{
    const std::string_view rest = name.substr(at);
    if (rest.front() == '#') {
        const size_t length = std::min(rest.find_first_not_of('#'), rest.size());
        return {Mark::Frame, length, length};
    }
    if (rest.starts_with("%%"))
        return {Mark::Percent, 2};
    if (rest.starts_with("%s"))
        return {Mark::Face, 2};
    if (rest.starts_with("%d"))
        return {Mark::Level, 2};
    if (rest.size() > 3 && rest.starts_with("%0") && isDigit(rest[2]) && rest[3] == 'd')
        return {Mark::Level, 4, static_cast<size_t>(rest[2] - '0')};
    return {};
}

bool has(const std::filesystem::path& pattern, Mark mark)
{
    const std::string name = pattern.filename().string();
    for (size_t at = 0; at < name.size();) {
        const Piece piece = pieceAt(name, at);
        if (piece.mark == mark)
            return true;
        at += piece.length;
    }
    return false;
}

std::string numberWith(int number, size_t digits)
{
    std::string text = std::to_string(number);
    return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

} // namespace

std::filesystem::path fileNamed(const std::filesystem::path& pattern, const NameWords& words)
{
    const std::string name = pattern.filename().string();
    std::string result;
    for (size_t at = 0; at < name.size();) {
        const Piece piece = pieceAt(name, at);
        if (piece.mark == Mark::Percent)
            result += '%';
        else if (piece.mark == Mark::Face && !words.face.empty())
            result += words.face;
        else if (piece.mark == Mark::Level && words.level)
            result += numberWith(*words.level, piece.digits);
        else if (piece.mark == Mark::Frame && words.frame)
            result += numberWith(*words.frame, piece.digits);
        else
            result += name.substr(at, piece.length);
        at += piece.length;
    }
    return pattern.parent_path() / result;
}

bool namesFaces(const std::filesystem::path& pattern) { return has(pattern, Mark::Face); }
bool namesLevels(const std::filesystem::path& pattern) { return has(pattern, Mark::Level); }
bool namesFrames(const std::filesystem::path& pattern) { return has(pattern, Mark::Frame); }

void refuseDoubtfulLevel(const std::filesystem::path& pattern)
{
    const std::string name = pattern.filename().string();
    for (size_t at = 0; at < name.size();) {
        const Piece piece = pieceAt(name, at);
        const size_t end = at + piece.length;
        if (piece.mark == Mark::Level && end < name.size() && std::isalpha(static_cast<unsigned char>(name[end])))
            throw InvalidArgument("output: '" + name.substr(at, piece.length) + "' in '" + name +
                                  "' stands for the number of a level, and there is only one; write %% for a percent sign");
        at = end;
    }
}

} // namespace mirrorball
