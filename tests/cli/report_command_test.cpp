#include "program.h"

#include "core/image/image_io.h"
#include "support/probe_builders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

nlohmann::json parsed(const std::filesystem::path& path) { return nlohmann::json::parse(test::readBytes(path)); }

std::set<std::string> filesIn(const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename());
    return names;
}

TEST(ReportCommand, WritesPageJsonAndTables)
{
    const TemporaryFolder folder;
    writeImage(folder / "noise probe.exr", test::noiseProbe(32, 3).image);
    const ProgramRun run =
        mirrorballRuns("report " + quoted(folder / "noise probe.exr") + " builtin:studio -o " + quoted(folder / "out") +
                       " --quick --size 8 --lobes phong:20,diffuse --methods spectral,auto,mip,reference --directions 16 --longest 60");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err.rfind("mirrorball: report: takes about ", 0), 0u) << run.err;
    EXPECT_EQ(test::lines(run.err), 1u) << run.err;
    EXPECT_EQ(test::lines(run.out), 4u) << run.out;
    EXPECT_EQ(filesIn(folder / "out"), (std::set<std::string>{"report.html", "report.json", "measurements.csv", "parameterizations.csv"}));
    const nlohmann::json report = parsed(folder / "out" / "report.json");
    EXPECT_TRUE(report.at("complete").get<bool>());
    EXPECT_NE(report.at("command").get<std::string>().find("--lobes phong:20,diffuse"), std::string::npos);
    ASSERT_EQ(report.at("cases").size(), 4u); // two probes with two lobes
    for (const auto& c : report.at("cases"))
        for (const auto& m : c.at("measurements"))
            if (m.at("method") == "spectral" && m.at("setting") == "tolerance 1e-5") {
                EXPECT_LE(m.at("rel_rms").get<double>(), 1e-5);
                EXPECT_GT(m.at("seconds").at("median").get<double>(), 0.0);
            }
    EXPECT_FALSE(report.at("conclusions").empty());
    EXPECT_GT(report.at("machine").at("cores").get<int>(), 0);
    EXPECT_EQ(report.at("verdicts").size(), 4u);
}

TEST(ReportCommand, MakesThePapersTableAndFiguresByOneCommandEach)
{
    const TemporaryFolder folder;
    writeImage(folder / "probe.exr", test::noiseProbe(32, 3).image);
    const auto report = [&](const std::string& words, const char* out) {
        const ProgramRun run = mirrorballRuns("report " + words + " -o " + quoted(folder / out));
        EXPECT_EQ(run.status, 0) << run.err;
        return filesIn(folder / out);
    };
    EXPECT_EQ(report("--parts distortion", "d"), (std::set<std::string>{"report.html", "report.json", "distortion.csv"}));
    EXPECT_EQ(report(quoted(folder / "probe.exr") + " --parts kernels --quick", "k"),
              (std::set<std::string>{"report.html", "report.json", "kernels.csv"}));
    const nlohmann::json row = parsed(folder / "k" / "report.json").at("kernels").at("rows").at(0);
    EXPECT_EQ(row.at("sizes"), row.at("published_sizes"));
    EXPECT_GT(row.at("blended_seconds").get<double>(), 0.0);
    EXPECT_EQ(report(quoted(folder / "probe.exr") + " --parts comparison", "c"),
              (std::set<std::string>{"report.html", "report.json", "comparison_unfiltered.png", "comparison_classic.png",
                                     "comparison_hierarchical.png", "comparison_hardware.png"}));
    EXPECT_EQ(readImage(folder / "c" / "comparison_hardware.png").width, 256);
}

TEST(ReportCommand, TheCommandItRecordsMakesTheMapItMeasured)
{
    const TemporaryFolder folder;
    writeImage(folder / "probe.exr", test::noiseProbe(32, 3).image);
    ASSERT_EQ(mirrorballRuns("report " + quoted(folder / "probe.exr") + " -o " + quoted(folder / "out") +
                             " --quick --size 8 --lobes ggx:0.5 --methods spectral --longest 60")
                  .status,
              0);
    std::string command = parsed(folder / "out" / "report.json").at("cases").at(0).at("measurements").at(0).at("command");
    ASSERT_TRUE(command.starts_with("mirrorball filter "));
    command = command.substr(std::string("mirrorball ").size());
    const size_t out = command.find("map.exr");
    ASSERT_NE(out, std::string::npos);
    command.replace(out, 7, (folder / "map.exr").string());
    ASSERT_EQ(mirrorballRuns(command).status, 0) << command;
    EXPECT_EQ(readImage(folder / "map.exr").width, 8);
}

TEST(ReportCommand, RefusesWrongWordsInOneLine)
{
    const TemporaryFolder folder;
    const std::string out = " -o " + quoted(folder / "out");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky" + out + " --lobes phong:x"), 2, "--lobes");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky" + out + " --methods spectral,magic"), 2, "magic");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky" + out + " --size 0"), 2, "size");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky" + out + " --parts methods,magic"), 2, "--parts");
    EXPECT_FAILS(mirrorballRuns("report" + out), 2, "PROBE");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky" + out + " --repeats 0"), 2, "repeats");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky" + out + " --growth-to 100"), 2, "growth-to");
    EXPECT_FAILS(mirrorballRuns("report builtin:nothing" + out), 2, "nothing");
    EXPECT_FAILS(mirrorballRuns("report " + quoted(folder / "missing.hdr") + out), 2, "missing.hdr");
    test::writeBytes(folder / "file", "x");
    EXPECT_FAILS(mirrorballRuns("report builtin:sky -o " + quoted(folder / "file" / "deeper")), 2, "is no folder");
    EXPECT_FALSE(std::filesystem::exists(folder / "out")); // nothing half written
}

/// Whether a process holds SIGINT back for its own use: from then on a Ctrl-C is a request.
bool awaitsInterrupt(pid_t process)
{
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("SigBlk:"))
            return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
    return false;
}

TEST(ReportCommand, CtrlCLeavesAValidPartialReport)
{
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string(), err = (folder / "err").string();
    // The growth of cost up to 16384 columns takes a minute and more, after cases that take a moment.
    const pid_t process = fork();
    if (process == 0) {
        const int file = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
        dup2(file, STDERR_FILENO);
        dup2(file, STDOUT_FILENO);
        execl(MIRRORBALL_PROGRAM, "mirrorball", "report", "builtin:studio", "-o", out.c_str(), "--quick", "--lobes", "phong:50", "--size",
              "8", "--directions", "16", "--methods", "spectral,auto", "--growth-to", "16384", "--longest", "60", nullptr);
        _exit(127);
    }
    ASSERT_GT(process, 0);
    for (int i = 0; i < 3000 && !awaitsInterrupt(process); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    kill(process, SIGINT);
    int status = 0;
    waitpid(process, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "it died of the signal";
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_NE(test::readBytes(err).find("mirrorball: stopped: "), std::string::npos) << test::readBytes(err);
    const nlohmann::json report = parsed(folder / "out" / "report.json");
    EXPECT_FALSE(report.at("complete").get<bool>());
    for (const char* file : {"report.html", "report.json", "measurements.csv"})
        EXPECT_TRUE(filesIn(out).contains(file)) << file;
    const std::string page = test::readBytes(folder / "out" / "report.html");
    EXPECT_NE(page.find("</html>"), std::string::npos);
}

} // namespace
} // namespace mirrorball
