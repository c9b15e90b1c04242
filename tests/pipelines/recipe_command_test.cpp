#include "batch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

namespace mirrorball {
namespace {

using test::BatchFolder;
using test::ProgramRun;
using testing::HasSubstr;

struct Case {
    const char* command;
    const char* output; ///< of which the recipe is asked for
};

/// All commands that have an output, in an order in which each finds what it reads. Those of reports differ: they hold times.
constexpr Case cases[] = {
    {"filter probe.hdr -o a.exr --lobe ggx --mips --to cube --size 8 --tolerance 1e-3 --yaw -20 --half", "a.exr"},
    {"convert \"it is.hdr\" --output \"b c.hdr\" --to latlong --size 8", "b c.hdr"},
    {"convert probe.hdr -o f_%s.exr --to cube --size 8 --threads 1", "f_ny.exr"},
    {"filter probe.hdr -o lod%d.png --law three --levels 3 --to cube --size 8 --encode rgbm", "lod1.png"},
    {"render s.mirrorball -o b.png --set material.lambda=2 --set view.exposure=1", "b.png"},
    {"export probe.hdr --for filament --size 32 -o game", "game"},
    {"paint porcelain -o p.png --size 16 --levels", "p.1.png"},
    {"brdf ward:alpha=0.3 --table albedo -o t.exr", "t.exr"},
    {"filter probe.hdr --brdf ggx:alpha=0.3 --view 30 -o r.exr --to latlong --size 8", "r.exr"},
    {"render --probe probe.hdr --material car-paint --geometry torus --size 16x16 -o c.exr --save-scene t.mirrorball", "t.mirrorball"},
    {"export e.mirrorball -o exports", "exports/m.json"},
    {"spectrum probe.hdr --degree 30 --rows 0:7 -o a.spectrum", "a.spectrum"},
    {"spectrum probe.hdr --degree 30 --rows 7:16 -o b.spectrum", "b.spectrum"},
    {"spectrum --add a.spectrum b.spectrum -o whole.spectrum", "whole.spectrum"},
    {"filter whole.spectrum -o w.exr --lobe phong --exponent 3 --to cube --size 8 --tolerance 1e-2", "w.exr"},
};

/// A folder with what the cases read.
void prepare(const BatchFolder& folder)
{
    folder.run("render --probe probe.hdr --geometry sphere --size 16x16 -o a.png --save-scene s.mirrorball --set exports=[]");
    test::writeBytes(folder / "e.mirrorball",
                     R"({"version": 1, "probe": {"source": "probe.hdr"}, "exports": [{"name": "m", "kind": "specular", "size": 8}]})");
    std::filesystem::copy_file(folder / "probe.hdr", folder / "it is.hdr");
}

/// What the printed line makes, run by a shell in some other folder, is the same file to the byte.
TEST(Recipe, PrintsALineThatMakesTheOutputAgain)
{
    const BatchFolder folder;
    prepare(folder);
    for (const Case& each : cases) {
        const ProgramRun made = folder.run(std::string(each.command) + " --recipe");
        ASSERT_EQ(made.status, 0) << each.command << made.err;
        const std::string name = std::string("\"") + each.output + "\"";
        const ProgramRun recipe = folder.shell("cd / && $mirrorball recipe \"$OLDPWD\"/" + name);
        ASSERT_EQ(recipe.status, 0) << recipe.err;
        EXPECT_EQ(recipe.err, "") << each.command;
        EXPECT_EQ(recipe.out.find("--recipe"), std::string::npos);
        EXPECT_EQ(recipe.out.find("--threads"), std::string::npos);
        test::writeBytes(folder / "again.sh", "set -e\n" + recipe.out);
        const ProgramRun again = folder.shell(
            "mkdir -p bin && ln -sf $mirrorball bin/mirrorball && cp -r " + name + " kept && rm -r " + name +
            " && cd / && PATH=\"$OLDPWD\"/bin:$PATH sh \"$OLDPWD\"/again.sh && cd \"$OLDPWD\" && diff -r kept " + name + " && rm -r kept");
        EXPECT_EQ(again.status, 0) << each.command << "\n" << recipe.out << again.out << again.err;
    }
}

/// As `--help` lists them: a command that gets an output is missed here until it has a case.
TEST(Recipe, IsOfEveryCommandThatHasAnOutput)
{
    const BatchFolder folder;
    std::istringstream help(folder.run("--help").out);
    std::set<std::string> commands, tried{"report"};
    bool inList = false;
    for (std::string line; std::getline(help, line);) {
        inList = (inList || line.starts_with("Subcommands:")) && !line.empty();
        std::istringstream words(line);
        std::string name;
        if (inList && line.starts_with("  ") && line[2] != ' ' && words >> name &&
            folder.run(name + " --help").out.find("--output") != std::string::npos)
            commands.insert(name);
    }
    for (const Case& each : cases)
        tried.insert(std::string(each.command).substr(0, std::string(each.command).find(' ')));
    EXPECT_GE(commands.size(), 8u);
    EXPECT_EQ(commands, tried);

    const ProgramRun report = folder.run("report probe.hdr -o report --quick --lobes phong:5 --methods mip --size 8 --recipe");
    ASSERT_EQ(report.status, 0) << report.err;
    const ProgramRun recipe = folder.run("recipe report/report.html");
    EXPECT_EQ(recipe.out, "mirrorball report probe.hdr --output report --lobes phong:5 --methods mip --size 8 --quick\n") << recipe.err;
    EXPECT_EQ(recipe.err, "");
}

/// The hash is that of the file's own words: version, command, and names and content of what was read.
TEST(Recipe, HashesWhatTheOutputFollowsFrom)
{
    const BatchFolder folder;
    prepare(folder);
    for (const Case& each : cases) {
        const std::string words(each.command);
        ASSERT_EQ(folder.run(words + " --recipe").status, 0) << words;
        std::vector<std::filesystem::path> recipes;
        for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
            if (entry.path().string().ends_with(".recipe.json"))
                recipes.push_back(entry.path());
        ASSERT_EQ(recipes.size(), 1u) << words;
        const auto json = nlohmann::ordered_json::parse(test::readBytes(recipes.front()));
        nlohmann::ordered_json all{{"version", json["version"]}, {"command", json["command"]}, {"inputs", nlohmann::ordered_json::array()}};
        for (const auto& input : json["inputs"]) {
            EXPECT_TRUE(folder.has(input["file"])) << words;
            all["inputs"].push_back({input["file"], input["sha256"]});
        }
        test::writeBytes(folder / "hashed", all.dump());
        EXPECT_EQ(folder.shell("sha256sum <hashed").out, json["recipe"].get<std::string>() + "  -\n") << words;
        const bool readsNothing = words.starts_with("paint") || words.starts_with("brdf");
        EXPECT_EQ(json["inputs"].empty(), readsNothing) << words;
        std::filesystem::remove(recipes.front());
    }
}

/// A configuration of OpenColorIO names its tables; both decide what comes out, whether it reads a file or shows a picture.
TEST(Recipe, NamesAnOpenColorIoConfigurationAndTheTablesThatItReads)
{
    const BatchFolder folder;
    const std::string table = "Version 1\nFrom 0.0 1.0\nLength 2\nComponents 1\n{\n0.0\n%\n}\n";
    const auto writeTable = [&](const std::string& name, const std::string& top) {
        test::writeBytes(folder / name, std::string(table).replace(table.find('%'), 1, top));
    };
    writeTable("camera.spi1d", "0.5");
    writeTable("screen.spi1d", "0.8");
    writeTable("unused.spi1d", "1.0");
    test::writeBytes(folder / "c.ocio",
                     "ocio_profile_version: 2\nroles:\n  default: lin_rec709\n  scene_linear: lin_rec709\nfile_rules:\n"
                     "  - !<Rule> {name: Default, colorspace: default}\ndisplays:\n  d:\n    - !<View> {name: v, colorspace: screen}\n"
                     "colorspaces:\n  - !<ColorSpace>\n    name: lin_rec709\n"
                     "  - !<ColorSpace>\n    name: camera\n    to_scene_reference: !<FileTransform> {src: camera.spi1d}\n"
                     "  - !<ColorSpace>\n    name: unused\n    to_scene_reference: !<FileTransform> {src: unused.spi1d}\n"
                     "  - !<ColorSpace>\n    name: screen\n    from_scene_reference: !<FileTransform> {src: screen.spi1d}\n");
    ASSERT_EQ(folder.shell("OCIO=c.ocio $mirrorball convert probe.hdr -o a.exr --to cube --size 8 --color-space camera --recipe").status,
              0);
    ASSERT_EQ(
        folder.run("render --probe probe.hdr --geometry sphere --size 16x16 -o b.png --set view.display.config=c.ocio --recipe").status, 0);
    const auto inputs = [&](const std::string& recipe) {
        std::set<std::string> names;
        const nlohmann::json json = nlohmann::json::parse(folder.bytes(recipe));
        for (const auto& input : json["inputs"])
            names.insert(input["file"].get<std::string>());
        return names;
    };
    EXPECT_EQ(inputs("a.exr.recipe.json"), (std::set<std::string>{"c.ocio", "camera.spi1d", "probe.hdr"}));
    EXPECT_EQ(inputs("b.png.recipe.json"), (std::set<std::string>{"c.ocio", "probe.hdr", "screen.spi1d"}));
    writeTable("camera.spi1d", "0.6");
    EXPECT_THAT(folder.run("recipe a.exr").err, HasSubstr("does not verify, because camera.spi1d has changed"));
    EXPECT_EQ(folder.run("recipe b.png").err, "");
}

TEST(Recipe, SaysWhenAFileIsNoLongerWhatItMade)
{
    const BatchFolder folder;
    ASSERT_EQ(folder.run("convert probe.hdr -o a.exr --to cube --size 8 --recipe").status, 0);
    const ProgramRun good = folder.run("recipe a.exr");
    EXPECT_EQ(good.out, "mirrorball convert probe.hdr --output a.exr --to cube --size 8\n");
    EXPECT_EQ(good.err, "");
    test::writeBytes(folder / "a.exr", "x");
    const ProgramRun edited = folder.run("recipe a.exr");
    EXPECT_EQ(edited.status, 0);
    EXPECT_EQ(edited.out, good.out);
    EXPECT_THAT(edited.err, HasSubstr("a.exr: does not verify, because a.exr has changed"));
    EXPECT_FAILS(folder.run("recipe probe.hdr"), 2, "probe.hdr: has no recipe");
    EXPECT_FAILS(folder.run("recipe none.exr"), 2, "none.exr: does not exist");
}

TEST(Recipe, NamesVersionInputsAndOutputs)
{
    const BatchFolder folder;
    ASSERT_EQ(folder.run("convert probe.hdr -o out.exr --to cube --size 8 --recipe").status, 0);
    const auto json = nlohmann::json::parse(folder.bytes("out.exr.recipe.json"));
    EXPECT_EQ(json["mirrorball_recipe"], 1);
    EXPECT_EQ(json["version"].get<std::string>() + "\n", folder.run("--version").out);
    // coreutils' sha256sum, which shares no code with ours
    for (const char* list : {"inputs", "outputs"})
        for (const auto& file : json[list])
            EXPECT_EQ(folder.shell("sha256sum <" + file["file"].get<std::string>()).out, file["sha256"].get<std::string>() + "  -\n");
    EXPECT_EQ(json["inputs"].size(), 1u);
    EXPECT_EQ(json["outputs"].size(), 1u);
    EXPECT_EQ(json["inputs"][0]["bytes"], std::filesystem::file_size(folder / "probe.hdr"));
}

TEST(Recipe, IsNotWrittenWhereItWouldNotBeTrue)
{
    const BatchFolder folder;
    EXPECT_FAILS(folder.run("convert probe.hdr -o probe.hdr --to latlong --size 8 --recipe"), 1, "is read and written by one command");
    EXPECT_FALSE(folder.has("probe.hdr.recipe.json"));
    EXPECT_FAILS(folder.run("convert none.hdr -o b.hdr --to latlong --size 8 --recipe"), 2, "none.hdr");
    EXPECT_FALSE(folder.has("b.hdr.recipe.json"));
}

} // namespace
} // namespace mirrorball
