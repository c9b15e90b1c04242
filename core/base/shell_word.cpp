#include "shell_word.h"

#include <algorithm>
#include <cctype>

namespace mirrorball {

std::string shellWord(std::string_view word)
{
    const auto safe = [](unsigned char c) {
        return std::isalnum(c) != 0 || std::string_view("@%+=:,./-_").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), safe))
        return std::string(word);
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

} // namespace mirrorball
