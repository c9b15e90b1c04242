#include "core/spheremap/strokes/stroke_file.h"

#include "core/base/error.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "support/stroke_builders.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include <sys/stat.h>

namespace mirrorball {
namespace {

class StrokeFile : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& text) const
    {
        const std::filesystem::path path = m_folder / "test.strokes";
        std::ofstream(path) << text;
        return path;
    }
    /// What loading says, without the file's name.
    std::string refusal(const std::string& text) const
    {
        const std::filesystem::path path = write(text);
        try {
            loadStrokes(path);
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            return message.substr(path.string().size() + 2);
        }
        return {};
    }
    std::string refusalOfStroke(const std::string& stroke) const { return refusal("{\"version\": 1, \"strokes\": [" + stroke + "]}"); }

    test::TemporaryFolder m_folder;
};

TEST_F(StrokeFile, SurvivesARoundTripToTheLastBit)
{
    std::vector<Stroke> strokes = handDrawnStrokes(20, 6, 0.05, 0.4, 20);
    strokes[3].symmetry = {.radial = 6, .mirror = true, .axisDeg = 30.0};
    strokes[4].points.clear();
    saveStrokes(strokes, m_folder / "a.strokes");
    EXPECT_EQ(loadStrokes(m_folder / "a.strokes"), strokes);
}

TEST_F(StrokeFile, HoldsManyStrokesInLittleRoom)
{
    std::vector<Stroke> strokes(40000);
    for (size_t i = 0; i < strokes.size(); ++i) {
        strokes[i].points = {{{0.001 * static_cast<double>(i % 900), 0.3}, 0.5}};
        strokes[i].brush.color.g = 0.001 * static_cast<double>(i % 1000);
        strokes[i].symmetry.radial = 1 + static_cast<int>(i % 3);
    }
    saveStrokes(strokes, m_folder / "many.strokes");
    EXPECT_LT(std::filesystem::file_size(m_folder / "many.strokes"), strokes.size() * 300u);
    EXPECT_EQ(loadStrokes(m_folder / "many.strokes"), strokes);
}

/// Three layers with a million points each, 17 digits a number: every layer within its limits, the file beyond.
TEST_F(StrokeFile, IsNotSavedWhereItCouldNotBeReadAgain)
{
    SphereMapDocument document;
    saveSphereMap(document, m_folder / "a.spheremap");
    Stroke stroke;
    for (size_t i = 0; i < mostStrokePoints; ++i)
        stroke.points.push_back({{1e-3 / static_cast<double>(i + 3), 0.1 / 3.0}, 1.0 / 3.0});
    document.layers.assign(3, {.content = PaintLayer{.strokes = {stroke}}});
    try {
        saveSphereMap(document, m_folder / "a.spheremap");
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("MiB are the most"), std::string::npos) << error.what();
    }
    EXPECT_EQ(loadSphereMap(m_folder / "a.spheremap").layers.size(), 0u);
}

TEST_F(StrokeFile, KeepsKeysThatThisVersionDoesNotKnow)
{
    const std::vector<Stroke> strokes =
        loadStrokes(write(R"({"version": 1, "strokes": [{"points": "0 0 1", "tilt": [1, 2], "brush": {"bristles": 7}}]})"));
    saveStrokes(strokes, m_folder / "b.strokes");
    EXPECT_EQ(loadStrokes(m_folder / "b.strokes"), strokes);
    EXPECT_EQ(strokes[0].unknown.at("tilt"), "[1,2]");
    EXPECT_EQ(strokes[0].brush.unknown.at("bristles"), "7");
}

TEST_F(StrokeFile, ReadsPointsAsTextOrAsAListWithPressureOneWhereItIsMissing)
{
    const std::vector<StrokePoint> expected{{{0.25, -0.5}, 0.75}, {{1e-3, 1.0}, 1.0}};
    const auto points = [&](const std::string& json) {
        return loadStrokes(write("{\"version\":1,\"strokes\":[{\"points\":" + json + "}]}"))[0].points;
    };
    EXPECT_EQ(points("\"0.25 -0.5 0.75, 1e-3 1\""), expected);
    EXPECT_EQ(points("\"  0.25   -0.5\\n0.75,1e-3 1 1,\""), expected);
    EXPECT_EQ(points("[[0.25, -0.5, 0.75], [1e-3, 1]]"), expected);
    EXPECT_TRUE(points("\"\"").empty());
}

