#include "core/base/error.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/document/sphere_map_file.h"
#include "core/spheremap/evaluation/evaluate.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace mirrorball {
namespace {

/// What loading a text as a document has to say.
std::string refusal(const std::string& text)
{
    try {
        sphereMapFromText(text);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "";
}

std::string withLayer(const std::string& layer) { return R"({"version": 1, "layers": [)" + layer + "]}"; }

TEST(SphereMapFile, RoundTripsEveryKindAndField)
{
    SphereMapDocument document{.title = "All", .description = "Each kind.", .index = SphereMapIndex::Reflection};
    for (const LayerKind& kind : layerKinds())
        document.layers.push_back({.name = std::string(kind.title),
                                   .visible = false,
                                   .opacity = 0.25,
                                   .blend = BlendMode::SoftLight,
                                   .content = makeContent(kind.name),
                                   .mask = Mask{.content = SilhouetteLayer{.width = 0.5}, .channel = MaskChannel::Opacity, .invert = true},
                                   .firstLevel = 1,
                                   .lastLevel = 3});
    EXPECT_EQ(sphereMapFromText(sphereMapToText(document)), document);
}

TEST(SphereMapFile, KeepsUnknownKindsAndKeysThroughLoadingAndSaving)
{
    const std::string text = R"({"version": 1, "future": [1, {"a": null}], "layers": [
        {"name": "later", "opacity": 0.5, "glow": 3, "content": {"kind": "plasma", "heat": [1, 2.5], "deep": {"x": "y"}}},
        {"content": {"kind": "silhouette", "width": 0.2, "ink": "blue"}, "mask": {"content": {"kind": "fog", "density": 2}, "edge": 1}}]})";
    const test::TemporaryFolder folder;
    saveSphereMap(sphereMapFromText(text), folder / "kept.spheremap");
    const auto saved = nlohmann::json::parse(std::ifstream(folder / "kept.spheremap"));
    EXPECT_EQ(saved.at("future"), nlohmann::json::parse(R"([1, {"a": null}])"));
    EXPECT_EQ(saved.at("layers")[0].at("glow"), 3);
    EXPECT_EQ(saved.at("layers")[0].at("content"), nlohmann::json::parse(R"({"kind": "plasma", "heat": [1, 2.5], "deep": {"x": "y"}})"));
    EXPECT_EQ(saved.at("layers")[1].at("content").at("ink"), "blue");
    EXPECT_EQ(saved.at("layers")[1].at("mask").at("content"), nlohmann::json::parse(R"({"kind": "fog", "density": 2})"));
    EXPECT_EQ(saved.at("layers")[1].at("mask").at("edge"), 1);
    SphereMapDocument again = loadSphereMap(folder / "kept.spheremap");
    again.folder.clear();
    EXPECT_EQ(again, sphereMapFromText(text));
}

TEST(SphereMapFile, KeepsPathsBelowItRelativeAndOthersAsTheyAre)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "maps" / "builtin:x");
    SphereMapDocument document;
    document.folder = folder / "maps";
    const std::string outside = (folder / "outside.exr").string();
    const auto inside = [&](const char* name) { return (folder / "maps" / name).string(); };
    for (const std::string& source : {inside("a.exr"), inside("deep/b.exr"), inside("deep/../c.exr"), outside, std::string("../d.exr"),
                                      std::string("e.exr"), std::string("builtin:sky"), inside("builtin:x/f.exr"), std::string()})
        document.layers.push_back({.content = ImageLayer{.source = source}});
    const auto sources = [&](const std::filesystem::path& path) {
        saveSphereMap(document, path);
        std::vector<std::string> read;
        for (const Layer& layer : loadSphereMap(path).layers)
            read.push_back(std::get<ImageLayer>(layer.content).source);
        return read;
    };
    EXPECT_EQ(sources(folder / "maps" / "m.spheremap"), (std::vector<std::string>{"a.exr", "deep/b.exr", "c.exr", outside, "../d.exr",
                                                                                  "e.exr", "builtin:sky", "./builtin:x/f.exr", ""}));
    EXPECT_EQ(sources(folder / "m.spheremap"),
              (std::vector<std::string>{"maps/a.exr", "maps/deep/b.exr", "maps/c.exr", "outside.exr", "d.exr", "maps/e.exr", "builtin:sky",
                                        "maps/builtin:x/f.exr", ""}));
}

TEST(SphereMapFile, HostilePathsOfPicturesGiveOneShortLine)
{
    const test::TemporaryFolder folder;
    for (const std::string& source : {std::string("../../../etc/passwd"), std::string(100000, 'x'), std::string("a\n\x1b[31mb.exr"),
                                      std::string("."), std::string("/dev/zero"), std::string("builtin:no-such")}) {
        SphereMapDocument document;
        document.folder = folder.path();
        document.layers = {{.content = FillLayer{}, .mask = Mask{.content = ProbeLayer{.source = source}}}};
        try {
            evaluate(document, {.size = 4});
            ADD_FAILURE() << source.substr(0, 40);
        } catch (const InvalidArgument& error) {
            const std::string line = error.what();
            EXPECT_LT(line.size(), 500u);
            EXPECT_TRUE(std::none_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; })) << line;
        }
    }
    std::ofstream(folder / "nul.spheremap") << R"({"version": 1, "layers": [{"content": {"kind": "image", "source": "a\u0000.exr"}}]})";
    EXPECT_THROW(loadSphereMap(folder / "nul.spheremap"), FileError);
}

