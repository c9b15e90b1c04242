#include "command_words.h"

#include <algorithm>
#include <sstream>

namespace mirrorball::cli {
namespace {

/// Text of any kind as roff shows it; a line that begins with a dot or an apostrophe would be a request.
std::string roff(const std::string& text)
{
    std::string shown;
    for (const char c : text) {
        if (c == '\\')
            shown += "\\e";
        else if (c == '-')
            shown += "\\-";
        else if ((c == '.' || c == '\'') && (shown.empty() || shown.back() == '\n'))
            shown += std::string("\\&") + c;
        else
            shown += c;
    }
    return shown;
}

std::string upper(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string head(const std::string& page, const std::string& version, const std::string& help)
{
    return ".TH " + upper(roff(page)) + " 1 \"\" \"Mirrorball " + version + "\" \"User Commands\"\n.SH NAME\n" + roff(page) + " \\- " +
           roff(help) + "\n";
}

std::string optionText(const OptionWords& option)
{
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
    std::string help = roff(option.help);
    if (option.isRequired && !option.isPositional)
        help += (help.empty() ? "" : "; ") + std::string("must be given");
    if (!option.choices.empty() && option.help.find(option.choices.front()) == std::string::npos) {
        help += ": ";
        for (const std::string& choice : option.choices)
            help += (choice == option.choices.front() ? "" : ", ") + roff(choice);
    }
    return ".TP\n" + names + (option.value.empty() ? "" : " \\fI" + roff(option.value) + "\\fR") + "\n" + help + "\n";
}

std::string notesText(const std::string& notes)
{
    if (notes.empty())
        return "";
    std::string text = ".SH NOTES\n";
    std::istringstream lines(notes);
    for (std::string line; std::getline(lines, line);)
        text += roff(line) + "\n.br\n";
    return text;
}

std::string commandPage(const CommandWords& command, const std::string& version)
{
    std::string page = head("mirrorball-" + command.name, version, command.help);
    page += ".SH SYNOPSIS\n\\fBmirrorball " + roff(command.name) + "\\fR";
    for (const OptionWords& option : command.options)
        if (option.isPositional)
            page += (option.isRequired ? " \\fI" : " [\\fI") + roff(option.names.front()) + (option.isRequired ? "\\fR" : "\\fR]") +
                    (option.takesMany ? "..." : "");
    page += " [\\fIOPTION\\fR]...\n.SH OPTIONS\n";
    for (const OptionWords& option : command.options)
        page += optionText(option);
    page += notesText(command.notes);
    return page + ".SH SEE ALSO\n.BR mirrorball (1)\n";
}

} // namespace

std::vector<ManPage> manPages(const CLI::App& program, const std::string& version)
{
    const std::vector<CommandWords> commands = commandWords(program);
    std::string own = head("mirrorball", version, program.get_description());
    own += ".SH SYNOPSIS\n\\fBmirrorball\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n.SH COMMANDS\nEach has a page of its own.\n";
    for (const CommandWords& command : commands)
        own += ".TP\n.BR mirrorball\\-" + roff(command.name) + " (1)\n" + roff(command.help) + "\n";
    own += ".SH OPTIONS\n";
    for (const OptionWords& option : optionWords(program))
        own += optionText(option);
    own += notesText(program.get_footer());
    std::vector<ManPage> pages{{"mirrorball.1", own}};
    for (const CommandWords& command : commands)
        pages.push_back({"mirrorball-" + command.name + ".1", commandPage(command, version)});
    return pages;
}

} // namespace mirrorball::cli
