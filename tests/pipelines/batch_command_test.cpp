#include "batch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <functional>

namespace mirrorball {
namespace {

using test::BatchFolder;
using test::linesWith;
using test::ProgramRun;
using testing::HasSubstr;

TEST(Batch, MakesWhatAPlainRunMakesAndNothingTwice)
{
    const BatchFolder folder;
    folder.writeJobs(test::threeMaps);
    EXPECT_EQ(folder.run("batch jobs.json --list").out, "3\n");
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 1);
    const ProgramRun first = folder.run("batch jobs.json");
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(linesWith(first.out, "made maps/p"), 3u) << first.out;
    EXPECT_EQ(first.err, "");
    const ProgramRun second = folder.run("batch jobs.json --jobs 2");
    EXPECT_EQ(second.status, 0) << second.err;
    EXPECT_EQ(linesWith(second.out, "verified maps/p"), 3u) << second.out;
    EXPECT_EQ(linesWith(second.out, "made"), 0u) << second.out;
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 0);
    for (int i = 1; i <= 3; ++i) {
        ASSERT_EQ(folder.run(test::mapCommand(i, "plain.exr")).status, 0);
        EXPECT_EQ(folder.bytes("maps/p" + std::to_string(i) + ".exr"), folder.bytes("plain.exr"));
    }
    EXPECT_FALSE(folder.has("plain.exr.recipe.json")); // only who asks for a recipe gets one
    EXPECT_TRUE(folder.leftovers().empty());
}

TEST(Batch, WorksFromAnyFolder)
{
    const BatchFolder folder;
    folder.writeJobs(test::threeMaps);
    const ProgramRun run = test::mirrorballRuns("batch " + (folder / "jobs.json").string() + " --jobs 3");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(folder.has("maps/p3.exr"));
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 0);
}

TEST(Batch, ATaskIsExactlyItsCommands)
{
    const BatchFolder folder;
    folder.writeJobs(R"("per_task": 2, )" + test::threeMaps);
    EXPECT_EQ(folder.run("batch jobs.json --list").out, "2\n");
    EXPECT_EQ(folder.run("batch jobs.json --task 0").status, 0);
    EXPECT_TRUE(folder.has("maps/p1.exr") && folder.has("maps/p2.exr") && !folder.has("maps/p3.exr"));
    EXPECT_EQ(folder.run("batch jobs.json --task 0 --check").status, 0);
    EXPECT_EQ(folder.run("batch jobs.json --task 1 --check").status, 1);
    EXPECT_EQ(folder.run("batch jobs.json --task 1").status, 0);
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 0);
    EXPECT_FAILS(folder.run("batch jobs.json --task 2"), 2, "--task: must be from 0 to 1");
    EXPECT_FAILS(folder.run("batch jobs.json --task -1"), 2, "--task: must be from 0 to 1");
    EXPECT_FAILS(folder.run("batch jobs.json --task 0 --list"), 2, "--task");
}

