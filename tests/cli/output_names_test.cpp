#include "program.h"

#include "core/image/image_format.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

void writeText(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

/// Every command that writes an image, up to the name of its output. The inputs are not there: whoever looks at them first says so.
const std::vector<std::string> writers{
    "convert missing.exr --to cube --size 8 -o ", "filter missing.exr --lobe diffuse --to cube --size 8 -o ",
    "render --probe missing.exr --size 32x32 -o ", "render missing.mirrorball -o ", "paint missing.spheremap --size 16 -o "};

TEST(OutputNames, AnExtensionThatCannotBeWrittenIsRefusedBeforeAnythingIsOpened)
{
    const TemporaryFolder folder;
    for (const std::string& writer : writers)
        for (const char* name : {"a.foo", "a.pfm", "a", "a%d.gif"})
            EXPECT_FAILS(mirrorballRuns(writer + quoted(folder / name)), 2, "use .exr, .hdr, .tif or .png");
    EXPECT_FAILS(mirrorballRuns("paint missing.spheremap --specular a --size 16 -o " + quoted(folder / "a.png")), 2, ".exr");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(OutputNames, FacesOfAMapThatIsNoCubeAndAMissingFolderAreRefusedBeforeAnythingIsOpened)
{
    const TemporaryFolder folder;
    EXPECT_FAILS(mirrorballRuns("convert missing.exr --to latlong --size 8 -o " + quoted(folder / "%s.exr")), 2, "%s");
    EXPECT_FAILS(mirrorballRuns("paint missing.spheremap --size 8 -o " + quoted(folder / "%s.exr")), 2, "%s");
    for (const std::string& writer : writers)
        EXPECT_FAILS(mirrorballRuns(writer + quoted(folder / "none" / "a.exr")), 1, "create the folder first");
}

TEST(OutputNames, ASceneNamesTheExportThatCannotBeWrittenAndNoFolderIsMade)
{
    const TemporaryFolder folder;
    for (const char* file : {"a.foo", "a.pfm"}) {
        writeText(folder / "s.mirrorball", nlohmann::json{{"version", 1},
                                                          {"probe", {{"source", "missing.exr"}}},
                                                          {"exports", {{{"name", "a"}, {"kind", "specular"}, {"file", file}}}}}
                                               .dump());
        EXPECT_FAILS(mirrorballRuns("export " + quoted(folder / "s.mirrorball") + " -o " + quoted(folder / "out")), 2, "exports[0].file");
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(OutputNames, RenderFilterPaintAndConvertWriteTheSameFormats)
{
    const TemporaryFolder folder;
    for (const ImageFormat& format : imageFormats())
        for (const std::string_view extension : format.write ? format.extensions : std::vector<std::string_view>{}) {
            const std::string name = "a" + std::string(extension);
            for (const std::string command :
                 {"convert builtin:sky --to cube --size 4 -o ", "filter builtin:sky --lobe diffuse --to cube --size 4 -o ",
                  "render --probe builtin:sky --geometry box --size 16x16 -o ", "paint hatching --size 16 -o "}) {
                const test::ProgramRun run = mirrorballRuns(command + quoted(folder / name));
                EXPECT_EQ(run.status, 0) << command << name << ": " << run.err;
                EXPECT_TRUE(std::filesystem::remove(folder / name)) << command << name;
            }
        }
}

} // namespace
} // namespace mirrorball
