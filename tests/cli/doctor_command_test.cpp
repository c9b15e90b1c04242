#include "program.h"

#include "core/engine/roughness_law.h"
#include "core/filter/prefilter.h"
#include "core/image/builtin_probes.h"
#include "core/image/container/dds.h"
#include "core/image/container/ktx1.h"
#include "core/image/map_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// Filament's chain of a built-in probe: cubes of 64 to 4 in our convention.
std::vector<EnvironmentMap> chain()
{
    FilterSource source(renderBuiltinProbe("axes", {Parameterization::Latlong, 256, 0}));
    std::vector<EnvironmentMap> levels;
    for (int l = 0; l < 5; ++l) {
        const double r = levelRoughness(RoughnessLaw::Filament, l, 5, 64);
        levels.push_back(
            prefilter(source, {.lobe = ggxLobe(r * r), .target = {Parameterization::Cube, 64 >> l, 0}, .tolerance = 1e-4}).map);
    }
    return levels;
}

nlohmann::json examined(const std::string& map, const std::string& options = "--probe builtin:axes")
{
    const ProgramRun run = mirrorballRuns("doctor " + map + " " + options + " --json");
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out);
}

/// What does not depend on where the texels came from.
nlohmann::json verdictOf(nlohmann::json record)
{
    for (const char* field : {"map", "container", "texels"})
        record.erase(field);
    return record;
}

TEST(DoctorCommand, GivesTheSameVerdictWhateverTheFilesAre)
{
    const TemporaryFolder folder;
    const std::vector<EnvironmentMap> levels = chain();
    Texture texture{.format = TexelFormat::Float};
    for (size_t l = 0; l < levels.size(); ++l) {
        texture.levels.push_back(levels[l].image);
        const std::string number = std::to_string(l);
        writeMap(folder / ("face_%s_" + number + ".exr"), {levels[l]});
        writeImage(folder / ("strip_" + number + ".exr"), levels[l].image);
    }
    test::writeBytes(folder / "light.ktx", ktx1::write(texture));
    test::writeBytes(folder / "light.dds", dds::write(texture));

    const nlohmann::json contained = examined(quoted(folder / "light.ktx"));
    EXPECT_EQ(contained.at("verdict"), "clean") << contained.dump(1);
    EXPECT_EQ(contained.at("container"), "ktx");
    EXPECT_EQ(contained.at("law"), "filament");
    EXPECT_EQ(contained.at("orientation").at("is"), "not mirrored");
    EXPECT_EQ(contained.at("engines"), nlohmann::json::array({"Filament"}));
    for (const char* name : {"light.dds", "face_%s_%d.exr", "strip_%d.exr"})
        EXPECT_EQ(verdictOf(examined(quoted(folder / name))), verdictOf(contained)) << name;
}

TEST(DoctorCommand, SaysInWordsWhatTheMapIsAndHowCertainly)
{
    const TemporaryFolder folder;
    writeMap(folder / "chain_%d.exr", chain());
    const ProgramRun known = mirrorballRuns("doctor " + quoted(folder / "chain_%d.exr") + " --probe builtin:axes");
    EXPECT_EQ(known.status, 0) << known.err;
    for (const char* words : {"cube of 64, 5 levels", "not mirrored", "r = 1 - sqrt(1 - l/4)", "Filament", "verdict: no fault found"})
        EXPECT_NE(known.out.find(words), std::string::npos) << words << "\n" << known.out;

    const nlohmann::json alone = examined(quoted(folder / "chain_%d.exr"), "");
    EXPECT_EQ(alone.at("with_probe"), false);
    EXPECT_TRUE(alone.at("orientation").is_null());
    EXPECT_EQ(alone.at("law"), "filament");

    // Another probe's map is told from this one's.
    const nlohmann::json other = examined(quoted(folder / "chain_%d.exr"), "--probe builtin:cube-room");
    EXPECT_NE(other.at("verdict"), "clean") << other.dump(1);
}