/// Whatever is done to one output, to its input or to its recipe, --check names it and a run makes it, and no other, again.
TEST(Batch, MakesAgainWhatDoesNotVerify)
{
    const BatchFolder folder;
    folder.writeJobs(R"("jobs": [{"command": ["convert", "a.hdr", "-o", "a.exr", "--to", "cube", "--size", "8"]},
                                 {"command": ["convert", "probe.hdr", "-o", "b.exr", "--to", "cube", "--size", "8"]}])");
    const std::function<void()> harms[] = {
        [&] { test::writeBytes(folder / "a.exr", folder.bytes("a.exr").substr(0, 500)); },
        [&] {
            std::string bytes = folder.bytes("a.exr");
            bytes[bytes.size() / 2] ^= 1;
            test::writeBytes(folder / "a.exr", bytes);
        },
        [&] { std::filesystem::remove(folder / "a.exr"); },
        [&] { std::filesystem::remove(folder / "a.exr.recipe.json"); },
        [&] { test::writeBytes(folder / "a.exr.recipe.json", "{"); },
        [&] { folder.run("convert builtin:sky -o a.hdr --to latlong --size 16"); },
        [&] { folder.run("convert builtin:axes -o a.exr --to cube --size 8 --recipe"); }, // a recipe in order, of something else
    };
    size_t harm = 0;
    for (const auto& harmed : harms) {
        folder.run("convert builtin:axes -o a.hdr --to latlong --size 16");
        ASSERT_EQ(folder.run("batch jobs.json").status, 0);
        const std::string good = folder.bytes("a.exr");
        harmed();
        const ProgramRun check = folder.run("batch jobs.json --check");
        EXPECT_EQ(check.status, 1) << harm;
        EXPECT_EQ(linesWith(check.out, "a.exr: "), 1u) << harm << check.out;
        EXPECT_EQ(test::lines(check.out), 1u) << harm << check.out;
        const ProgramRun run = folder.run("batch jobs.json");
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(linesWith(run.out, "made a.exr"), 1u) << harm << run.out;
        EXPECT_EQ(linesWith(run.out, "verified b.exr"), 1u) << harm << run.out;
        EXPECT_EQ(folder.run("batch jobs.json --check").status, 0) << harm;
        EXPECT_EQ(folder.bytes("a.exr") == good, harm != 5) << harm; // there the input is another one
        ++harm;
    }
}

TEST(Batch, MakesAgainWhatOtherSettingsMakeAndOnlyThat)
{
    const BatchFolder folder;
    const auto jobs = [&](const std::string& more) {
        folder.writeJobs(R"("jobs": [{"command": ["convert", "probe.hdr", "-o", "a.exr", "--to", "cube", "--size", "8")" + more + R"(]}])");
    };
    jobs("");
    ASSERT_EQ(folder.run("batch jobs.json").status, 0);
    jobs(R"(, "--threads", "1")"); // threads never change a byte
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 0);
    jobs(R"(, "--yaw", "-30")");
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 1);
    EXPECT_EQ(folder.run("batch jobs.json").status, 0);
    jobs(R"(, "--yaw=-30")"); // the same, spelled otherwise
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 0);
    jobs(R"(, "--yaw", "-30", "--half")");
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 1);
}

/// Every file that a scene leads to is an input: its own, the probe, the sphere map and the mesh, whose buffer lies in a file of its own.
TEST(Batch, CountsEveryFileThatASceneLeadsTo)
{
    const BatchFolder folder;
    folder.run("paint porcelain -o matcap.png --size 16");
    const std::string triangle("\0\0\x80\xbf\0\0\x80\xbf\0\0\0\0\0\0\x80\x3f\0\0\x80\xbf\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0", 36);
    test::writeBytes(folder / "mesh.bin", triangle);
    test::writeBytes(folder / "mesh.gltf",
                     R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                         "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                         "buffers": [{"uri": "mesh.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
                         "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                        "min": [-1, -1, 0], "max": [1, 1, 0]}]})");
    const ProgramRun scene = folder.run("render --probe probe.hdr --geometry mesh.gltf --sphere-map matcap.png --size 8x8 -o scene.png "
                                        "--save-scene s.mirrorball");
    ASSERT_EQ(scene.status, 0) << scene.err;
    folder.writeJobs(R"("jobs": [{"scene": "s.mirrorball", "picture": "s.png"}])");
    ASSERT_EQ(folder.run("batch jobs.json").status, 0);
    ASSERT_EQ(folder.run("batch jobs.json --check").status, 0);
    for (const char* input : {"s.mirrorball", "probe.hdr", "matcap.png", "mesh.gltf", "mesh.bin"}) {
        const std::string good = folder.bytes(input);
        test::writeBytes(folder / input, good + " ");
        const ProgramRun check = folder.run("batch jobs.json --check");
        EXPECT_EQ(check.status, 1) << input;
        EXPECT_THAT(check.out, HasSubstr(std::string(input) + " has changed"));
        test::writeBytes(folder / input, good);
        EXPECT_EQ(folder.run("batch jobs.json --check").status, 0) << input;
    }
}

