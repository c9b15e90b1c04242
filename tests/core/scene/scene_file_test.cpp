#include "core/scene/scene_file.h"

#include "core/base/error.h"
#include "core/scene/material_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string>

namespace mirrorball {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class SceneFile : public testing::Test {
protected:
    void SetUp() override
    {
        m_folder = std::filesystem::path(testing::TempDir()) /
                   ("mirrorball_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(m_folder);
        std::filesystem::create_directories(m_folder / "sub");
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::filesystem::path write(const std::string& text) const
    {
        std::ofstream(m_folder / "test.mirrorball", std::ios::binary) << text;
        return m_folder / "test.mirrorball";
    }
    std::string refusal(const std::string& text) const
    {
        try {
            loadScene(write(text));
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    }

    std::filesystem::path m_folder;
};

/// Gives every field of a settings struct a value that is not its default, within its range.
struct Changer {
    int count = 0;

    void operator()(const Field& field, double& value)
    {
        value = std::min(field.high, std::max(field.low, value + 0.1 * ++count + 1.0 / 3));
    }
    void operator()(const Field&, int& value) { value += 3; }
    void operator()(const Field&, bool& value) { value = !value; }
    void operator()(const Field& field, std::string& value)
    {
        value = value == "gold" ? "custom" : field.name == "model" ? "ggx:alpha=0.25" : value + "é \" x";
    }
    void operator()(const Field&, glm::dvec3& value) { value += glm::dvec3(0.1, 1.0 / 3, 2e-7); }
    void operator()(const Field&, std::optional<Parameterization>& value) { value = Parameterization::Angular; }
    void operator()(const Field&, Parameterization& value) { value = Parameterization::Paraboloid; }
    void operator()(const Field&, EmbeddedSphereMap&) {} // embedded_sphere_map_test.cpp
    template <typename E>
    requires std::is_enum_v<E>
    void operator()(const Field&, E& value) { value = value == E{} ? E{1} : E{}; }
    void operator()(const Field&, std::vector<ExportTarget>& value)
    {
        value.resize(2);
        value[0].name = "one";
        value[1] = {.name = "two",
                    .kind = ExportKind::Chain,
                    .parameterization = Parameterization::Paraboloid,
                    .size = 77,
                    .border = 2,
                    .file = "other-two.tif",
                    .half = true,
                    .mips = true,
                    .levels = 5,
                    .unknown = {{"note", "\"later\""}}};
    }
    template <typename T>
    requires requires(T& value) { value.unknown; }
    void operator()(const Field&, T& value)
    {
        T::visitFields(value, *this);
        value.unknown = {{"future", R"({"a":[1,2.5,null,{"b":true}]})"}};
    }
};

Scene changedScene()
{
    Scene scene;
    Changer changer;
    Scene::visitFields(scene, changer);
    scene.map.border = 4;
    scene.unknown = {{"studio", R"({"panel":"left"})"}};
    return scene;
}

TEST_F(SceneFile, RoundTripsEveryFieldAndUnknownKeys)
{
    Scene scene = changedScene();
    scene.folder = m_folder;
    EXPECT_NE(scene.view, ViewSettings{});
    saveScene(scene, m_folder / "all.mirrorball");
    EXPECT_EQ(loadScene(m_folder / "all.mirrorball"), scene);

    scene = {.folder = m_folder};
    saveScene(scene, m_folder / "default.mirrorball");
    EXPECT_EQ(loadScene(m_folder / "default.mirrorball"), scene);
}

TEST_F(SceneFile, SavedTwiceIsTheSameText)
{
    const auto text = [](const std::filesystem::path& path) {
        std::stringstream stream;
        stream << std::ifstream(path).rdbuf();
        return stream.str();
    };
    Scene scene = changedScene();
    scene.folder = m_folder;
    saveScene(scene, m_folder / "a.mirrorball");
    saveScene(loadScene(m_folder / "a.mirrorball"), m_folder / "b.mirrorball");
    EXPECT_EQ(text(m_folder / "a.mirrorball"), text(m_folder / "b.mirrorball"));
}

TEST_F(SceneFile, MissingFieldsTakeTheirDefaults)
{
    const Scene scene = loadScene(write(R"({"version": 1, "material": {"lambda": 2}})"));
    Scene expected{.folder = m_folder};
    expected.material.lambda = 2.0;
    EXPECT_EQ(scene, expected);
}

TEST_F(SceneFile, RelativePathsStartAtTheFileAndFollowItWhenItMoves)
{
    Scene scene = loadScene(write(R"({"version": 1, "probe": {"source": "light/a.hdr"}})"));
    EXPECT_EQ(scene.probe.source, "light/a.hdr");
    EXPECT_EQ(resolved(scene, scene.probe.source), (m_folder / "light/a.hdr").string());
    EXPECT_EQ(resolved(scene, "builtin:sky"), "builtin:sky");
    EXPECT_EQ(resolved(scene, "/a/b.hdr"), "/a/b.hdr");
    saveScene(scene, m_folder / "sub" / "moved.mirrorball");
    const Scene moved = loadScene(m_folder / "sub" / "moved.mirrorball");
    EXPECT_EQ(moved.probe.source, "../light/a.hdr");
}

TEST_F(SceneFile, PathsIntoItsFolderAreRelativeEvenWhereTheyReadLikeNames)
{
    Scene scene;
    scene.probe.source = (m_folder / "sub" / "a.hdr").string();
    scene.view.geometry = (m_folder / "teapot").string(); // a mesh file without an extension
    scene.material.sphereMap.source = (m_folder / "jade").string();
    scene.view.window.far = (m_folder.parent_path() / "hills.spheremap").string();
    scene.view.display.config = (m_folder / "env").string();
    scene.material.diffuse.picture = (m_folder / "sub" / "checker.png").string();
    scene.material.sphereMap.flecks.pattern = (m_folder / "stripes.png").string();
    saveScene(scene, m_folder / "a.mirrorball");
    const Scene read = loadScene(m_folder / "a.mirrorball");
    EXPECT_EQ(read.probe.source, "sub/a.hdr");
    EXPECT_EQ(read.view.geometry, "./teapot");
    EXPECT_EQ(read.material.sphereMap.source, "./jade");
    EXPECT_EQ(read.view.window.far, scene.view.window.far) << "outside: as it was";
    EXPECT_EQ(read.view.display.config, "./env");
    EXPECT_EQ(read.material.diffuse.picture, "sub/checker.png");
    EXPECT_EQ(read.material.sphereMap.flecks.pattern, "stripes.png");
    saveScene(read, m_folder / "a.mirrorball");
    EXPECT_EQ(loadScene(m_folder / "a.mirrorball"), read);
}

TEST_F(SceneFile, EachBadFieldIsNamedWithWhatItMustBe)
{
    const struct {
        const char *members, *field, *must;
    } cases[] = {
        {R"("probe": 3)", "probe", "an object"},
        {R"("probe": {"source": ""})", "probe.source", "builtin:NAME"},
        {R"("probe": {"source": 5})", "probe.source", "a text"},
        {R"("probe": {"parameterization": "globe"})", "probe.parameterization", "auto, latlong, cube"},
        {R"("probe": {"yaw": "left"})", "probe.yaw", "a number"},
        {R"("probe": {"yaw": 1e30})", "probe.yaw", "degrees"},
        {R"("probe": {"exposure": 65})", "probe.exposure", "from -64 to 64 EV"},
        {R"("map": {"parameterization": null})", "map.parameterization", "latlong, cube"},
        {R"("map": {"size": 0})", "map.size", "from 1 to 16384 texels"},
        {R"("map": {"size": 512.5})", "map.size", "a whole number"},
        {R"("map": {"size": 99999999999999999999})", "map.size", "a whole number"},
        {R"("map": {"size": 18446744073709551615})", "map.size", "from 1 to 16384"},
        {R"("map": {"border": 3})", "map.border", "paraboloid"},
        {R"("map": {"parameterization": "paraboloid", "size": 8, "border": 4})", "map.border", "half the size"},
        {R"("material": {"specular": {"lobe": "blinn"}})", "material.specular.lobe", "mirror, phong or ggx"},
        {R"("material": {"specular": {"exponent": -1}})", "material.specular.exponent", "from 0 to 1e+09"},
        {R"("material": {"specular": {"roughness": 1.01}})", "material.specular.roughness", "from 0 to 1"},
        {R"("material": {"specular": {"weight": true}})", "material.specular.weight", "a number"},
        {R"("material": {"specular": {"color": [1, 1]}})", "material.specular.color", "three numbers"},
        {R"("material": {"specular": {"color": [1, 1, -1]}})", "material.specular.color[2]", "from 0"},
        {R"("material": {"fresnel": {"index": 0}})", "material.fresnel.index", "from 0.001"},
        {R"("material": {"fresnel": {"metal": "kryptonite"}})", "fresnel.metal", "gold"},
        {R"("material": {"fresnel": {"kind": true}})", "material.fresnel.kind", "none, dielectric or conductor"},
        {R"("material": {"combine": "mix"})", "material.combine", "add or coat"},
        {R"("material": {"lambda": -0.5})", "material.lambda", "from 0 to 16"},
        {R"("material": {"sphere_map": {"use": "under"}})", "material.sphere_map.use", "replace, multiply, over, tint or add"},
        {R"("view": {"camera": {"pitch": 91}})", "view.camera.pitch", "from -90 to 90 degrees"},
        {R"("view": {"camera": {"distance": 0}})", "view.camera.distance", "from 0.01"},
        {R"("view": {"tone": "aces"})", "view.tone", "auto, none, reinhard or filmic"},
        {R"("view": {"background": {"kind": "red"}})", "view.background.kind", "environment, blurred, color or none"},
        {R"("view": {"width": 1e5})", "view.width", "a whole number"},
        {R"("view": {"height": 100000})", "view.height", "from 1 to 16384 pixels"},
        {R"("exports": {})", "exports", "a list"},
        {R"("exports": [3])", "exports[0]", "an object"},
        {R"("exports": [{}])", "exports[0].name", "letters"},
        {R"("exports": [{"name": "a/b"}])", "exports[0].name", "letters"},
        {R"("exports": [{"name": "a"}, {"name": "a"}])", "exports[1].name", "taken"},
        {R"("exports": [{"name": "a", "file": "../a.exr"}])", "exports[0].file", "without folders"},
        {R"("exports": [{"name": "a", "file": "a"}])", "exports[0].file", "with an extension"},
        {R"("exports": [{"name": "a"}, {"name": "b", "file": "a.exr"}])", "exports[1].file", "differ"},
        {R"("exports": [{"name": "a", "half": 1}])", "exports[0].half", "true or false"},
        {R"("exports": [{"name": "a", "size": 1e9}])", "exports[0].size", "a whole number"},
        {R"("exports": [{"name": "a", "levels": 17}])", "exports[0].levels", "from 0 to 16"},
    };
    for (const auto& c : cases) {
        const std::string message = refusal(std::string("{\"version\": 1, ") + c.members + "}");
        EXPECT_THAT(message,
                    AllOf(HasSubstr("test.mirrorball"), HasSubstr(std::string(c.field) + ": "), HasSubstr(c.must), Not(HasSubstr("\n"))))
            << c.members;
    }
}

TEST_F(SceneFile, HostileFilesGiveOneLine)
{
    const std::string deep(100000, '['), deepObject = [] {
        std::string text;
        for (int i = 0; i < 100000; ++i)
            text += "{\"a\":";
        return text;
    }();
    const struct {
        std::string text, expected;
    } cases[] = {
        {"", "is empty"},
        {" \n ", "is empty"},
        {"hello", "line 1"},
        {"{\"version\": 1,\n\"probe\": {]}", "line 2"},
        {"{\"version\": 1", "no JSON"},
        {std::string("\0\0\0", 3), "no JSON"},
        {"\xff\xfe{}", "no JSON"},
        {deep, "nested"},
        {deepObject, "nested"},
        {"{\"version\": 1, \"a\": " + std::string(70, '[') + std::string(70, ']') + "}", "nested"},
        {"[]", "an object"},
        {"{}", "version: is missing"},
        {"{\"version\": \"1\"}", "version: must be"},
        {"{\"version\": 0}", "version: must be"},
        {"{\"version\": 2}", "update Mirrorball"},
        {"{\"version\": 1, \"map\": {}, \"map\": {}}", "\"map\" occurs twice"},
        {"{\"version\": 1, \"x\": {\"y\": 1, \"y\": 2}}", "\"y\" occurs twice"},
        {"{\"version\": 1, \"probe\": {\"yaw\": 1e999}}", "too large"},
        {"{\"version\": 1, \"probe\": {\"yaw\": NaN}}", "no JSON"},
        {"{\"version\": 1, \"probe\": {\"source\": \"a\\u0000b\"}}", "without NUL"},
        {"{\"version\": 1, \"view\": {\"tone\": \"" + std::string(100000, 'x') + "\"}}", "..."},
        {"{\"version\": 1, \"view\": {\"tone\": \"a\\nb\"}}", "a?b"},
    };
    for (const auto& c : cases) {
        const std::string message = refusal(c.text);
        EXPECT_THAT(message, AllOf(HasSubstr("test.mirrorball: "), HasSubstr(c.expected), Not(HasSubstr("\n")))) << c.text.substr(0, 80);
        EXPECT_LT(message.size(), 600u);
    }
}

TEST_F(SceneFile, HugeMissingAndSpecialFilesAreRefused)
{
    const std::filesystem::path huge = m_folder / "huge.mirrorball";
    std::ofstream(huge).put(' ');
    std::filesystem::resize_file(huge, std::uintmax_t{1} << 30);
    EXPECT_THROW(loadScene(huge), FileError);
    EXPECT_THROW(loadScene(m_folder), FileError);
    EXPECT_THROW(loadScene(m_folder / "none.mirrorball"), FileError);
    EXPECT_THROW(loadScene("/dev/zero"), FileError);
    EXPECT_THROW(loadScene("/dev/null"), FileError);
}

TEST_F(SceneFile, ManyUnknownKeysAreKeptInReasonableTime)
{
    std::string text = "{\"version\": 1";
    for (int i = 0; i < 200000; ++i)
        text += ",\"k" + std::to_string(i) + "\":0";
    const Scene scene = loadScene(write(text + "}"));
    EXPECT_EQ(scene.unknown.size(), 200000u);
    saveScene(scene, m_folder / "again.mirrorball");
    EXPECT_EQ(loadScene(m_folder / "again.mirrorball"), scene);
}

TEST_F(SceneFile, WhatCannotBeReadBackIsNotWritten)
{
    const std::filesystem::path path = write("old");
    Scene scene;
    scene.material.specular.exponent = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(saveScene(scene, path), InvalidArgument);
    scene.material.specular.exponent = std::numeric_limits<double>::infinity();
    EXPECT_THROW(saveScene(scene, path), InvalidArgument);
    scene = {};
    scene.probe.source = "a\xff.hdr";
    scene.folder = m_folder;
    EXPECT_THROW(saveScene(scene, path), InvalidArgument);
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    EXPECT_EQ(text.str(), "old");
    EXPECT_THROW(saveScene({}, m_folder / "missing" / "x.mirrorball"), WorkError);
}

TEST_F(SceneFile, MaterialFilesHoldTheMaterialAlone)
{
    Scene scene;
    scene.material = changedScene().material;
    scene.material.diffuse.picture = (m_folder / "a.png").string(); // as files hold them, for a scene that may lie elsewhere
    scene.material.sphereMap.flecks.pattern = (m_folder / "b.png").string();
    scene.material.normalMap.source = (m_folder / "c.png").string();
    const Material material = scene.material;
    saveMaterial(scene, m_folder / "m.json");
    EXPECT_EQ(loadMaterial(m_folder / "m.json"), material);
    saveScene(scene, m_folder / "s.mirrorball");
    EXPECT_EQ(loadMaterial(m_folder / "s.mirrorball"), material) << "a scene file stands for its material";
    EXPECT_THROW(loadMaterial(write(R"({"specular": {"exponent": -3}})")), FileError);
    const Material textured = loadMaterial(
        write(R"({"diffuse": {"picture": "a.png"}, "normal_map": {"source": "c.png"}, "sphere_map": {"flecks": {"pattern": "b.png"}}})"));
    EXPECT_EQ(textured.diffuse.picture, (m_folder / "a.png").string()) << "for a scene elsewhere";
    EXPECT_EQ(textured.sphereMap.flecks.pattern, (m_folder / "b.png").string());
    EXPECT_EQ(textured.normalMap.source, (m_folder / "c.png").string());
}

TEST(SceneFiles, ThatComeWithTheProgramLoad)
{
    const auto resources = std::filesystem::path(MIRRORBALL_RESOURCES);
    const Scene scene = loadScene(resources / "scenes" / "showroom.mirrorball");
    EXPECT_EQ(scene.exports.size(), 4u);
    EXPECT_TRUE(scene.unknown.empty()) << "a misspelt key would be kept as unknown";
}

TEST(SceneFields, AreSetByPathWithTheChecksOfAFile)
{
    Scene scene;
    scene.exports.push_back({.name = "a"});
    setField(scene, "material.specular.exponent", "120.5");
    setField(scene, "material.specular.lobe", "phong");
    setField(scene, "view.background.kind", "\"none\"");
    setField(scene, "material.diffuse.color", "[0.1, 0.2, 0.3]");
    setField(scene, "exports[0].half", "true");
    EXPECT_EQ(scene.material.specular.exponent, 120.5);
    EXPECT_EQ(scene.material.specular.lobe, SurfaceLobe::Phong);
    EXPECT_EQ(scene.view.background.kind, Backdrop::None);
    EXPECT_EQ(scene.material.diffuse.color, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_TRUE(scene.exports[0].half);

    const Scene before = scene;
    for (const auto& [path, value] : {std::pair{"material.specular.exponent", "nan"},
                                      {"material.specular.exponent", "-1"},
                                      {"material.shine", "1"},
                                      {"material", "1"},
                                      {"", "1"},
                                      {"exports[1].half", "true"},
                                      {"exports[x].half", "true"},
                                      {"exports[0", "true"},
                                      {"view.width", "3.5"},
                                      {"view.tone", "none "},
                                      {"view.width", ""},
                                      {"version", "2"},
                                      {"material.lambda.x", "1"},
                                      {"exports[0]name", "b c"}})
        EXPECT_THROW(setField(scene, path, value), InvalidArgument) << path << " = " << value;
    EXPECT_EQ(scene, before);
}

TEST(SceneFields, AreListedWithHelpAndWords)
{
    std::set<std::string> paths;
    for (const FieldEntry& entry : sceneFields()) {
        EXPECT_FALSE(entry.field.help.empty()) << entry.path;
        EXPECT_TRUE(paths.insert(entry.path).second);
    }
    EXPECT_TRUE(paths.contains("probe.yaw"));
    EXPECT_TRUE(paths.contains("view.camera.fov"));
    EXPECT_GE(paths.size(), 35u);
}

TEST(MaterialPresets, AreValidDistinctAndDescribed)
{
    const auto presets = materialPresets();
    for (size_t i = 0; i < presets.size(); ++i) {
        EXPECT_NO_THROW(validate(presets[i].material)) << presets[i].name;
        EXPECT_THAT(std::string(presets[i].description), testing::EndsWith("."));
        EXPECT_EQ(findMaterialPreset(presets[i].name), &presets[i]);
        for (size_t j = 0; j < i; ++j) {
            EXPECT_NE(presets[i].name, presets[j].name);
            EXPECT_NE(presets[i].material, presets[j].material) << presets[i].name << " and " << presets[j].name;
        }
    }
    for (const char* name : {"mirror", "chrome", "gold", "copper", "glass", "car-paint", "porcelain", "plastic-red", "brushed-metal",
                             "satin", "matte", "pearl"})
        EXPECT_NE(findMaterialPreset(name), nullptr) << name;
    EXPECT_EQ(findMaterialPreset("unobtainium"), nullptr);
}

} // namespace

TEST(BuiltinGeometry, IsTheKindOfItsWordAndNothingElse)
{
    const std::pair<const char*, GeometryKind> bodies[] = {{"teapot", GeometryKind::Teapot},
                                                           {"torus", GeometryKind::Torus},
                                                           {"sphere", GeometryKind::Sphere},
                                                           {"box", GeometryKind::Box},
                                                           {"window", GeometryKind::Window}};
    for (const auto& [word, kind] : bodies)
        EXPECT_EQ(builtinGeometry(word), kind) << word;
    EXPECT_EQ(std::size(bodies), words(GeometryKind{}).size());
    for (const char* other : {"", "Teapot", "./box", "box.obj"})
        EXPECT_FALSE(builtinGeometry(other)) << other;
}

} // namespace mirrorball
