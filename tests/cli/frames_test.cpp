#include "program.h"

#include "core/image/image_io.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirrorball {
namespace {

using test::mirrorballRuns;
using test::ProgramRun;
using test::TemporaryFolder;

/// A sequence of constant probes 4 x 2 of radiance = frame number, without frame 8.
void writeSequence(const std::filesystem::path& folder)
{
    for (int frame = 7; frame <= 10; ++frame)
        if (frame != 8)
            writeImage(folder / ("probe." + std::string(frame < 10 ? "000" : "00") + std::to_string(frame) + ".exr"),
                       Image(4, 2, 3, static_cast<float>(frame)));
}

float firstValue(const std::filesystem::path& file) { return readImage(file).texels.front(); }

TEST(Frames, EachFrameIsMadeFromItsOwnAndAMissingOneIsNamedWhileTheOthersGoOn)
{
    for (const std::string work : {"convert --to cube --size 4", "filter --lobe phong --exponent 5 --to cube --size 4"}) {
        const TemporaryFolder folder;
        writeSequence(folder.path());
        const size_t space = work.find(' ');
        const ProgramRun run = mirrorballRuns(work.substr(0, space) + " '" + (folder / "probe.####.exr").string() + "'" +
                                              work.substr(space) + " -o '" + (folder / "out.#.exr").string() + "' --frames 7-10");
        EXPECT_EQ(run.status, 1);
        EXPECT_EQ(test::lines(run.err), 2u) << run.err;
        EXPECT_NE(run.err.find("frame 8 is left out"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("probe.0008.exr"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("1 of 4 frames"), std::string::npos) << run.err;
        for (const int frame : {7, 9, 10})
            EXPECT_NEAR(firstValue(folder / ("out." + std::to_string(frame) + ".exr")), static_cast<float>(frame), 1e-3f) << work;
        EXPECT_FALSE(std::filesystem::exists(folder / "out.8.exr"));
    }
}

TEST(Frames, AWholeSequenceLeavesStatusZeroAndTheSameBytesAsFrameByFrame)
{
    const TemporaryFolder folder;
    writeSequence(folder.path());
    const std::string options = " --lobe ggx --roughness 0.4 --to sphere --size 8 -o '";
    EXPECT_EQ(mirrorballRuns("filter '" + (folder / "probe.####.exr").string() + "'" + options + (folder / "a##.exr").string() +
                             "' --frames 9-10")
                  .status,
              0);
    for (const std::string frame : {"09", "10"}) {
        EXPECT_EQ(mirrorballRuns("filter '" + (folder / ("probe.00" + frame + ".exr")).string() + "'" + options +
                                 (folder / "b.exr").string() + "'")
                      .status,
                  0);
        EXPECT_EQ(test::readBytes(folder / ("a" + frame + ".exr")), test::readBytes(folder / "b.exr"));
    }
}

TEST(Frames, AnOutputThatFramesWouldOverwriteAndARangeThatIsNoneAreRefused)
{
    const std::string start = "convert builtin:axes --to cube --size 4 -o /tmp/never";
    EXPECT_FAILS(mirrorballRuns(start + ".exr --frames 1-2"), 2, "####");
    for (const char* range : {"2-1", "x", "1-", "-3", "1-2-3", "0-1000000"})
        EXPECT_FAILS(mirrorballRuns(start + ".#.exr --frames=" + range), 2, "--frames");
}

TEST(Frames, PaintAndRenderAndExportTakeFramesToo)
{
    const TemporaryFolder folder;
    EXPECT_EQ(mirrorballRuns("paint cold-warm --size 8 -o '" + (folder / "p##.png").string() + "' --frames 1-2").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "p01.png") && std::filesystem::exists(folder / "p02.png"));
    EXPECT_FAILS(mirrorballRuns("export scene.mirrorball -o folder --frames 1-2"), 2, "####");
    EXPECT_FAILS(mirrorballRuns("render scene.mirrorball -o picture.png --frames 1-2"), 2, "####");
    EXPECT_FAILS(mirrorballRuns("paint a.spheremap --size 8 -o picture.png --frames 1-2"), 2, "####");
}

} // namespace
} // namespace mirrorball
