#include "program.h"

#include "core/image/image_io.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// A scene whose probe does not exist, with a sphere map and these exports.
std::string writeScene(const TemporaryFolder& folder, const std::string& sphereMap, const std::string& exports)
{
    std::ofstream(folder / "s.mirrorball") << R"({"version": 1, "probe": {"source": "gone.exr"}, "material": {"sphere_map": )" << sphereMap
                                           << R"(}, "exports": [)" << exports << "]}";
    return "export " + quoted(folder / "s.mirrorball") + " -o " + quoted(folder / "maps");
}

nlohmann::json readJson(const std::filesystem::path& path)
{
    std::ifstream file(path);
    return nlohmann::json::parse(file);
}

TEST(PaintedExport, WritesTheBytesOfPaintWithoutTheProbe)
{
    const TemporaryFolder folder;
    const std::string maps = writeScene(folder, R"({"source": "silhouette"})",
                                        R"({"name": "matcap", "kind": "painted", "size": 64, "file": "matcap.png"},
                                           {"name": "blender", "kind": "painted", "size": 64, "border": 2, "half": true},
                                           {"name": "chain", "kind": "painted", "size": 64, "mips": true},
                                           {"name": "files", "kind": "painted", "size": 8, "mips": true, "file": "f_%d.exr"},
                                           {"name": "pictures", "kind": "painted", "size": 4, "mips": true, "file": "p.png"})");
    const ProgramRun run = mirrorballRuns(maps + " --explain --stats " + quoted(folder / "stats.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE((run.out + run.err).find("silhouette, 64 x 64, authored levels"), std::string::npos) << run.out << run.err;
    EXPECT_NE((run.out + run.err).find("silhouette, 64 x 64 with a border of 2, one level"), std::string::npos) << run.out << run.err;
    const nlohmann::json stats = readJson(folder / "stats.json");
    EXPECT_EQ(stats["method"], "paint");

    const auto sameAs = [&](const char* options, const char* painted, const char* exported) {
        ASSERT_EQ(mirrorballRuns("paint silhouette " + std::string(options) + " -o " + quoted(folder / painted)).status, 0);
        std::string first = painted;
        if (const size_t mark = first.find("%d"); mark != std::string::npos)
            first.replace(mark, 2, "0");
        const std::string bytes = test::readBytes(folder / first);
        EXPECT_FALSE(bytes.empty());
        EXPECT_TRUE(bytes == test::readBytes(folder / "maps" / exported)) << exported;
    };
    sameAs("--size 64", "m.png", "matcap.png");
    sameAs("--size 64 --border 2 --half", "b.exr", "blender.exr");
    sameAs("--size 64 --levels", "c.exr", "chain.exr");
    sameAs("--size 8 --levels", "f_%d.exr", "f_0.exr");
    for (const char* file : {"f_1.exr", "f_2.exr", "f_3.exr", "p.0.png", "p.1.png", "p.2.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / "maps" / file)) << file;

    const nlohmann::json chain = readJson(folder / "maps" / "chain.json"), matcap = readJson(folder / "maps" / "matcap.json");
    EXPECT_EQ(chain["indexed_by"], "normal");
    EXPECT_EQ(chain["level_rule"].get<std::string>().rfind("authored", 0), 0u);
    EXPECT_EQ(chain["levels"].size(), 7u);
    EXPECT_EQ(matcap["level_rule"], "one level");
    EXPECT_EQ(matcap["color_space"], "sRGB, clipped to 0..1");
    EXPECT_EQ(readJson(folder / "maps" / "files.json")["files"], nlohmann::json({"f_0.exr", "f_1.exr", "f_2.exr", "f_3.exr"}));
}

TEST(PaintedExport, TakesEmbeddedMapsAndFilesAndPictures)
{
    const TemporaryFolder folder;
    ASSERT_EQ(
        mirrorballRuns("paint jade -o " + quoted(folder / "j.exr") + " --size 16 --save-document " + quoted(folder / "j.spheremap")).status,
        0);
    const std::string target = R"({"name": "m", "kind": "painted", "size": 16})";
    const auto exported = [&](const std::string& sphereMap) {
        const ProgramRun run = mirrorballRuns(writeScene(folder, sphereMap, target));
        EXPECT_EQ(run.status, 0) << run.err;
        return readImage(folder / "maps" / "m.exr");
    };
    const Image expected = readImage(folder / "j.exr");
    EXPECT_EQ(exported(R"({"source": "j.spheremap"})"), expected);
    const Image picture = exported(R"({"source": "j.exr"})"); // outside the disc the rim's color goes on
    EXPECT_EQ(picture.texel(8, 8)[1], expected.texel(8, 8)[1]);
    EXPECT_EQ(picture.texel(4, 10)[0], expected.texel(4, 10)[0]);
    const std::string document =
        R"({"document": {"version": 1, "index": "reflection", "layers": [{"content": {"kind": "fill", "color": [0.25, 0.5, 1]}}]}})";
    EXPECT_EQ(exported(document).texel(3, 3)[1], 0.5f);
    EXPECT_EQ(readJson(folder / "maps" / "m.json")["indexed_by"], "reflection");
}

TEST(PaintedExport, SaysInOneLineWhatIsMissing)
{
    const TemporaryFolder folder;
    const std::string map = R"({"source": "jade"})";
    EXPECT_FAILS(mirrorballRuns(writeScene(folder, "{}", R"({"name": "m", "kind": "painted"})")), 2, "exports[0].kind");
    EXPECT_FAILS(mirrorballRuns(writeScene(folder, map, R"({"name": "m", "kind": "painted", "size": 8, "border": 4})")), 2,
                 "exports[0].border");
    EXPECT_FAILS(mirrorballRuns(writeScene(folder, map, R"({"name": "m", "kind": "painted", "border": 2, "mips": true})")), 2,
                 "exports[0].border");
    EXPECT_FAILS(mirrorballRuns(writeScene(folder, map, R"({"name": "m", "kind": "painted", "size": 9000})")), 2, "exports[0].size");
    EXPECT_FAILS(mirrorballRuns(writeScene(folder, map, R"({"name": "m", "kind": "painted", "file": "a_%s.exr"})")), 2, "%d");
    EXPECT_FAILS(mirrorballRuns(writeScene(folder, R"({"source": "mona-lisa"})", R"({"name": "m", "kind": "painted"})")), 2, "mona-lisa");
    EXPECT_TRUE(!std::filesystem::exists(folder / "maps") || std::filesystem::is_empty(folder / "maps"));
    // The export that needs no sphere map is made where it alone is asked for.
    std::ofstream(folder / "t.mirrorball")
        << R"({"version": 1, "exports": [{"name": "m", "kind": "painted"}, {"name": "e", "kind": "source", "size": 8}]})";
    EXPECT_EQ(mirrorballRuns("export " + quoted(folder / "t.mirrorball") + " -o " + quoted(folder / "maps") + " --only e").status, 0);
}

} // namespace
} // namespace mirrorball