TEST_F(StrokeFile, KeepsTiltsAndHoldsNoneOfAPenThatStoodUpright)
{
    std::vector<Stroke> strokes{{.points = {{{0.25, -0.5}, 0.75}, {{0.5, 1.0}, 1.0}}}};
    const auto written = [&] {
        saveStrokes(strokes, m_folder / "a.strokes");
        std::ifstream file(m_folder / "a.strokes");
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string upright = written();
    EXPECT_NE(upright.find("\"0.25 -0.5 0.75,0.5 1 1\""), std::string::npos) << upright;
    EXPECT_EQ(upright.find("tilt"), std::string::npos) << upright;
    strokes[0].brush.tilt = 0.5;
    strokes[0].points[1].tilt = {12.5, -60.0};
    EXPECT_NE(written().find("\"0.25 -0.5 0.75,0.5 1 1 12.5 -60\""), std::string::npos) << written();
    EXPECT_EQ(loadStrokes(m_folder / "a.strokes"), strokes);
    const std::string list = "{\"version\":1,\"strokes\":[{\"brush\":{\"tilt\":0.5},\"points\":[[0.25,-0.5,0.75],[0.5,1,1,12.5,-60]]}]}";
    EXPECT_EQ(loadStrokes(write(list)), strokes);
}

TEST_F(StrokeFile, IsASphereMapOfOnePaintLayer)
{
    const std::vector<Stroke> strokes = handDrawnStrokes(5, 6);
    saveStrokes(strokes, m_folder / "a.strokes");
    const SphereMapDocument document = loadSphereMap(m_folder / "a.strokes");
    ASSERT_EQ(document.layers.size(), 1u);
    EXPECT_EQ(std::get<PaintLayer>(document.layers[0].content).strokes, strokes);
}

TEST_F(StrokeFile, IsNoPipe)
{
    const std::string pipe = (m_folder / "pipe.strokes").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(loadStrokes(pipe), FileError); // and does not wait for somebody to write
}

TEST_F(StrokeFile, WhatIsWrongIsNamedInOneLine)
{
    EXPECT_EQ(refusalOfStroke("{}"), "strokes[0].points: are missing; write \"points\": \"x y pressure, ...\"");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 0, 0.5\"}"), "strokes[0].points[1]: must be \"x y pressure\"; a number is missing");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 0 1 4\"}"),
              "strokes[0].points[0]: must be \"x y pressure tilt-x tilt-y\"; the second tilt is missing");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 0 1 4 5 6\"}"),
              "strokes[0].points[0]: must be \"x y pressure\", points apart by commas; it goes on \"6\"");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 0 1 4 -61\"}"),
              "strokes[0].points[0]: has a tilt outside [-60, 60] degrees; tilts are the fourth and fifth number of a point");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 0 1 nan 0\"}"),
              "strokes[0].points[0]: has a tilt outside [-60, 60] degrees; tilts are the fourth and fifth number of a point");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 zero\"}"),
              "strokes[0].points[0]: must be \"x y pressure\", points apart by commas; it goes on \"zero\"");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"nan 0\"}"),
              "strokes[0].points[0]: must lie within 4 disc radii of the center, as finite numbers");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"1e999 0\"}"),
              "strokes[0].points[0]: must be \"x y pressure\", points apart by commas; it goes on \"1e999 0\"");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"0 0 2\"}"),
              "strokes[0].points[0]: has a pressure outside [0, 1]; pressure is the third number of a point");
    EXPECT_EQ(refusalOfStroke("{\"points\": [[0, 0, null]]}"),
              "strokes[0].points[0]: must be a list [x, y, pressure] or [x, y, pressure, tilt-x, tilt-y]; it is a list of 3");
    EXPECT_EQ(refusalOfStroke("{\"points\": [[0, 0, 1, 5]]}"),
              "strokes[0].points[0]: must be a list [x, y, pressure] or [x, y, pressure, tilt-x, tilt-y]; it is a list of 4");
    EXPECT_EQ(refusalOfStroke("{\"points\": 7}"), "strokes[0].points: must be a text \"x y pressure, ...\" or a list of lists; it is 7");
    EXPECT_EQ(refusalOfStroke("{\"points\": \"\", \"brush\": {\"mode\": \"spray\"}}"),
              "strokes[0].brush.mode: must be paint, erase or smudge; it is \"spray\"");
    EXPECT_NE(refusalOfStroke("{\"points\": \"\", \"brush\": {\"radius\": 0}}").find("strokes[0].brush.radius: must"), std::string::npos);
    EXPECT_EQ(refusal("{\"version\": 1}"), "strokes: are missing; a file of strokes is {\"version\": 1, \"strokes\": [...]}");
    EXPECT_NE(refusal("{\"version\": 2, \"strokes\": []}").find("version: is 2"), std::string::npos);
}

TEST_F(StrokeFile, AMillionPointsAreReadOrRefusedInBoundedTime)
{
    std::string zigzag;
    for (int i = 0; i < 1000000; ++i)
        zigzag += i % 2 ? "1 0," : "-1 0,";
    EXPECT_NE(refusalOfStroke("{\"points\": \"" + zigzag + "\"}").find("strokes[0]: needs more than 2097152 dabs"), std::string::npos);
    for (int i = 0; i < 100000; ++i)
        zigzag += "0 0,";
    EXPECT_EQ(refusalOfStroke("{\"points\": \"" + zigzag + "\"}"), "strokes[0].points: are more than 1048576; thin the stroke out");
}

} // namespace
} // namespace mirrorball