TEST(SphereMapFile, BadDocumentsAreRefusedInOneLineThatNamesTheField)
{
    EXPECT_EQ(refusal(withLayer(R"({"content": {"kind": "silhouette", "width": -1}})")),
              "layers[0].content.width: must be from 0 to 64 disc radii or pixels; it is -1");
    EXPECT_EQ(refusal(withLayer(R"({"content": {"kind": "silhouette", "width": null}})")),
              "layers[0].content.width: must be a number; it is null");
    EXPECT_EQ(refusal(withLayer(R"({"blend": "burn"})")).substr(0, 34), "layers[0].blend: must be normal, m");
    EXPECT_NE(refusal(withLayer(R"({"content": {"kind": "silhouette", "width": NaN}})")).find("line 1"), std::string::npos);
    EXPECT_EQ(refusal(withLayer(R"({"content": {"width": 1}})")), "layers[0].content.kind: is missing; name one, such as \"gradient\"");
    EXPECT_EQ(refusal(withLayer(R"({"content": {"kind": 7}})")),
              "layers[0].content.kind: must be the name of a kind, such as \"gradient\"; it is 7");
    EXPECT_EQ(refusal(withLayer(R"({"mask": {"content": {"kind": "invert"}}})")),
              "layers[0].mask.content.kind: must be a generator, such as gradient or image; it is \"invert\"");
    EXPECT_EQ(refusal(withLayer(R"({"first-level": 3, "last-level": 2})")),
              "layers[0].last-level: must be at least first-level, 3; it is 2");
    EXPECT_EQ(refusal(withLayer(R"({"content": {"kind": "gradient", "stops": [{"position": 2}]}})")),
              "layers[0].content.stops[0].position: must be from 0 to 1; it is 2");
    EXPECT_EQ(refusal(R"({"version": 2})"), "version: is 2, but this program reads up to 1; update Mirrorball");
    EXPECT_EQ(refusal("{}"), "version: is missing; a sphere map file begins with {\"version\": 1, ...}");
    EXPECT_EQ(refusal("[]").substr(0, 12), "the file: mu");
}

TEST(SphereMapFile, AMillionLayersAreRefusedInOneLine)
{
    std::string layers = "{}";
    for (int i = 1; i < 1000000; ++i)
        layers += ",{}";
    EXPECT_EQ(refusal(withLayer(layers)), "layers: must be a list of at most 1000; it has 1000000");
}

TEST(SphereMapFile, NumbersThatAreNotFiniteAreNeitherSavedNorEvaluated)
{
    SphereMapDocument document{.layers = {{.content = SilhouetteLayer{.width = std::numeric_limits<double>::quiet_NaN()}}}};
    const test::TemporaryFolder folder;
    EXPECT_THROW(saveSphereMap(document, folder / "nan.spheremap"), InvalidArgument);
    EXPECT_FALSE(std::filesystem::exists(folder / "nan.spheremap"));
    EXPECT_THROW(evaluate(document, {.size = 8}), InvalidArgument);
    document.layers = {{.opacity = std::numeric_limits<double>::infinity()}};
    EXPECT_THROW(evaluate(document, {.size = 8}), InvalidArgument);
}

TEST(SphereMapFile, ErrorsNameTheFile)
{
    const test::TemporaryFolder folder;
    std::ofstream(folder / "broken.spheremap") << "{\"version\": 1, \"layers\": 5}";
    for (const char* name : {"broken.spheremap", "missing.spheremap"})
        try {
            loadSphereMap(folder / name);
            ADD_FAILURE() << name;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
}

// Highlights add light and rainbows color it; files, which may leave the blend mode out, keep theirs.
TEST(SphereMapLayers, AreAddedWithTheBlendModeOfTheirKind)
{
    EXPECT_EQ(makeLayer("phong-lights").blend, BlendMode::Add);
    EXPECT_EQ(makeLayer("colorgram").blend, BlendMode::Multiply);
    EXPECT_EQ(makeLayer("toon").blend, BlendMode::Normal);
    EXPECT_TRUE(std::holds_alternative<ColorgramLayer>(makeLayer("colorgram").content));
    const SphereMapDocument read = sphereMapFromText(R"({"version": 1, "layers": [{"content": {"kind": "phong-lights"}}]})");
    EXPECT_EQ(read.layers.at(0).blend, BlendMode::Normal);
}

TEST(SphereMapPresets, LoadAndHaveTitlesAndSentences)
{
    std::vector<SphereMapPreset> all(sphereMapPresets().begin(), sphereMapPresets().end());
    all.insert(all.end(), windowViewPresets().begin(), windowViewPresets().end());
    for (const SphereMapPreset& preset : all) {
        EXPECT_FALSE(preset.title.empty()) << preset.name;
        EXPECT_TRUE(preset.description.ends_with('.')) << preset.name;
        EXPECT_FALSE(preset.document.layers.empty()) << preset.name;
        for (const Layer& layer : preset.document.layers) {
            EXPECT_FALSE(std::holds_alternative<UnknownLayer>(layer.content)) << preset.name;
            EXPECT_TRUE(layer.unknown.empty()) << preset.name << ": " << layer.unknown.begin()->first;
        }
        EXPECT_EQ(findSphereMapPreset(preset.name)->title, preset.title);
    }
    EXPECT_EQ(findSphereMapPreset("nothing"), nullptr);
}

} // namespace
} // namespace mirrorball
