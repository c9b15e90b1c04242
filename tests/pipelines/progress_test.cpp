#include "batch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace mirrorball {
namespace {

using test::BatchFolder;
using test::ProgramRun;

/// The percents of lines that begin so; other lines are -1.
std::vector<int> percents(const std::string& text, const std::string& beginning)
{
    std::vector<int> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        found.push_back(line.starts_with(beginning) ? std::stoi(line.substr(beginning.size())) : -1);
    return found;
}

void expectGrows(const std::vector<int>& percents)
{
    ASSERT_FALSE(percents.empty());
    for (size_t i = 1; i < percents.size(); ++i)
        EXPECT_LT(percents[i - 1], percents[i]);
    EXPECT_GE(percents.front(), 0);
    EXPECT_EQ(percents.back(), 100);
}

/// Lines as the Open Job Description wants them (2023-09, "openjd_progress: <percent>"), of every command that works on threads.
TEST(Progress, GrowsToAHundredInEveryCommand)
{
    const BatchFolder folder;
    folder.run("render --probe probe.hdr --geometry sphere --size 16x16 -o a.png --save-scene s.mirrorball");
    for (const char* command :
         {"convert probe.hdr -o a.exr --to cube --size 64",
          "filter probe.hdr -o a.exr --lobe phong --exponent 9 --to cube --size 64 --method reference", "render s.mirrorball -o b.png",
          "paint porcelain -o m.png --size 64", "brdf ggx:alpha=0.3 --table albedo --size 8 -o t.exr"}) {
        const ProgramRun run = folder.run(std::string(command) + " --progress openjd");
        EXPECT_EQ(run.status, 0) << command << run.err;
        SCOPED_TRACE(std::string(command) + "\n" + run.out);
        expectGrows(percents(run.out, "openjd_progress: "));
        EXPECT_EQ(run.err, "");
        const ProgramRun none = folder.run(std::string(command) + " --progress none");
        EXPECT_EQ(none.out + none.err, "") << command;
        const ProgramRun usual = folder.run(command); // in a pipe
        EXPECT_EQ(usual.out + usual.err, "") << command;
    }
    EXPECT_FAILS(folder.run("convert probe.hdr -o a.exr --to cube --size 8 --progress loud"), 2, "--progress");
}

TEST(Progress, OfABatchIsThatOfItsCommands)
{
    const BatchFolder folder;
    folder.writeJobs(R"("jobs": [{"command": ["filter", "probe.hdr", "-o", "a#.exr", "--lobe", "phong", "--exponent", "9", "--to", "cube",
        "--size", "64", "--method", "reference"], "frames": "1-2"}])");
    const ProgramRun run = folder.run("batch jobs.json --task 0 --progress openjd");
    EXPECT_EQ(run.status, 0) << run.err;
    std::vector<int> of = percents(run.out, "openjd_progress: ");
    std::erase(of, -1);
    expectGrows(of);
    EXPECT_GT(of.size(), 3u) << run.out; // of one command: what it says itself
    const ProgramRun both = folder.run("batch jobs.json --progress plain");
    expectGrows(percents(both.err, "batch: "));
    const ProgramRun check = folder.run("batch jobs.json --check --progress openjd");
    std::vector<int> ofCheck = percents(check.out, "openjd_progress: ");
    std::erase(ofCheck, -1);
    expectGrows(ofCheck);
    EXPECT_EQ(ofCheck.size(), 3u) << check.out; // half of it, all of it, done
}

} // namespace
} // namespace mirrorball
