#include "core/scene/scene_dependencies.h"

#include "core/base/error.h"
#include "core/scene/scene_file.h"

#include <gtest/gtest.h>

#include <map>

namespace mirrorball {
namespace {

/// What a field touches. `Nothing`: neither maps nor a measurement, but the picture of the moment.
enum class Touches { Nothing, Maps, MapsAndMeasurement };

/// Every field of a scene that has a value of its own. A new one must be put in here - and, unless it touches maps, in
/// scene_dependencies.cpp.
const std::map<std::string, Touches> classes = [] {
    using enum Touches;
    std::map<std::string, Touches> all{{"probe.source", MapsAndMeasurement},
                                       {"probe.yaw", Nothing}, // in world space
                                       {"map.parameterization", MapsAndMeasurement},
                                       {"material.specular.lobe", MapsAndMeasurement},
                                       {"material.specular.exponent", MapsAndMeasurement}, // of a phong lobe
                                       {"view.exposure", Nothing},
                                       {"view.tone", Nothing},
                                       {"view.dither", Nothing}};
    for (const char* field : {"yaw", "pitch", "roll", "distance", "fov", "target", "projection"})
        all.emplace(std::string("view.camera.") + field, Nothing);
    for (const char* field : {"probe.exposure",
                              "map.size",
                              "map.border",
                              "map.mips",
                              "map.mip_filtering",
                              "map.anisotropy",
                              "map.space",
                              "material.specular.roughness",
                              "material.specular.weight",
                              "material.specular.color",
                              "material.fresnel.kind",
                              "material.fresnel.index",
                              "material.fresnel.metal",
                              "material.fresnel.n",
                              "material.fresnel.k",
                              "material.brdf.model",
                              "material.brdf.kind",
                              "material.brdf.lookups",
                              "material.combine",
                              "material.diffuse.weight",
                              "material.diffuse.color",
                              "material.diffuse.picture",
                              "material.clear_coat.weight",
                              "material.clear_coat.index",
                              "material.clear_coat.combine",
                              "material.clear_coat.lobe",
                              "material.clear_coat.exponent",
                              "material.clear_coat.roughness",
                              "material.normal_map.source",
                              "material.normal_map.strength",
                              "material.lambda",
                              "material.lambda_grazing",
                              "material.lod_bias",
                              "material.sphere_map.source",
                              "material.sphere_map.fit",
                              "material.sphere_map.use",
                              "material.sphere_map.opacity",
                              "material.sphere_map.color",
                              "material.sphere_map.space",
                              "material.sphere_map.size",
                              "material.sphere_map.levels",
                              "material.sphere_map.lookup",
                              "material.sphere_map.flecks.density",
                              "material.sphere_map.flecks.size",
                              "material.sphere_map.flecks.spread",
                              "material.sphere_map.flecks.seed",
                              "material.sphere_map.flecks.pattern",
                              "filter.method",
                              "filter.tolerance",
                              "filter.samples",
                              "filter.mip_filtering",
                              "view.geometry",
                              "view.tessellation",
                              "view.shading",
                              "view.window.depth",
                              "view.window.middle",
                              "view.window.middle_depth",
                              "view.window.far",
                              "view.window.far_depth",
                              "view.display.config",
                              "view.display.display",
                              "view.display.view",
                              "view.background.kind",
                              "view.background.blur",
                              "view.background.color",
                              "view.width",
                              "view.height"})
        all.emplace(field, Maps);
    ProbeReading reading;
    ProbeReading::visitFields(reading,
                              [&](const Field& field, auto&) { all.emplace("probe." + std::string(field.name), MapsAndMeasurement); });
    ParaboloidKnobs knobs;
    ParaboloidKnobs::visitFields(knobs, [&](const Field& field, auto&) { all.emplace("filter." + std::string(field.name), Maps); });
    return all;
}();

Scene phongScene()
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Phong, .exponent = 50.0};
    scene.map.border = 0;
    return scene;
}

/// The scene with another value in a field, whatever it is.
Scene changed(const Scene& scene, const FieldEntry& entry)
{
    std::vector<std::string> values(entry.words.begin(), entry.words.end());
    const double low = std::max(entry.field.low, -1000.0), high = std::min(entry.field.high, 1000.0);
    for (const double share : {0.25, 0.5, 0.75})
        values.push_back(std::to_string(low + share * (high - low)));
    for (const double share : {0.25, 0.5, 0.75})
        values.push_back(std::to_string(static_cast<int>(low + share * (high - low))));
    for (const char* word : {"torus", "silver", "jade", "ggx:alpha=0.25", "[0.125, 0.25, 0.5]"})
        values.emplace_back(word);
    for (const std::string& value : values) {
        Scene other = scene;
        try {
            if (entry.path == "map.border")
                setField(other, "map.parameterization", "paraboloid");
            setField(other, entry.path, value);
        } catch (const InvalidArgument&) {
            continue;
        }
        if (entry.path == "map.border")
            other.map.parameterization = scene.map.parameterization;
        if (!(other == scene))
            return other;
    }
    ADD_FAILURE() << entry.path << ": no other value found";
    return scene;
}

TEST(SceneDependencies, EveryFieldIsClassedAndTouchesWhatItsClassSays)
{
    const Scene scene = phongScene();
    size_t found = 0;
    for (const FieldEntry& entry : sceneFields()) {
        const auto touches = classes.find(entry.path);
        ASSERT_NE(touches, classes.end()) << entry.path << " is new: say what depends on it";
        ++found;
        const Scene other = changed(scene, entry);
        EXPECT_EQ(mapsOf(other) == mapsOf(scene), touches->second == Touches::Nothing) << entry.path;
        EXPECT_EQ(measurementOf(other) == measurementOf(scene), touches->second != Touches::MapsAndMeasurement) << entry.path;
        // What needs no map is shown at once; what needs one waits for it.
        const Scene shown = shownNow(scene, other);
        EXPECT_TRUE(shown == (touches->second == Touches::Nothing ? other : scene)) << entry.path;
    }
    EXPECT_EQ(found, classes.size()) << "a class is named for a field that is gone";
}

TEST(SceneDependencies, TheYawTouchesMapsInEyeSpaceAndExportsTouchNone)
{
    Scene scene = phongScene();
    scene.map.space = MapSpace::Eye;
    Scene turned = scene;
    turned.probe.yawDeg = 30.0;
    EXPECT_FALSE(mapsOf(turned) == mapsOf(scene));
    EXPECT_TRUE(shownNow(scene, turned) == scene);
    Scene exporting = scene;
    exporting.exports = {{.name = "a"}};
    EXPECT_TRUE(mapsOf(exporting) == mapsOf(scene));
}

TEST(SceneDependencies, TheRoughnessOfAGgxLobeTouchesAMeasurement)
{
    Scene scene;
    scene.material.specular = {.lobe = SurfaceLobe::Ggx, .roughness = 0.3};
    Scene rougher = scene;
    rougher.material.specular.roughness = 0.4;
    EXPECT_FALSE(measurementOf(rougher) == measurementOf(scene));
}

} // namespace
} // namespace mirrorball
