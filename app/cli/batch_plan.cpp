#include "batch_plan.h"

#include "command.h"
#include "recipe_option.h"

#include "core/base/error.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace mirrorball::cli {
namespace {

/// A command's callback owns what the options are read into: it is kept, and not called.
struct Silenced : CLI::App {
    static std::function<void()> take(CLI::App& command) { return std::exchange(command.*(&Silenced::final_callback_), {}); }
};

/// The command line without its effects: it parses, and runs nothing.
class CommandReader {
public:
    CommandReader()
    {
        addCommands(m_program, 0, nullptr);
        m_program.require_subcommand(1);
        for (CLI::App* command : m_program.get_subcommands([](const CLI::App*) { return true; }))
            m_owners.push_back(Silenced::take(*command));
    }

    /// @throws InvalidArgument without the field's name
    PlannedCommand read(const BatchCommand& command)
    {
        try {
            m_program.parse(std::vector<std::string>(command.words.rbegin(), command.words.rend())); // CLI11 takes them from the back
        } catch (const CLI::Success&) {
            throw InvalidArgument("asks for help and makes nothing");
        } catch (const CLI::Error& error) {
            throw InvalidArgument(error.what());
        }
        const CLI::App& parsed = *m_program.get_subcommands().front();
        PlannedCommand planned{.where = command.where, .words = command.words, .recipe = recipeWords(parsed), .output = outputOf(parsed)};
        if (planned.output.empty())
            throw InvalidArgument("'" + parsed.get_name() +
                                  "' has no -o OUT, so nothing would tell that it is done; batch runs what writes files");
        const CLI::Option* threads = parsed.get_option_no_throw("--threads");
        planned.takesThreads = threads;
        planned.statesThreads = threads && threads->count() > 0;
        return planned;
    }

private:
    std::vector<std::function<void()>> m_owners{};
    CLI::App m_program{"", "mirrorball"};
};

std::filesystem::path placeOf(const std::string& path, const std::filesystem::path& folder)
{
    const std::filesystem::path place = (folder / path).lexically_normal();
    return place.has_filename() ? place : place.parent_path();
}

using Makers = std::map<std::filesystem::path, const PlannedCommand*>;

/// No command may need what another one makes, or make it again.
void checkApart(const PlannedCommand& command, const Makers& makers, const std::filesystem::path& folder)
{
    if (const PlannedCommand* other = makers.at(placeOf(command.output, folder)); other != &command)
        throw InvalidArgument(command.where + ": writes " + shownPath(command.output) + ", which " + other->where +
                              " writes, too; give each command an output of its own");
    for (size_t i = 1; i < command.recipe.size(); ++i) {
        if (command.recipe[i] == "--output") {
            ++i;
            continue;
        }
        const std::filesystem::path place = placeOf(command.recipe[i], folder);
        for (std::filesystem::path path = place; path != folder && path != path.root_path(); path = path.parent_path())
            if (const auto maker = makers.find(path); maker != makers.end() && (maker->second != &command || path == place))
                throw InvalidArgument(command.where + ": needs " + shownPath(command.recipe[i]) + ", which " + maker->second->where +
                                      " makes, and tasks run in any order; put it into a second jobs file, to be run after this one");
    }
}

} // namespace

BatchPlan planBatch(const std::filesystem::path& jobsFile)
{
    BatchPlan plan{.file = loadJobs(jobsFile), .commands = {}};
    const std::filesystem::path& folder = plan.file.folder;
    try {
        CommandReader reader;
        for (const BatchCommand& command : plan.file.commands)
            try {
                plan.commands.push_back(reader.read(command));
            } catch (const InvalidArgument& error) {
                throw InvalidArgument(command.where + ": " + error.what());
            }
        Makers makers;
        for (const PlannedCommand& command : plan.commands)
            makers.emplace(placeOf(command.output, folder), &command);
        for (const PlannedCommand& command : plan.commands)
            checkApart(command, makers, folder);
    } catch (const InvalidArgument& error) {
        throw FileError(jobsFile.string(), error.what());
    }
    return plan;
}

} // namespace mirrorball::cli
