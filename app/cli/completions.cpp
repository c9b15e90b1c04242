#include "command_words.h"

#include <algorithm>

namespace mirrorball::cli {
namespace {

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

/// In single quotes of any of the three shells: none of them lets a quote in there without a way of its own, so that it becomes another
/// one.
std::string quotable(std::string text)
{
    std::replace(text.begin(), text.end(), '\'', '`');
    return text;
}

std::vector<std::string> namesOf(const std::vector<OptionWords>& options)
{
    std::vector<std::string> names;
    for (const OptionWords& option : options)
        if (!option.isPositional)
            names.insert(names.end(), option.names.begin(), option.names.end());
    return names;
}

constexpr const char* origin = "# Made by `mirrorball reference` from the declarations of its options.\n";

/// What _arguments takes: brackets and colons have a meaning there.
std::string zshText(const std::string& text)
{
    std::string shown;
    for (const char c : quotable(text))
        shown += (c == '[' || c == ']' || c == ':' || c == '\\') ? std::string{'\\', c} : std::string(1, c);
    return shown;
}

std::string zshOption(const OptionWords& option)
{
    std::string value;
    if (!option.choices.empty())
        value = ":value:(" + joined(option.choices) + ")";
    else if (!option.value.empty())
        value = ":value:_files";
    std::string specs;
    for (const std::string& name : option.names)
        specs += " \\\n        '" + std::string(option.takesMany ? "*" : "") + name + "[" + zshText(option.help) + "]" + value + "'";
    return specs;
}

} // namespace

std::string bashCompletion(const CLI::App& program)
{
    std::vector<std::string> first = namesOf(optionWords(program));
    std::string choices, options;
    for (const CommandWords& command : commandWords(program)) {
        first.push_back(command.name);
        options += "        " + command.name + ") words='" + joined(namesOf(command.options)) + "' ;;\n";
        for (const OptionWords& option : command.options)
            for (const std::string& name : option.names)
                if (!option.choices.empty())
                    choices += "        '" + command.name + " " + name + "') words='" + joined(option.choices) + "' ;;\n";
    }
    return std::string(origin) +
           "_mirrorball() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} words=\n"
           "    COMPREPLY=()\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
           "        COMPREPLY=($(compgen -W '" +
           joined(first) +
           "' -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    case \"${COMP_WORDS[1]} ${COMP_WORDS[COMP_CWORD-1]}\" in\n" +
           choices +
           "    esac\n"
           "    if [ -z \"$words\" ] && [ \"${word#-}\" != \"$word\" ]; then\n"
           "        case ${COMP_WORDS[1]} in\n" +
           options +
           "        esac\n"
           "    fi\n"
           "    [ -z \"$words\" ] || COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) # else bash completes file names\n"
           "}\n"
           "complete -o default -F _mirrorball mirrorball\n";
}

std::string zshCompletion(const CLI::App& program)
{
    std::string commands, cases;
    for (const CommandWords& command : commandWords(program)) {
        commands += " \\\n        '" + command.name + ":" + zshText(command.help) + "'";
        cases += "    " + command.name + ")\n        _arguments '1:command:'";
        for (const OptionWords& option : command.options)
            if (!option.isPositional)
                cases += zshOption(option);
        cases += " \\\n        '*:file:_files' ;;\n";
    }
    return "#compdef mirrorball\n" + std::string(origin) + "_mirrorball() {\n    local -a commands\n    commands=(" + commands +
           ")\n"
           "    if (( CURRENT == 2 )); then\n"
           "        _describe command commands\n"
           "        return\n"
           "    fi\n"
           "    case $words[2] in\n" +
           cases +
           "    esac\n"
           "}\n"
           "_mirrorball \"$@\"\n";
}

std::string fishCompletion(const CLI::App& program)
{
    std::string text = origin;
    for (const CommandWords& command : commandWords(program)) {
        text += "complete -c mirrorball -f -n __fish_use_subcommand -a " + command.name + " -d '" + quotable(command.help) + "'\n";
        for (const OptionWords& option : command.options) {
            if (option.isPositional)
                continue;
            text += "complete -c mirrorball -n '__fish_seen_subcommand_from " + command.name + "'";
            for (const std::string& name : option.names)
                text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (!option.choices.empty())
                text += " -x -a '" + joined(option.choices) + "'";
            else if (!option.value.empty())
                text += " -r";
            text += " -d '" + quotable(option.help) + "'\n";
        }
    }
    return text;
}

} // namespace mirrorball::cli
