#include "program.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// A call of each command that is right but for what is added to it.
std::map<std::string, std::string> rightCalls(const TemporaryFolder& folder)
{
    const std::string out = " -o " + quoted(folder / "out.exr");
    return {{"info", "builtin:axes"},
            {"convert", "builtin:axes --to latlong" + out},
            {"filter", "builtin:axes --to latlong --lobe diffuse" + out},
            {"render", "--probe builtin:axes" + out},
            {"export", quoted(folder / "no.mirrorball") + " -o " + quoted(folder / "maps")},
            {"paint", "silhouette" + out},
            {"presets", ""},
            {"report", "builtin:axes -o " + quoted(folder / "report")}};
}

/// The options of a command that take one number, as its own help lists them.
std::vector<std::string> numericOptions(const std::string& command)
{
    std::vector<std::string> options;
    std::istringstream help(mirrorballRuns(command + " --help").out);
    const std::regex numeric("^ +(?:-[a-z],)?(--[a-z0-9-]+) (?:FLOAT|INT|UINT)(?: |$).*");
    std::smatch found;
    for (std::string line; std::getline(help, line);)
        if (std::regex_match(line, found, numeric))
            options.push_back(found[1]);
    return options;
}

TEST(Options, EveryNumberOfEveryCommandIsCheckedWhereItIsTyped)
{
    const TemporaryFolder folder;
    size_t tried = 0;
    for (const auto& [command, rest] : rightCalls(folder))
        for (const std::string& option : numericOptions(command))
            for (const char* number : {"nan", "-nan", "inf", "-inf", "1e999", "-1e300", "many", "''"}) {
                if (rest.find(option + " ") != std::string::npos)
                    continue;
                const std::string call = command + " " + rest + " " + option + "=" + number;
                const ProgramRun run = mirrorballRuns(call);
                EXPECT_EQ(run.status, 2) << call << "\n" << run.err;
                EXPECT_EQ(test::lines(run.err), 1u) << call << "\n" << run.err;
                EXPECT_NE(run.err.find(option), std::string::npos) << call << "\n" << run.err;
                ++tried;
            }
    EXPECT_GT(tried, 100u) << "the help has changed its form";
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Options, DeepValuesOfSetAreRefusedAsInFiles)
{
    const TemporaryFolder folder;
    const std::string deep(2000, '[');
    const std::string closed = deep + std::string(2000, ']');
    for (const std::string& value : {deep, closed}) {
        const ProgramRun run =
            mirrorballRuns("render --probe builtin:axes -o " + quoted(folder / "x.png") + " --set 'material.lambda=" + value + "'");
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_EQ(test::lines(run.err), 1u);
        EXPECT_NE(run.err.find("material.lambda"), std::string::npos) << run.err;
    }
}

TEST(Options, OutputThatCannotBePrintedIsAnError)
{
    const TemporaryFolder folder;
    const std::string out = " -o " + quoted(folder / "out.exr");
    for (const std::string& call :
         {std::string("info builtin:axes"), std::string("info builtin:axes --json"), std::string("presets"), std::string("presets --json"),
          std::string("--help"), std::string("--version"), "filter builtin:axes --to latlong --size 4 --lobe diffuse --explain" + out})
        for (const char* where : {" >/dev/full", " >&-"}) {
            const std::string errors = (folder / "err").string();
            const int result = std::system((MIRRORBALL_PROGRAM " " + call + where + " 2>" + errors).c_str());
            EXPECT_EQ(WEXITSTATUS(result), 1) << call << where;
            EXPECT_EQ(test::readBytes(errors).find("mirrorball: stdout: cannot be written"), 0u)
                << call << where << test::readBytes(errors);
        }
}

// The number of a closed stream goes to the next file that is opened: what is printed must not end up in a map.
TEST(Options, AClosedStreamIsNotWrittenIntoAFile)
{
    const TemporaryFolder folder;
    const std::string call = " convert builtin:axes --to latlong --size 4 -o ";
    ASSERT_EQ(std::system((MIRRORBALL_PROGRAM + call + quoted(folder / "a.exr")).c_str()), 0);
    std::system((MIRRORBALL_PROGRAM + call + quoted(folder / "b.exr") + " <&- >&- 2>&-").c_str());
    EXPECT_EQ(test::readBytes(folder / "a.exr"), test::readBytes(folder / "b.exr"));
}

TEST(OutputNames, APercentSignIsWrittenTwiceAndNothingIsRenamedInSilence)
{
    const TemporaryFolder folder;
    const std::string convert = "convert builtin:axes --to latlong --size 4 -o ";
    EXPECT_FAILS(mirrorballRuns(convert + quoted(folder / "100%done.exr")), 2, "write %% for a percent sign");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    for (const auto& [typed, made] : {std::pair{"100%%done.exr", "100%done.exr"}, std::pair{"50% gray.exr", "50% gray.exr"},
                                      std::pair{"5%.hdr", "5%.hdr"}, std::pair{"a#1.hdr", "a#1.hdr"}}) {
        ASSERT_EQ(mirrorballRuns(convert + quoted(folder / typed)).status, 0) << typed;
        EXPECT_TRUE(std::filesystem::remove(folder / made)) << typed;
        EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << typed;
    }
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to cube --size 4 --mips -o " + quoted(folder / "%s_%03d.hdr")).status, 0);
    for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
        for (const char* level : {"000", "001", "002"})
            EXPECT_TRUE(std::filesystem::exists(folder / (std::string(face) + "_" + level + ".hdr"))) << face << level;
}

TEST(OutputNames, TwoOutputsOfOneNameAreRefusedBeforeAnyWork)
{
    const TemporaryFolder folder;
    const std::string a = quoted(folder / "a.exr"), same = quoted(folder / "." / "a.exr");
    EXPECT_FAILS(mirrorballRuns("filter builtin:axes --to latlong --size 4 --lobe diffuse -o " + a + " --stats " + same), 2, "--stats");
    EXPECT_FAILS(mirrorballRuns("paint silhouette --size 4 -o " + a + " --save-document " + same), 2, "--save-document");
    EXPECT_FAILS(mirrorballRuns("render --probe builtin:axes -o " + a + " --save-scene " + same), 2, "--save-scene");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Scenes, AreReadAsOtherSystemsWriteThem)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "maps");
    ASSERT_EQ(mirrorballRuns("convert builtin:axes --to latlong --size 4 -o " + quoted(folder / "maps" / "a.hdr")).status, 0);
    const std::string text =
        R"({"version": 1, "probe": {"source": "maps\\a.hdr"}, "exports": [{"name": "m", "kind": "source", "size": 4}]})";
    std::string wide = "\xff\xfe";
    for (const char c : text)
        wide += {c, '\0'};
    for (const std::string& file : {text, "\xef\xbb\xbf" + text, wide}) {
        test::writeBytes(folder / "s.mirrorball", file);
        const ProgramRun run = mirrorballRuns("export " + quoted(folder / "s.mirrorball") + " -o " + quoted(folder / "out"));
        EXPECT_EQ(run.status, 0) << run.err;
    }
    test::writeBytes(folder / "s.mirrorball", wide.substr(0, wide.size() - 1));
    EXPECT_FAILS(mirrorballRuns("export " + quoted(folder / "s.mirrorball") + " -o " + quoted(folder / "out")), 2, "UTF-16");
}

} // namespace
} // namespace mirrorball
