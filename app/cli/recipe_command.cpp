#include "command.h"

#include "core/base/error.h"
#include "core/base/shell_word.h"
#include "core/batch/recipe.h"

#include <cstdio>
#include <memory>

namespace mirrorball::cli {
namespace {

void run(const std::string& file)
{
    const FoundRecipe found = findRecipe(file);
    std::string line = found.folder == std::filesystem::current_path() ? "" : "cd " + shellWord(found.folder.string()) + " && ";
    line += "mirrorball";
    for (const std::string& word : found.recipe.command)
        line += " " + shellWord(word);
    std::printf("%s\n", line.c_str());
    if (const std::string why = RecipeChecker(MIRRORBALL_VERSION).whyStale(found); !why.empty())
        std::fprintf(stderr, "mirrorball: note: %s: does not verify, because %s\n", shownPath(file).c_str(), why.c_str());
}

} // namespace

void addRecipeCommand(CLI::App& program)
{
    const auto file = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("recipe", "Print the command that makes an output again");
    command->add_option("FILE", *file, "output of `mirrorball batch`, or of a command with --recipe")->required();
    command->callback([file] { run(*file); });
}

} // namespace mirrorball::cli
