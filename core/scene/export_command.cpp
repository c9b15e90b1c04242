#include "export_command.h"

#include <algorithm>
#include <cctype>

namespace mirrorball {

namespace {

/// A path that starts with a dash would be taken for an option.
std::string pathWord(const std::filesystem::path& path)
{
    const std::string text = path.string();
    return shellQuoted(text.starts_with('-') ? "./" + text : text);
}

} // namespace

std::string shellQuoted(std::string_view word)
{
    const auto safe = [](unsigned char c) { return std::isalnum(c) != 0 || std::string_view("@%+=:,./-_").find(static_cast<char>(c)) != std::string_view::npos; };
    if (!word.empty() && std::all_of(word.begin(), word.end(), safe))
        return std::string(word);
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string exportCommand(const std::filesystem::path& sceneFile, const std::filesystem::path& folder, const std::vector<std::string>& only)
{
    std::string command = "mirrorball export " + pathWord(sceneFile) + " -o " + pathWord(folder);
    for (const std::string& name : only)
        command += " --only=" + shellQuoted(name);
    return command;
}

} // namespace mirrorball