struct Bad {
    const char* jobs;
    const char* word;
};

TEST(Batch, RefusesABadCommandInOneLineBeforeAnyWork)
{
    const BatchFolder folder;
    constexpr Bad files[] = {
        {R"({"command": ["filtr", "probe.hdr"]})", "jobs[1].command: "},
        {R"({"command": ["convert", "probe.hdr", "-o", "b.exr", "--to", "cube"]})", "jobs[1].command: --size"},
        {R"({"command": ["convert", "probe.hdr", "-o", "b.exr", "--to", "cube", "--size", "0"]})", "jobs[1].command: --size"},
        {R"({"command": ["convert", "probe.hdr", "-o", "b.exr", "--to", "cube", "--size", "8", "--sise", "9"]})", "jobs[1].command: "},
        {R"({"command": ["info", "probe.hdr"]})", "jobs[1].command: 'info' has no -o"},
        {R"({"command": ["convert", "--help"]})", "jobs[1].command: asks for help"},
        {R"({"command": ["batch", "jobs.json"]})", "jobs[1].command: 'batch' has no -o"},
        {R"({"command": ["convert", "probe.hdr", "-o", "./a.exr", "--to", "cube", "--size", "8"]})",
         "a.exr, which jobs[0].command writes, too"},
        {R"({"command": ["convert", "a.exr", "-o", "b.exr", "--to", "cube", "--size", "8"]})", "a.exr, which jobs[0].command makes"},
        {R"({"command": ["convert", "probe.hdr", "-o", "probe.hdr", "--to", "cube", "--size", "8"]})",
         "needs probe.hdr, which jobs[1].command makes"},
        {R"({"command": ["convert", "probe.hdr", "-o", "b#.exr", "--to", "cube", "--size", "{frame}"], "frames": "0-1"})",
         "jobs[1].command for frame 0: --size"},
    };
    for (const Bad& bad : files) {
        folder.writeJobs(R"("jobs": [{"command": ["convert", "probe.hdr", "-o", "a.exr", "--to", "cube", "--size", "8"]}, )" +
                         std::string(bad.jobs) + "]");
        for (const char* how : {"", " --list", " --check", " --task 0", " --template slurm"})
            EXPECT_FAILS(folder.run("batch jobs.json" + std::string(how)), 2, bad.word);
        EXPECT_FALSE(folder.has("a.exr")) << bad.jobs;
    }
    EXPECT_FAILS(folder.run("batch none.json"), 2, "none.json");
    EXPECT_FAILS(folder.run("batch jobs.json --jobs 0"), 2, "--jobs");
    EXPECT_FAILS(folder.run("batch jobs.json --template lsf"), 2, "--template");
    EXPECT_FAILS(folder.run("batch jobs.json --list --check"), 2, "give one of them");
}

TEST(Batch, AFailingCommandDoesNotEndTheOthers)
{
    const BatchFolder folder;
    folder.writeJobs(R"("jobs": [{"command": ["convert", "none.hdr", "-o", "a.exr", "--to", "cube", "--size", "8"]},
                                 {"command": ["convert", "probe.hdr", "-o", "b.exr", "--to", "cube", "--size", "8"]}])");
    const ProgramRun run = folder.run("batch jobs.json");
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("mirrorball: jobs[0].command: none.hdr: there is no such file"));
    EXPECT_THAT(run.err, HasSubstr("mirrorball: jobs.json: 1 of 2 commands failed"));
    EXPECT_EQ(linesWith(run.out, "failed a.exr"), 1u) << run.out;
    EXPECT_EQ(linesWith(run.out, "made b.exr"), 1u) << run.out;
}

/// Seconds of work, for signals to arrive in.
const std::string longJob = R"({"command": ["filter", "builtin:sky", "-o", "long.exr", "--lobe", "phong", "--exponent", "3", "--method",
    "reference", "--to", "latlong", "--size", "512", "--threads", "1"]})";
