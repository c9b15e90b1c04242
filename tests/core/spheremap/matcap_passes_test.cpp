#include "core/error.h"
#include "core/spheremap/matcap_passes.h"

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
                largest = std::max<double>(largest, std::abs(passes.diffuse.texel(x, y)[c] + passes.specular.texel(x, y)[c] - whole.texel(x, y)[c]));
    return largest;
}

TEST(MatcapPasses, AddUpToTheMapWhereTheShineIsAdded)
{
    EXPECT_LT(difference(stack({body, shine}), shineName), 1e-6);
}

TEST(MatcapPasses, AddUpToTheMapUnderLayersThatDimOrMoveLight)
{
    const Layer edge{.name = "Edge", .opacity = 0.7, .blend = BlendMode::Multiply, .content = GradientLayer{}};
    const Layer soft{.name = "Soft", .content = BlurLayer{}};
    const Layer turned{.name = "Turned", .content = RotateLayer{}};
    EXPECT_LT(difference(stack({body, shine, edge}), shineName), 1e-6);
    EXPECT_LT(difference(stack({body, shine, soft, edge}), shineName), 1e-5);
    EXPECT_LT(difference(stack({edge, body, shine, turned}), shineName), 1e-5);
}

TEST(MatcapPasses, ShineIsWhatItIsByItselfWhateverLiesBelow)
{
    Layer screened = shine;
    for (const BlendMode mode : {BlendMode::Normal, BlendMode::Screen, BlendMode::Overlay, BlendMode::Multiply, BlendMode::Lighten}) {
        screened.blend = mode;
        const Image over = evaluatePasses(stack({{.content = FillLayer{.color = glm::dvec3(1.0)}}, screened}), shineName, {.size = 24}).specular;
        const Image alone = evaluatePasses(stack({shine}), shineName, {.size = 24}).specular;
        EXPECT_EQ(over, alone);
        EXPECT_GT(*std::max_element(alone.texels.begin(), alone.texels.end()), 0.5f);
    }
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
