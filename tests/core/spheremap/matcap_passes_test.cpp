#include "core/base/error.h"
#include "core/spheremap/document/presets.h"
#include "core/spheremap/evaluation/matcap_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirrorball {
namespace {

const Layer body{.name = "Body", .content = GradientLayer{}};
const Layer shine{.name = "Shine", .blend = BlendMode::Add, .content = PhongLightsLayer{}};
const std::vector<std::string> shineName{"Shine"};

SphereMapDocument stack(std::vector<Layer> layers)
{
    SphereMapDocument document;
    document.layers = std::move(layers);
    return document;
}

/// By how much diffuse + specular misses the picture of the whole document, at most.
double difference(const SphereMapDocument& document, const std::vector<std::string>& specular)
{
    const EvaluateOptions options{.size = 48};
    const MatcapPasses passes = evaluatePasses(document, specular, options);
    const Image whole = evaluate(document, options);
    double largest = 0.0;
    for (int y = 0; y < whole.height; ++y)
        for (int x = 0; x < whole.width; ++x)
            for (int c = 0; c < 3; ++c)
                largest = std::max<double>(largest,
                                           std::abs(passes.diffuse.texel(x, y)[c] + passes.specular.texel(x, y)[c] - whole.texel(x, y)[c]));
    return largest;
}

TEST(MatcapPasses, AddUpToTheMapWhereTheShineIsAdded) { EXPECT_LT(difference(stack({body, shine}), shineName), 1e-6); }

TEST(MatcapPasses, AddUpToTheMapUnderLayersThatDimOrMoveLight)
{
    const Layer edge{.name = "Edge", .opacity = 0.7, .blend = BlendMode::Multiply, .content = GradientLayer{}};
    const Layer soft{.name = "Soft", .content = BlurLayer{}};
    const Layer turned{.name = "Turned", .content = RotateLayer{}};
    EXPECT_LT(difference(stack({body, shine, edge}), shineName), 1e-6);
    EXPECT_LT(difference(stack({body, shine, soft, edge}), shineName), 1e-5);
    EXPECT_LT(difference(stack({edge, body, shine, turned}), shineName), 1e-5);
}

TEST(MatcapPasses, AddUpToTheMapWhateverTheBlendModes)
{
    for (size_t mode = 0; mode < words(BlendMode{}).size(); ++mode) {
        Layer blended = shine;
        blended.blend = static_cast<BlendMode>(mode);
        const SphereMapDocument document = stack({body, blended, {.opacity = 0.5, .content = CurvesLayer{}}});
        EXPECT_LT(difference(document, shineName), 1e-6) << words(BlendMode{})[mode];
        const MatcapPasses passes = evaluatePasses(document, shineName, {.size = 48});
        EXPECT_GE(*std::min_element(passes.diffuse.texels.begin(), passes.diffuse.texels.end()), 0.0f);
        EXPECT_GE(*std::min_element(passes.specular.texels.begin(), passes.specular.texels.end()), 0.0f);
    }
}

TEST(MatcapPasses, OfPresetsAddUpToWhatTheyShow)
{
    for (const auto& [name, layers] : {std::pair<const char*, std::vector<std::string>>{"porcelain", {"Glaze", "Window", "Strip light"}},
                                       {"car-paint", {}},
                                       {"jade", {}},
                                       {"studio-clay", {}}}) {
        const SphereMapPreset* preset = findSphereMapPreset(name);
        ASSERT_TRUE(preset) << name;
        // Where no layers are named here: the topmost, whatever it is.
        const std::vector<std::string> specular = layers.empty() ? std::vector{preset->document.layers.back().name} : layers;
        EXPECT_LT(difference(preset->document, specular), 1e-5) << name; // light of some tens, in float
    }
}

TEST(MatcapPasses, ShadeWhatANamedLayerDarkens)
{
    const Layer shade{.name = "Shine", .blend = BlendMode::Multiply, .content = FillLayer{.color = glm::dvec3(0.25)}};
    const MatcapPasses passes = evaluatePasses(stack({{.content = FillLayer{.color = glm::dvec3(0.8)}}, shade}), shineName, {.size = 8});
    EXPECT_EQ(passes.specular, Image(8, 8, 3));
    for (const float matt : passes.diffuse.texels)
        EXPECT_NEAR(matt, 0.2f, 1e-6f);
}

TEST(Bordered, ContinuesTheEdgeAndKeepsThePicture)
{
    Image picture(2, 2, 3);
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = static_cast<float>(i);
    EXPECT_EQ(bordered(picture, 0), picture);
    const Image wide = bordered(picture, 2);
    ASSERT_EQ(wide.width, 6);
    ASSERT_EQ(wide.height, 6);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x)
            EXPECT_EQ(wide.texel(x, y)[1], picture.texel(x < 3 ? 0 : 1, y < 3 ? 0 : 1)[1]) << x << ' ' << y;
}

TEST(MatcapPasses, AreBlackWhereNothingShinesAndRefuseANameThatNoLayerHas)
{
    Layer hidden = shine;
    hidden.visible = false;
    EXPECT_EQ(evaluatePasses(stack({body, hidden}), shineName, {.size = 8}).specular, Image(8, 8, 3));
    EXPECT_THROW(evaluatePasses(stack({body}), shineName, {.size = 8}), InvalidArgument);
}

} // namespace
} // namespace mirrorball
