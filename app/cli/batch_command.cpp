#include "batch_plan.h"
#include "command.h"
#include "job_processes.h"
#include "stopped.h"

#include "core/base/error.h"
#include "core/batch/recipe.h"
#include "core/batch/scheduler_template.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <numeric>

namespace mirrorball::cli {
namespace {

struct Options {
    std::string file, scheduler;
    std::optional<int> task;
    int jobs = 1;
    bool list = false, check = false;
};

std::string counted(size_t number, const char* one, const char* more) { return std::to_string(number) + " " + (number == 1 ? one : more); }

/// The commands that are asked for: all, or those of a task.
std::vector<const PlannedCommand*> chosen(const Options& o, const BatchPlan& plan)
{
    const size_t tasks = plan.file.taskCount();
    if (o.task && (*o.task < 0 || static_cast<size_t>(*o.task) >= tasks))
        throw InvalidArgument("--task: must be from 0 to " + std::to_string(tasks - 1) + ", for " + shownPath(o.file) + " has " +
                              counted(tasks, "task", "tasks") + "; it is " + std::to_string(*o.task));
    std::vector<const PlannedCommand*> commands;
    for (size_t i = 0; i < plan.commands.size(); ++i)
        if (!o.task || plan.file.taskOf(i) == static_cast<size_t>(*o.task))
            commands.push_back(&plan.commands[i]);
    return commands;
}

void print(const std::string& line)
{
    std::printf("%s\n", line.c_str());
    std::fflush(stdout); // a log that is read while it grows
}

void check(const Options& o, const BatchPlan& plan)
{
    const std::vector<const PlannedCommand*> commands = chosen(o, plan);
    RecipeChecker checker(MIRRORBALL_VERSION);
    const auto report = progressReport("check");
    size_t wrong = 0, seen = 0;
    for (const PlannedCommand* command : commands) {
        if (const std::string why = checker.whyToMake(command->recipe, plan.file.folder, command->output); !why.empty()) {
            print(shownPath(command->output) + ": " + why);
            ++wrong;
        }
        if (report)
            report(static_cast<float>(++seen) / static_cast<float>(commands.size()));
    }
    if (wrong > 0)
        throw WorkError(shownPath(o.file) + ": " + std::to_string(wrong) + " of " + counted(commands.size(), "output does", "outputs do") +
                        " not verify; run it again to make " + (wrong == 1 ? "it" : "them"));
    print(counted(commands.size(), "output verifies", "outputs verify"));
}

/// Runs commands and keeps account of them.
class Batch {
public:
    Batch(const Options& o, const BatchPlan& plan) : m_options(o), m_plan(plan), m_commands(chosen(o, plan)) {}

    void run()
    {
        m_report = progressReport("batch");
        const int signal = JobProcesses::run(m_options.jobs, {.next = [this] { return next(); },
                                                              .progressed = [this](size_t call, float f) { progressed(call, f); },
                                                              .ended = [this](size_t call, const CallEnd& end) { ended(call, end); }});
        const size_t open = m_commands.size() - m_verified - m_made - m_failed;
        if (signal != 0 && open > 0)
            throw Stopped(shownPath(m_options.file) + ": stopped by SIG" + ::sigabbrev_np(signal) + " with " +
                          counted(open, "output", "outputs") + " to go; run it again to go on");
        if (m_failed > 0)
            throw WorkError(shownPath(m_options.file) + ": " + std::to_string(m_failed) + " of " +
                            counted(m_commands.size(), "command", "commands") + " failed, as said above");
    }

private:
    struct Call {
        const PlannedCommand* command;
        std::string why; ///< it is made
        float fraction = 0.0f;
    };

    std::optional<ProgramCall> next()
    {
        while (m_next < m_commands.size()) {
            const PlannedCommand& command = *m_commands[m_next++];
            std::string why = m_checker.whyToMake(command.recipe, m_plan.file.folder, command.output);
            if (!why.empty()) {
                m_calls.push_back({&command, std::move(why)});
                return callOf(command);
            }
            ++m_verified;
            print("verified " + shownPath(command.output));
            showProgress();
        }
        return std::nullopt;
    }

