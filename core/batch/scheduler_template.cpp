#include "scheduler_template.h"

#include "core/base/shell_word.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace mirrorball {
namespace {

/// A name that any scheduler takes: letters, digits, dashes and underscores.
std::string jobName(const std::filesystem::path& jobsFile)
{
    std::string name = jobsFile.stem().string().substr(0, 60);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c > 127 || (!std::isalnum(c) && c != '-' && c != '_'); }, '_');
    return name.empty() ? "mirrorball" : name;
}

std::string slurmScript(const std::filesystem::path& jobsFile, size_t tasks)
{
    const std::string name = jobName(jobsFile);
    return "#!/bin/sh\n"
           "#SBATCH --job-name=" +
           name + "\n#SBATCH --array=0-" + std::to_string(tasks - 1) + "\n#SBATCH --output=" + name +
           "-%A_%a.log\n"
           "#SBATCH --signal=B:TERM@60\n"
           "#SBATCH --requeue\n"
           "# One task of the array makes one task of the jobs file. A task that is stopped ends with status 75 and leaves nothing half "
           "done:\n"
           "# submit the array again (or let RequeueExit=75 in slurm.conf do it), and only what does not verify is made.\n"
           "# A cluster takes arrays of up to its MaxArraySize (1001 where nobody set it): per_task in the jobs file makes fewer, longer "
           "tasks.\n"
           "exec mirrorball batch " +
           shellWord(jobsFile.string()) + " --task \"$SLURM_ARRAY_TASK_ID\" --progress plain\n";
}

/// "{{" begins a reference in a template, and nothing escapes it there: the path is a parameter's default, which is no format string.
std::string openJobTemplate(const std::filesystem::path& jobsFile, size_t tasks)
{
    using Json = nlohmann::ordered_json;
    const Json stop{{"mode", "NOTIFY_THEN_TERMINATE"}, {"notifyPeriodInSeconds", 30}};
    const Json run{{"command", "mirrorball"},
                   {"args", {"batch", "{{Param.JobsFile}}", "--task", "{{Task.Param.Task}}", "--progress", "openjd"}},
                   {"cancelation", stop}};
    const Json step{
        {"name", "Make"},
        {"parameterSpace",
         {{"taskParameterDefinitions", Json::array({{{"name", "Task"}, {"type", "INT"}, {"range", "0-" + std::to_string(tasks - 1)}}})}}},
        {"script", {{"actions", {{"onRun", run}}}}}};
    const Json whole{
        {"specificationVersion", "jobtemplate-2023-09"},
        {"name", jobName(jobsFile)},
        {"description", "Each task makes one task of a Mirrorball jobs file. Not proven: no scheduler has run this template."},
        {"parameterDefinitions",
         Json::array(
             {{{"name", "JobsFile"}, {"type", "PATH"}, {"objectType", "FILE"}, {"dataFlow", "IN"}, {"default", jobsFile.string()}}})},
        {"steps", Json::array({step})}};
    return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string parallelLine(const std::filesystem::path& jobsFile, size_t tasks)
{
    // The command is one word for parallel, which hands it to a shell; a path that needs quotes gets them there.
    const std::string command = "mirrorball batch " + shellWord(jobsFile.string()) + " --task {}";
    return "seq 0 " + std::to_string(tasks - 1) + " | parallel --halt never --termseq TERM,20000,KILL,25 " + shellWord(command) + "\n";
}

} // namespace

std::vector<std::string_view> words(Scheduler) { return {"slurm", "openjd", "parallel"}; }

std::string schedulerTemplate(Scheduler scheduler, const std::filesystem::path& jobsFile, size_t tasks)
{
    switch (scheduler) {
    case Scheduler::Slurm:
        return slurmScript(jobsFile, tasks);
    case Scheduler::OpenJobDescription:
        return openJobTemplate(jobsFile, tasks);
    case Scheduler::GnuParallel:
        return parallelLine(jobsFile, tasks);
    }
    return {};
}

} // namespace mirrorball
