#pragma once

#include "core/base/file_log.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace mirrorball::cli {

/// A command as a recipe keeps it: its name, then what was given, in the order of `--help`, each option under its long name. What cannot
/// change a byte of the output is left out: threads, progress, explanations.
std::vector<std::string> recipeWords(const CLI::App& command);

/// What `-o` of a command that was parsed names; empty where it was not given or the command has none.
std::string outputOf(const CLI::App& command);

/// `--recipe` of every command that has an output: writes OUT.recipe.json when the command is done.
class RecipeOption {
public:
    /// `program` and its commands must live as long as this.
    explicit RecipeOption(CLI::App& program);

    /// After the command has run: writes the recipe if it was asked for. @throws WorkError
    void write() const;

private:
    CLI::App& m_program;
    std::shared_ptr<std::unique_ptr<FileLog>> m_log = std::make_shared<std::unique_ptr<FileLog>>(); ///< open from --recipe on
};

} // namespace mirrorball::cli