    ProgramCall callOf(const PlannedCommand& command) const
    {
        std::error_code failed; // then the command says so
        std::filesystem::create_directories((m_plan.file.folder / command.output).parent_path(), failed);
        ProgramCall call{.words = command.words, .folder = m_plan.file.folder, .label = command.where};
        call.words.emplace_back("--recipe");
        if (command.takesThreads) {
            call.words.insert(call.words.end(), {"--progress", "openjd"});
            if (!command.statesThreads && m_options.jobs > 1) // as many in all as one command would take
                call.words.insert(call.words.end(),
                                  {"--threads", std::to_string(std::max(1, JobControl{}.threadCount() / m_options.jobs))});
        }
        return call;
    }

    void progressed(size_t call, float fraction)
    {
        m_calls[call].fraction = fraction;
        showProgress();
    }

    void ended(size_t number, const CallEnd& end)
    {
        Call& call = m_calls[number];
        call.fraction = 1.0f;
        const std::string output = shownPath(call.command->output);
        char seconds[32];
        std::snprintf(seconds, sizeof seconds, "%.1f s", end.seconds);
        if (end.status == 0) {
            ++m_made;
            print("made " + output + " in " + seconds + ": " + call.why);
        } else if (end.wasStopped) {
            print("stopped " + output); // and wants to run again
        } else {
            const int signal = end.status - 128;
            ++m_failed;
            print("failed " + output + (signal > 0 ? ": ended by SIG" + std::string(::sigabbrev_np(signal)) : ""));
        }
        showProgress();
    }

    void showProgress() const
    {
        const float running =
            std::accumulate(m_calls.begin(), m_calls.end(), 0.0f, [](float sum, const Call& call) { return sum + call.fraction; });
        if (m_report)
            m_report((static_cast<float>(m_verified) + running) / static_cast<float>(m_commands.size()));
    }

    const Options& m_options;
    const BatchPlan& m_plan;
    std::vector<const PlannedCommand*> m_commands;
    RecipeChecker m_checker{MIRRORBALL_VERSION};
    std::function<void(float)> m_report{};
    std::vector<Call> m_calls{};
    size_t m_next = 0, m_verified = 0, m_made = 0, m_failed = 0;
};

void run(const Options& o)
{
    if (o.list + o.check + !o.scheduler.empty() > 1)
        throw InvalidArgument("--list, --check and --template: each does one thing; give one of them");
    if (o.task && (o.list || !o.scheduler.empty()))
        throw InvalidArgument("--task: runs or checks one task; leave --list and --template out");
    const BatchPlan plan = planBatch(o.file);
    if (o.list) {
        print(std::to_string(plan.file.taskCount()));
    } else if (!o.scheduler.empty()) {
        const auto known = words(Scheduler{});
        const auto which = static_cast<Scheduler>(std::find(known.begin(), known.end(), o.scheduler) - known.begin());
        std::printf("%s", schedulerTemplate(which, std::filesystem::absolute(o.file).lexically_normal(), plan.file.taskCount()).c_str());
    } else if (o.check) {
        check(o, plan);
    } else {
        Batch(o, plan).run();
    }
}

} // namespace

void addBatchCommand(CLI::App& program)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("batch", "Make what a jobs file lists, here or on a farm, and leave out what verifies");
    command->add_option("JOBS", o->file, "jobs file (.json): commands, or scenes with frames")->required();
    command->add_option("--task", o->task, "make this task alone, counted from 0");
    command->add_flag("--list", o->list, "print how many tasks there are");
    command->add_option("--jobs", o->jobs, "commands that run at once")->check(within(1, 1024));
    command->add_flag("--check", o->check,
                      "make nothing; say which outputs are not what their recipes say, and end with 1 if there are any");
    std::string known;
    for (const std::string_view word : words(Scheduler{}))
        known += (known.empty() ? "" : ", ") + std::string(word);
    command->add_option("--template", o->scheduler, "print what hands the tasks to a scheduler: " + known)
        ->check(CLI::IsMember(words(Scheduler{})));
    command->callback([o] { run(*o); });
}

} // namespace mirrorball::cli
