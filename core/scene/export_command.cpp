#include "export_command.h"

#include "core/base/shell_word.h"

namespace mirrorball {

namespace {

/// A path that starts with a dash would be taken for an option.
std::string pathWord(const std::filesystem::path& path)
{
    const std::string text = path.string();
    return shellWord(text.starts_with('-') ? "./" + text : text);
}

} // namespace

std::string exportCommand(const std::filesystem::path& sceneFile, const std::filesystem::path& folder, const std::vector<std::string>& only)
{
    std::string command = "mirrorball export " + pathWord(sceneFile) + " -o " + pathWord(folder);
    for (const std::string& name : only)
        command += " --only=" + shellWord(name);
    return command;
}

std::string engineExportCommand(const std::filesystem::path& sceneFile, const std::filesystem::path& folder, std::string_view engine,
                                int size)
{
    return "mirrorball export " + pathWord(sceneFile) + " --for " + std::string(engine) +
           (size > 0 ? " --size " + std::to_string(size) : "") + " -o " + pathWord(folder);
}

} // namespace mirrorball
