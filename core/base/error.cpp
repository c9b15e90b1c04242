#include "error.h"

namespace mirrorball {

std::string shownPath(const std::string& path)
{
    constexpr size_t longest = 300, head = 100, tail = 180;
    const auto inside = [&](size_t at) { return (static_cast<unsigned char>(path[at]) & 0xc0) == 0x80; }; // of a character of several bytes
    std::string shown = path;
    if (path.size() > longest) {
        size_t first = head, last = path.size() - tail;
        for (int i = 0; i < 3 && inside(first); ++i)
            --first;
        for (int i = 0; i < 3 && inside(last); ++i)
            ++last;
        shown = path.substr(0, first) + "..." + path.substr(last);
    }
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    return shown;
}

} // namespace mirrorball
