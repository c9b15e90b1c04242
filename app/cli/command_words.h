#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// What man pages and shells' completions are made of: the declarations that `--help` shows.
namespace mirrorball::cli {

struct OptionWords {
    std::vector<std::string> names{};   ///< "-o", "--output"; of a positional its name alone
    std::string value{};                ///< "TEXT"; empty for a flag
    std::vector<std::string> choices{}; ///< the only words that the value can be; empty: others
    std::string help{};
    bool isPositional = false, isRequired = false, takesMany = false;
};

struct CommandWords {
    std::string name{}, help{};
    std::vector<OptionWords> options{}; ///< in the order of --help
    std::string notes{};                ///< below them
};

/// The commands that `mirrorball --help` lists.
std::vector<CommandWords> commandWords(const CLI::App& program);
/// The options of the program itself.
std::vector<OptionWords> optionWords(const CLI::App& app);

/// Pages for man(1), in roff: the program's own, named "mirrorball.1", and one for each command.
struct ManPage {
    std::string file{}, text{};
};
std::vector<ManPage> manPages(const CLI::App& program, const std::string& version);

/// Scripts that complete commands, options and the words that an option can be.
std::string bashCompletion(const CLI::App& program);
std::string zshCompletion(const CLI::App& program);
std::string fishCompletion(const CLI::App& program);

} // namespace mirrorball::cli