TEST(DoctorCommand, ReadsPackedFacesAsItReadsFloats)
{
    const TemporaryFolder folder;
    const std::vector<EnvironmentMap> levels = chain();
    for (size_t l = 0; l < levels.size(); ++l)
        for (const auto& [form, word] : {std::pair{ByteEncoding::Rgbm, "rgbm"}, {ByteEncoding::Rgbd, "rgbd"}, {ByteEncoding::Rgbe, "rgbe"}})
            writeMap(folder / (word + std::string("_%s_") + std::to_string(l) + ".png"), {levels[l]}, {.bytes = form});
    for (const std::string word : {"rgbm", "rgbd", "rgbe"}) {
        const nlohmann::json packed = examined(quoted(folder / (word + "_%s_%d.png")), "--probe builtin:axes --encode " + word);
        EXPECT_EQ(packed.at("verdict"), "clean") << packed.dump(1);
        EXPECT_EQ(packed.at("texels"), word);
        EXPECT_EQ(packed.at("law"), "filament");
        EXPECT_EQ(packed.at("engines"), nlohmann::json::array({"Filament"}));
        EXPECT_NEAR(packed.at("scale").get<double>(), 1.0, 0.01) << word;
    }
    // Taken for another form it is none of ours.
    EXPECT_NE(examined(quoted(folder / "rgbd_%s_%d.png"), "--probe builtin:axes --encode rgbm").at("verdict"), "clean");
}

TEST(DoctorCommand, ReadsPlayCanvasAtlas)
{
    const TemporaryFolder folder;
    for (const std::string form : {"rgbp", "rgbm"}) {
        const ProgramRun made =
            mirrorballRuns("export --probe builtin:axes --for playcanvas --name light -o " + quoted(folder / form) + " --encode " + form);
        ASSERT_EQ(made.status, 0) << made.err;
        std::string atlas;
        for (const auto& entry : std::filesystem::directory_iterator(folder / form))
            if (entry.path().extension() == ".png")
                atlas = entry.path().string();
        const nlohmann::json record = examined("'" + atlas + "'", "--probe builtin:axes --encode " + form);
        EXPECT_EQ(record.at("verdict"), "clean") << record.dump(1);
        EXPECT_EQ(record.at("container"), "playcanvas atlas");
        EXPECT_EQ(record.at("law"), "playcanvas");
        EXPECT_EQ(record.at("orientation").at("is"), "not mirrored");
        EXPECT_EQ(record.at("engines"), nlohmann::json::array({"PlayCanvas"}));
        EXPECT_EQ(record.at("levels").size(), 7u) << "with the diffuse light";
        EXPECT_FAILS(mirrorballRuns("doctor '" + atlas + "' --encode rgbx"), 2, "--encode");
    }
}

TEST(DoctorCommand, RefusesWhatIsNoMapInOneLine)
{
    const TemporaryFolder folder;
    EXPECT_FAILS(mirrorballRuns("doctor " + quoted(folder / "none.ktx")), 2, "none.ktx");
    EXPECT_FAILS(mirrorballRuns("doctor " + quoted(folder / "none_%s_%d.exr")), 2, "no such files");
    test::writeBytes(folder / "cut.ktx", std::string("\xABKTX 11\xBB\r\n\x1A\n", 12) + std::string(20, '\1'));
    EXPECT_FAILS(mirrorballRuns("doctor " + quoted(folder / "cut.ktx")), 2, "cut.ktx");
    writeImage(folder / "f_px.exr", Image(4, 4, 3, 1.0f));
    for (const char* face : {"nx", "py", "ny", "pz", "nz"})
        writeImage(folder / (std::string("f_") + face + ".exr"), Image(4, 3, 3, 1.0f));
    EXPECT_FAILS(mirrorballRuns("doctor " + quoted(folder / "f_%s.exr")), 2, "f_nx.exr");
    writeImage(folder / "odd.exr", Image(7, 3, 3, 1.0f));
    EXPECT_FAILS(mirrorballRuns("doctor " + quoted(folder / "odd.exr")), 2, "odd.exr");
}

} // namespace
} // namespace mirrorball
