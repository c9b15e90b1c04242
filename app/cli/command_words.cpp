#include "command_words.h"

#include <sstream>

namespace mirrorball::cli {
namespace {

/// The words of fields of a scene end their help: "kind of the map: latlong | cube | sphere".
std::vector<std::string> choicesOfHelp(const std::string& help)
{
    std::vector<std::string> choices;
    if (help.find(" | ") == std::string::npos)
        return choices;
    const size_t colon = help.rfind(": ");
    std::istringstream list(help.substr(colon == std::string::npos ? 0 : colon + 2));
    for (std::string word; list >> word;)
        if (word != "|")
            choices.push_back(word);
    return choices;
}

/// CLI::IsMember describes itself as "{a,b,c}" behind the type's name.
std::vector<std::string> choicesIn(const std::string& typeName)
{
    std::vector<std::string> choices;
    const size_t open = typeName.find('{'), close = typeName.find('}');
    if (open == std::string::npos || close == std::string::npos)
        return choices;
    std::istringstream list(typeName.substr(open + 1, close - open - 1));
    for (std::string word; std::getline(list, word, ',');)
        choices.push_back(word);
    return choices;
}

OptionWords wordsOf(const CLI::Option& option)
{
    OptionWords words{.help = option.get_description(), .isPositional = option.get_positional(), .isRequired = option.get_required()};
    const int most = option.get_items_expected_max();
    words.takesMany = most > 1;
    if (words.isPositional) {
        words.names = {option.get_single_name()};
        return words;
    }
    for (const std::string& name : option.get_snames())
        words.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        words.names.push_back("--" + name);
    if (most > 0) {
        const std::string type = option.get_type_name();
        words.choices = choicesIn(type);
        if (words.choices.empty())
            words.choices = choicesOfHelp(words.help);
        words.value = type.substr(0, type.find_first_of(":{ "));
        if (words.value.empty())
            words.value = "VALUE";
    }
    return words;
}

} // namespace

std::vector<OptionWords> optionWords(const CLI::App& app)
{
    std::vector<OptionWords> options;
    for (const CLI::Option* option : app.get_options())
        options.push_back(wordsOf(*option));
    return options;
}

std::vector<CommandWords> commandWords(const CLI::App& program)
{
    std::vector<CommandWords> commands;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
        commands.push_back({command->get_name(), command->get_description(), optionWords(*command), command->get_footer()});
    return commands;
}

} // namespace mirrorball::cli
