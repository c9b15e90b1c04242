#include "core/batch/scheduler_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirrorball {
namespace {

using testing::HasSubstr;

TEST(SchedulerTemplate, QuotesPathsForTheShell)
{
    const std::string script = schedulerTemplate(Scheduler::Slurm, "/farm/my jobs/it's.json", 60);
    EXPECT_THAT(script, HasSubstr("#SBATCH --array=0-59\n"));
    EXPECT_THAT(script, HasSubstr("exec mirrorball batch '/farm/my jobs/it'\\''s.json' --task \"$SLURM_ARRAY_TASK_ID\""));
    EXPECT_THAT(script, HasSubstr("#SBATCH --job-name=it_s\n")); // directives know no quotes
}

/// By the specification's rules: https://github.com/OpenJobDescription/openjd-specifications, 2023-09 template schemas.
TEST(SchedulerTemplate, NamesThePathInAnOpenJobTemplateWhereBracesMeanNothing)
{
    const auto json = nlohmann::json::parse(schedulerTemplate(Scheduler::OpenJobDescription, "/farm/{{x}}/jobs.json", 300));
    EXPECT_EQ(json["specificationVersion"], "jobtemplate-2023-09");
    EXPECT_EQ(json["parameterDefinitions"][0]["default"], "/farm/{{x}}/jobs.json");
    EXPECT_EQ(json["steps"][0]["parameterSpace"]["taskParameterDefinitions"][0]["range"], "0-299");
    EXPECT_THAT(json["description"], HasSubstr("Not proven"));
    const auto& run = json["steps"][0]["script"]["actions"]["onRun"];
    EXPECT_EQ(run["args"], nlohmann::json({"batch", "{{Param.JobsFile}}", "--task", "{{Task.Param.Task}}", "--progress", "openjd"}));
}

} // namespace
} // namespace mirrorball
