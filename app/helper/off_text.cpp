#include "off_text.h"

#include "core/base/error.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <string_view>
#include <vector>

namespace mirrorball::helper {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";
constexpr std::size_t mostCorners = 9; ///< of a face that assimp reads

std::string_view nextWord(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

/// The next line that holds anything, without its comment; empty at the end.
std::string_view nextLine(std::string_view& text)
{
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find_first_of("\r\n"));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(blanks) != line.npos)
            return line;
    }
    return {};
}

/// The same word by word, for what comes before the lists.
std::string_view nextHeaderWord(std::string_view& text)
{
    for (;;) {
        const std::string_view word = nextWord(text);
        if (word.empty() || word.front() != '#')
            return word;
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    }
}

bool isCount(std::string_view word, std::uint64_t& number)
{
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    return read.ec == std::errc() && read.ptr == word.data() + word.size();
}

struct Header {
    std::string_view kind{};       ///< "OFF", "STCNOFF", ...; empty where a file begins with its counts
    std::string_view dimensions{}; ///< of an nOFF file
    std::uint64_t vertices = 0, faces = 0;
};

/// The number of edges, which nobody needs: the rest of the line, or a line of one word; it may be missing.
void skipEdges(std::string_view& text)
{
    std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(line.size());
    if (!nextHeaderWord(line).empty())
        return;
    std::string_view after = text, next = nextLine(after);
    nextWord(next);
    if (nextWord(next).empty())
        text = after;
}

/// What stands before the lists.
bool readHeader(std::string_view& text, Header& header)
{
    std::string_view word = nextHeaderWord(text);
    if (word.ends_with("OFF")) {
        header.kind = word;
        word = nextHeaderWord(text);
        if (word == "BINARY")
            throw InvalidArgument("is a binary .off file, which is not read; export it as text, or as .ply");
        if (header.kind.find('n') != word.npos) {
            header.dimensions = word;
            word = nextHeaderWord(text);
        }
    }
    const bool counted = isCount(word, header.vertices) && isCount(nextHeaderWord(text), header.faces);
    skipEdges(text);
    return counted;
}

/// The lists of faces, as they are written anew.
struct FaceLines {
    std::string text{};
    std::uint64_t lines = 0;
    std::vector<SplitFace> split{};
};

/// Appends a face as one line or several. @return false for one that is not whole, or names a vertex that is not there
bool appendFace(std::string_view line, std::uint64_t vertices, FaceLines& faces)
{
    std::uint64_t count = 0;
    if (!isCount(nextWord(line), count) || count == 0 || count > line.size())
        return false;
    std::vector<std::uint64_t> corners;
    for (std::uint64_t i = 0; i < count; ++i)
        if (!isCount(nextWord(line), corners.emplace_back()) || corners.back() >= vertices)
            return false;
    const std::uint64_t first = faces.lines;
    for (std::span<const std::uint64_t> rest(corners); !rest.empty(); ++faces.lines) {
        const std::span<const std::uint64_t> piece = rest.first(std::min(rest.size(), mostCorners));
        faces.text += std::to_string(piece.size());
        for (const std::uint64_t corner : piece)
            (faces.text += ' ') += std::to_string(corner);
        faces.text += '\n';
        rest = rest.subspan(piece.size());
    }
    if (faces.lines > first + 1)
        faces.split.push_back({first, faces.lines - first});
    return true;
}

} // namespace

OffText cleanedOff(const std::string& text)
{
    OffText result;
    Header header;
    std::string_view rest = text;
    if (!readHeader(rest, header)) {
        result.text = text; // assimp says what is wrong with it
        return result;
    }
    std::string vertexLines;
    FaceLines written;
    std::uint64_t vertices = 0, faces = 0;
    for (std::string_view line; vertices < header.vertices && !(line = nextLine(rest)).empty(); ++vertices)
        (vertexLines += line) += '\n';
    for (std::string_view line; faces < header.faces && !(line = nextLine(rest)).empty(); ++faces)
        if (!appendFace(line, vertices, written))
            ++result.dropped;
    if (vertices < header.vertices || faces < header.faces)
        throw InvalidArgument("the mesh is cut short: it claims " + std::to_string(header.vertices) + " vertices and " +
                              std::to_string(header.faces) + " faces, and has " + std::to_string(vertices) + " and " +
                              std::to_string(faces) + "; copy or export it again");
    if (!header.kind.empty())
        (result.text += header.kind) += '\n';
    if (!header.dimensions.empty())
        (result.text += header.dimensions) += '\n';
    result.text += std::to_string(vertices) + ' ' + std::to_string(written.lines) + " 0\n" + vertexLines + written.text;
    result.split = std::move(written.split);
    return result;
}

} // namespace mirrorball::helper
