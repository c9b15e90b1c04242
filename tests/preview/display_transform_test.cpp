#include "core/preview/renderer.h"

#include "gl_fixture.h"
#include "test_environments.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

#include "core/preview/display_tables.h"

#include <OpenColorIO/OpenColorIO.h>
#include <gmock/gmock.h>

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using DisplayTransformTest = mirrorball::test::GlTest;
namespace ocio = OCIO_NAMESPACE;

namespace {

constexpr const char* acesConfig = "colour/cg-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio";

} // namespace

// The GPU's picture of a color against OpenColorIO's own processor on the CPU, for every view of two displays.
TEST_F(DisplayTransformTest, ShowsWhatOpenColorIoComputesOnTheCpu)
{
    SHARED_DATA_OR_SKIP(path, acesConfig);
    const auto config = ocio::Config::CreateFromFile(path.c_str());
    const auto offers = displayOffers(path.string());
    ASSERT_GE(offers.size(), 2u);
    std::vector<glm::vec4> inputs;
    for (int i = 0; i < 400; ++i)
        inputs.emplace_back(std::exp2(-10.0f + 0.04f * float(i)), std::exp2(-8.0f + 0.035f * float((7 * i) % 400)),
                            std::exp2(-9.0f + 0.035f * float((13 * i) % 400)), 1.0f);
    for (const DisplayOffer& offer : {offers[0], offers[1]})
        for (const std::string& view : offer.views) {
            const auto made = displayTransform({path.string(), offer.display, view});
            DisplayTables tables;
            tables.update(made);
            const auto results = evaluateGlsl(made->glsl + "\nvec4 twin(vec4 x) { return ocioDisplay(x); }", inputs, {},
                                              [&](const ShaderProgram& program) { tables.bind(program, 1); });
            const auto processor = config->getProcessor("lin_rec709", offer.display.c_str(), view.c_str(), ocio::TRANSFORM_DIR_FORWARD)
                                       ->getDefaultCPUProcessor();
            for (size_t i = 0; i < inputs.size(); ++i) {
                glm::vec4 expected = inputs[i];
                processor->applyRGBA(&expected.x);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(results[i][c], expected[c], 2e-3f + 1e-3f * std::abs(expected[c]))
                        << offer.display << ", " << view; // 1/500: half a step of 8 bits
            }
        }
}

TEST_F(DisplayTransformTest, StandsInForToneCurveAndEncodingOfThePicture)
{
    SHARED_DATA_OR_SKIP(path, acesConfig);
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.geometry.kind = GeometryKind::Sphere;
    settings.exposure = 1.0f;
    settings.display = displayTransform({path.string(), "", ""});
    const MapLevels map =
        asLevels(environmentFrom({Parameterization::Cube, 4, 0}, [](const glm::dvec3&) { return glm::vec3(0.3f, 0.1f, 0.05f); }));
    Renderer renderer;
    const Image picture = renderer.renderDisplay(settings, {map, {}, map});
    const auto config = ocio::Config::CreateFromFile(path.c_str());
    glm::vec4 expected(0.6f, 0.2f, 0.1f, 1.0f);
    config->getProcessor("lin_rec709", settings.display->display.c_str(), settings.display->view.c_str(), ocio::TRANSFORM_DIR_FORWARD)
        ->getDefaultCPUProcessor()
        ->applyRGBA(&expected.x);
    for (const glm::ivec2 p : {glm::ivec2(16, 16), glm::ivec2(1, 1)}) // object and background
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(picture.texel(p.x, p.y)[c], expected[c], 4e-3f);
    settings.toneCurve = ToneCurve::None;
    EXPECT_EQ(renderer.renderDisplay(settings, {map, {}, map}).texels, picture.texels);
}

TEST(DisplayConfig, ThatIsWrongIsNamedInOneLine)
{
    const auto messageOf = [](const DisplayChoice& choice) -> std::string {
        try {
            displayTransform(choice);
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    };
    const TemporaryFolder folder;
    writeBytes(folder / "bad.ocio", "ocio_profile_version: 77\nnonsense: [\n");
    for (const std::string& message :
         {messageOf({"nothing.ocio"}), messageOf({(folder / "bad.ocio").string()}), messageOf({folder.path().string()})}) {
        EXPECT_TRUE(message.starts_with("view.display.config: ")) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
    SHARED_DATA_OR_SKIP(path, acesConfig);
    EXPECT_THAT(messageOf({path.string(), "Television"}), testing::HasSubstr("it has sRGB - Display"));
    EXPECT_THAT(messageOf({path.string(), "", "Dream"}), testing::HasSubstr("view.display.view: 'Dream'"));
}