const std::string shortJob = R"({"command": ["convert", "probe.hdr", "-o", "b.exr", "--to", "cube", "--size", "8"]})";
/// Waits until the batch with number $batch has a child, whose number is then $child.
const std::string awaitChild =
    "for i in $(seq 200); do child=$(cat /proc/$batch/task/$batch/children); [ -n \"$child\" ] && break; sleep 0.05; done; sleep 0.3; ";

TEST(Batch, ACommandThatIsKilledDoesNotEndTheOthers)
{
    const BatchFolder folder;
    folder.writeJobs("\"jobs\": [" + longJob + "," + shortJob + "]");
    const ProgramRun run = folder.shell("$mirrorball batch jobs.json & batch=$!; " + awaitChild + "kill -KILL $child; wait $batch");
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_EQ(linesWith(run.out, "failed long.exr: ended by SIGKILL"), 1u) << run.out;
    EXPECT_EQ(linesWith(run.out, "made b.exr"), 1u) << run.out;
    EXPECT_FALSE(folder.has("long.exr"));
}

TEST(Batch, EndsCleanlyAndWantsToRunAgainWhenItIsStopped)
{
    for (const char* signal : {"TERM", "INT", "HUP"}) {
        const BatchFolder folder;
        folder.writeJobs("\"jobs\": [" + longJob + "," + shortJob + "]");
        // Background jobs of a shell ignore SIGINT unless they have job control.
        const ProgramRun run = folder.shell("set -m; $mirrorball batch jobs.json & batch=$!; " + awaitChild + "kill -" + signal +
                                            " $batch; wait $batch; status=$?; kill -0 $child && echo alive; exit $status");
        EXPECT_EQ(run.status, 75) << signal << run.err << run.out;
        EXPECT_THAT(run.err, HasSubstr(std::string("stopped by SIG") + signal + " with 2 outputs to go"));
        EXPECT_EQ(run.out.find("alive"), std::string::npos) << signal;
        EXPECT_FALSE(folder.has("long.exr") || folder.has("b.exr")) << signal;
        EXPECT_TRUE(folder.leftovers().empty()) << signal << ": " << folder.leftovers().front();
    }
}

/// Four batches at once: each makes whole files, whoever comes last.
TEST(Batch, SeveralAtOnceMakeTheSameFilesAndHarmNothing)
{
    const BatchFolder folder;
    folder.writeJobs(test::threeMaps);
    const ProgramRun run = folder.shell("ids=; for i in 1 2 3 4; do $mirrorball batch jobs.json --jobs 2 & ids=\"$ids $!\"; done; "
                                        "for id in $ids; do wait $id || exit 1; done");
    EXPECT_EQ(run.status, 0) << run.err << run.out;
    EXPECT_EQ(folder.run("batch jobs.json --check").status, 0);
    ASSERT_EQ(folder.run(test::mapCommand(2, "plain.exr")).status, 0);
    EXPECT_EQ(folder.bytes("maps/p2.exr"), folder.bytes("plain.exr"));
    EXPECT_TRUE(folder.leftovers().empty());
}

TEST(Batch, GnuParallelRunsItsTemplate)
{
    const BatchFolder folder;
    if (folder.shell("command -v parallel").status != 0)
        GTEST_SKIP() << "parallel is not installed (tools/packages: pipeline_packages)";
    folder.writeJobs(test::threeMaps);
    std::filesystem::create_directory(folder / "my jobs");
    for (const char* file : {"jobs.json", "probe.hdr"})
        std::filesystem::rename(folder / file, folder / "my jobs" / file);
    const ProgramRun line = folder.run("batch \"my jobs/jobs.json\" --template parallel");
    ASSERT_EQ(line.status, 0) << line.err;
    test::writeBytes(folder / "line.sh", line.out);
    const ProgramRun run = folder.shell("mkdir bin; ln -s $mirrorball bin/mirrorball; PATH=$PWD/bin:$PATH sh -e line.sh");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(folder.run("batch \"my jobs/jobs.json\" --check").status, 0);
}

} // namespace
} // namespace mirrorball
