#include "core/batch/jobs_file.h"

#include "core/base/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using test::TemporaryFolder;

BatchFile loaded(const TemporaryFolder& folder, const std::string& jobs)
{
    test::writeBytes(folder / "jobs.json", R"({"version": 1, )" + jobs + "}");
    return loadJobs(folder / "jobs.json");
}

using Words = std::vector<std::string>;

TEST(JobsFile, WritesOutFramesOfACommandAndOfAScene)
{
    const TemporaryFolder folder;
    const BatchFile file = loaded(folder, R"("jobs": [
        {"command": ["filter", "in.####.hdr", "-o", "out.####.exr", "--yaw", "{frame}"], "frames": "9-10"},
        {"scene": "car.mirrorball", "picture": "car.##.png", "frames": "1", "options": ["--size", "8x8"]},
        {"scene": "car.mirrorball", "exports": "game"}])");
    ASSERT_EQ(file.commands.size(), 4u);
    EXPECT_EQ(file.commands[0].words, Words({"filter", "in.0009.hdr", "-o", "out.0009.exr", "--yaw", "9"}));
    EXPECT_EQ(file.commands[1].words, Words({"filter", "in.0010.hdr", "-o", "out.0010.exr", "--yaw", "10"}));
    EXPECT_EQ(file.commands[1].where, "jobs[0].command for frame 10");
    EXPECT_EQ(file.commands[2].words, Words({"render", "car.mirrorball", "-o", "car.01.png", "--size", "8x8"}));
    EXPECT_EQ(file.commands[3].words, Words({"export", "car.mirrorball", "-o", "game"}));
    EXPECT_EQ(file.folder, folder.path());
}

TEST(JobsFile, FindsTheFilesOfAPatternByNameInAFolderWhoseNameLooksLikeOne)
{
    const TemporaryFolder outer;
    std::filesystem::create_directories(outer / "a[1]*" / "probes");
    for (const char* name : {"b.hdr", "a.hdr", "c.exr"})
        test::writeBytes(outer / "a[1]*" / "probes" / name, "x");
    test::writeBytes(
        outer / "a[1]*" / "jobs.json",
        R"({"version": 1, "jobs": [{"command": ["convert", "{path}", "-o", "out/{stem}.exr"], "each": ["probes/*.hdr", "probes/c.exr"]}]})");
    const BatchFile file = loadJobs(outer / "a[1]*" / "jobs.json");
    ASSERT_EQ(file.commands.size(), 3u);
    EXPECT_EQ(file.commands[0].words, Words({"convert", "probes/a.hdr", "-o", "out/a.exr"}));
    EXPECT_EQ(file.commands[1].words, Words({"convert", "probes/b.hdr", "-o", "out/b.exr"}));
    EXPECT_EQ(file.commands[2].words, Words({"convert", "probes/c.exr", "-o", "out/c.exr"}));
}

/// Each command is in one task, whatever the numbers.
TEST(JobsFile, DividesCommandsIntoTasks)
{
    const TemporaryFolder folder;
    for (const int count : {1, 2, 3, 4, 5, 6, 7})
        for (const int perTask : {1, 2, 3, 7, 100}) {
            const BatchFile file = loaded(folder, R"("per_task": )" + std::to_string(perTask) +
                                                      R"(, "jobs": [{"command": ["#"], "frames": "1-)" + std::to_string(count) + R"("}])");
            std::vector<BatchCommand> inTasks;
            for (size_t task = 0; task < file.taskCount(); ++task) {
                EXPECT_GE(file.task(task).size(), 1u);
                EXPECT_LE(file.task(task).size(), static_cast<size_t>(perTask));
                for (const BatchCommand& command : file.task(task)) {
                    EXPECT_EQ(file.taskOf(inTasks.size()), task);
                    inTasks.push_back(command);
                }
            }
            EXPECT_EQ(inTasks, file.commands) << count << " by " << perTask;
        }
}

struct Bad {
    const char* text;
    const char* word; ///< of the message: the field
};

TEST(JobsFile, NamesTheFieldThatIsWrong)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "a.hdr", "x");
    constexpr Bad files[] = {
        {R"([])", "object"},
        {R"({"jobs": []})", "version"},
        {R"({"version": 2, "jobs": []})", "version"},
        {R"({"version": 1})", "jobs"},
        {R"({"version": 1, "jobs": []})", "jobs"},
        {R"({"version": 1, "jobs": {}})", "jobs"},
        {R"({"version": 1, "job": []})", "job"},
        {R"({"version": 1, "per_task": 0, "jobs": [{"command": ["a"]}]})", "per_task"},
        {R"({"version": 1, "per_task": 1.5, "jobs": [{"command": ["a"]}]})", "per_task"},
        {R"({"version": 1, "jobs": [{"command": ["a"]}, 7]})", "jobs[1]"},
        {R"({"version": 1, "jobs": [{}]})", "jobs[0]"},
        {R"({"version": 1, "jobs": [{"command": "filter a.hdr"}]})", "jobs[0].command"},
        {R"({"version": 1, "jobs": [{"command": []}]})", "jobs[0].command"},
        {R"({"version": 1, "jobs": [{"command": ["a", 5]}]})", "jobs[0].command[1]"},
        {R"({"version": 1, "jobs": [{"comand": ["a"]}]})", "jobs[0].comand"},
        {R"({"version": 1, "jobs": [{"command": ["a"], "scene": "b"}]})", "jobs[0]"},
        {R"({"version": 1, "jobs": [{"command": ["a"], "picture": "b"}]})", "jobs[0]"},
        {R"({"version": 1, "jobs": [{"scene": "b"}]})", "jobs[0]"},
        {R"({"version": 1, "jobs": [{"scene": "b", "picture": "c", "exports": "d"}]})", "jobs[0]"},
        {R"({"version": 1, "jobs": [{"command": ["a#"], "frames": "1-x"}]})", "jobs[0].frames"},
        {R"({"version": 1, "jobs": [{"command": ["a#"], "frames": 5}]})", "jobs[0].frames"},
        {R"({"version": 1, "jobs": [{"command": ["a"], "frames": "1-2"}]})", "jobs[0].frames"},
        {R"({"version": 1, "jobs": [{"command": ["{path}"], "each": ["*.exr"]}]})", "jobs[0].each[0]"},
        {R"({"version": 1, "jobs": [{"command": ["a"], "each": ["*.hdr"]}]})", "jobs[0].each"},
        {R"({"version": 1, "jobs": [{"command": ["{path}#"], "each": ["*.hdr"], "frames": "1"}]})", "jobs[0]"},
        {R"({"version": 1, "jobs": [{"command": ["a#"], "frames": "0-999999"}, {"command": ["b#"], "frames": "0-999999"}]})", "jobs[1]"},
        {R"({"version": 1, "jobs": [{"command": ["a"], "command": ["b"]}]})", "command"},
    };
    for (const Bad& bad : files) {
        test::writeBytes(folder / "jobs.json", bad.text);
        try {
            loadJobs(folder / "jobs.json");
            ADD_FAILURE() << "not refused: " << bad.text;
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find(bad.word), std::string::npos) << message;
            EXPECT_NE(message.find("jobs.json: "), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
}

} // namespace
} // namespace mirrorball
