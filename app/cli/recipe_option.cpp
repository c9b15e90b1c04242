#include "recipe_option.h"

#include "command.h"

#include "core/base/error.h"
#include "core/batch/recipe.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace mirrorball::cli {
namespace {

constexpr std::array<std::string_view, 5> withoutEffect{"--threads", "--progress", "--recipe", "--explain", "--help"};

/// A value that begins with a dash would be taken for an option.
void addOption(std::vector<std::string>& words, const std::string& name, const std::string& value)
{
    if (value.starts_with('-') || value.empty()) {
        words.push_back(name + "=" + value);
    } else {
        words.push_back(name);
        words.push_back(value);
    }
}

} // namespace

std::vector<std::string> recipeWords(const CLI::App& command)
{
    std::vector<std::string> words{command.get_name()}, options;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 ||
            std::find(withoutEffect.begin(), withoutEffect.end(), "--" + option->get_single_name()) != withoutEffect.end())
            continue;
        for (const std::string& value : option->results()) {
            if (option->get_positional())
                words.push_back(value.starts_with('-') ? "./" + value : value);
            else if (option->get_items_expected_max() == 0)
                options.push_back("--" + option->get_single_name());
            else
                addOption(options, "--" + option->get_single_name(), value);
        }
    }
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

std::string outputOf(const CLI::App& command)
{
    const CLI::Option* output = command.get_option_no_throw("--output");
    return output && output->count() > 0 ? output->results().front() : "";
}

RecipeOption::RecipeOption(CLI::App& program) : m_program(program)
{
    for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        if (command->get_option_no_throw("--output"))
            command->add_flag_callback(
                "--recipe", [log = m_log] { *log = std::make_unique<FileLog>(); },
                "write OUT.recipe.json beside the output: command, version, and the content of all files, for `mirrorball recipe`");
}

void RecipeOption::write() const
{
    if (!*m_log)
        return;
    for (const CLI::App* command : m_program.get_subcommands()) {
        const std::string output = outputOf(*command);
        if (output.empty())
            throw InvalidArgument("--recipe: goes beside an output; give one by -o");
        const std::filesystem::path folder = std::filesystem::current_path();
        saveRecipe(makeRecipe(MIRRORBALL_VERSION, recipeWords(*command), folder, **m_log), folder, output);
    }
}

} // namespace mirrorball::cli
