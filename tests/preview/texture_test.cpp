#include "core/preview/texture.h"

#include "gl_fixture.h"
#include "test_environments.h"

#include "core/image/mip_pyramid.h"
#include "core/preview/bound_map.h"
#include "core/preview/half_texels.h"

#include <cmath>
#include <limits>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using Texture = mirrorball::test::GlTest;

namespace {

// Looks every direction up at the level in its fourth component.
std::vector<glm::vec4> lookUp(const EnvironmentTexture& texture, const std::vector<glm::vec4>& inputs)
{
    const std::string text = "#define MAP_RADIANCE radianceOf\n#define MAP_SAMPLER map\n#define MAP_LEVELS levels\n"
                             "#define MAP_SETTINGS settings\n"
                             "#include \"lib/environment_map.glsl\"\n"
                             "vec4 twin(vec4 x) { return vec4(radianceOf(x.w, normalize(x.xyz)), 1.0); }\n";
    std::vector<ShaderDefine> defines;
    addMapDefines(defines, "MAP", texture);
    return evaluateGlsl(text, inputs, defines, [&](const ShaderProgram& program) {
        texture.bind(1);
        program.set("map", 1);
        program.set("levels", texture.levels());
        program.set("settings", glm::vec4(texture.scale(), float(texture.levelCount() - 1), 0.0f, 0.0f));
    });
}

// Nothing smooth: neighboring texels differ as much as any two.
EnvironmentMap noise(const MapLayout& layout)
{
    EnvironmentMap map(layout);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (float& value : map.image.texels)
        value = uniform(random);
    return map;
}

// A pole of a latlong and the rim of a disc are one direction with many places: in a map of noise each holds another value.
bool hasManyPlaces(const MapLayout& layout, const glm::dvec3& d)
{
    if (layout.kind == Parameterization::Latlong)
        return std::abs(d.x) + std::abs(d.z) < 1e-6;
    return (layout.kind == Parameterization::Sphere || layout.kind == Parameterization::Angular) && d.z < -0.9999;
}

} // namespace

TEST_F(Texture, LooksUpWhatTheCoreLooksUpAcrossEverySeam)
{
    const auto directions = manyDirections();
    std::vector<MapLayout> layouts = everyLayout(32);
    layouts.push_back({Parameterization::Paraboloid, 32, 0});
    layouts.push_back({Parameterization::Octahedral, 31, 0});
    layouts.push_back({Parameterization::Latlong, 7, 0});
    for (const MapLayout& layout : layouts) {
        const EnvironmentMap map = noise(layout);
        const EnvironmentTexture texture(std::span(&map, 1), TexelFormat::Float);
        std::vector<glm::vec4> inputs;
        for (const glm::dvec3& d : directions)
            inputs.emplace_back(glm::vec3(d), 0.0f);
        const auto results = lookUp(texture, inputs);
        for (size_t i = 0; i < directions.size(); ++i) {
            if (hasManyPlaces(layout, directions[i]))
                continue;
            const glm::vec3 expected = map.radiance(directions[i]);
            for (int c = 0; c < 3; ++c) // single-precision coordinates, times a contrast of 1 a texel
                ASSERT_NEAR(results[i][c], expected[c], 1e-3) << name(layout.kind) << ' ' << layout.size << ' ' << directions[i].x << ' '
                                                              << directions[i].y << ' ' << directions[i].z;
        }
    }
}

TEST_F(Texture, LevelsBlendAsTheCoreBlendsThem)
{
    for (const MapLayout& layout : everyLayout(32)) {
        const MipPyramid pyramid = buildMipPyramid(environmentFrom(layout, smoothRadiance));
        const EnvironmentTexture texture(pyramid.levels, TexelFormat::Float);
        const auto directions = manyDirections(2000);
        std::vector<glm::vec4> inputs;
        for (size_t i = 0; i < directions.size(); ++i)
            inputs.emplace_back(glm::vec3(directions[i]), float(i % 64) * 0.1f);
        const auto results = lookUp(texture, inputs);
        for (size_t i = 0; i < inputs.size(); ++i) {
            if (hasManyPlaces(layout, directions[i]))
                continue;
            const glm::vec3 expected = radiance(pyramid, directions[i], inputs[i].w);
            ASSERT_LT(glm::distance(glm::vec3(results[i]), expected), 2e-3f) << name(layout.kind) << " level " << inputs[i].w;
        }
    }
}

TEST_F(Texture, HalvesKeepASunThatIsTooBrightForThem)
{
    EnvironmentMap map = environmentFrom({Parameterization::Latlong, 16, 0}, [](const glm::dvec3&) { return glm::vec3(1e-3f); });
    std::fill_n(map.image.texel(8, 8), 3, 1e6f);
    const EnvironmentTexture texture(std::span(&map, 1), TexelFormat::Half);
    const auto results = lookUp(texture, {glm::vec4(glm::vec3(texelDirection(map.layout, 8, 8)), 0.0f), glm::vec4(0.0f, 1.0f, 0.0f, 0.0f)});
    EXPECT_NEAR(results[0].x / 1e6f, 1.0f, 2e-3f);
    EXPECT_NEAR(results[1].x / 1e-3f, 1.0f, 2e-2f);
}

// Every half, the middle between it and the next, and the floats beside that: where rounding turns. What would come after the largest is
// infinity.
TEST(HalfTexels, AreTheNearestOnesAndTiesGoToEven)
{
    const auto valueOf = [](int bits) {
        const int exponent = bits >> 10, mantissa = bits & 0x3ff;
        return exponent == 0 ? std::ldexp(static_cast<float>(mantissa), -24)
                             : std::ldexp(static_cast<float>(mantissa + 1024), exponent - 25);
    };
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (int bits = 0; bits < 0x7c00; ++bits)
        for (const int sign : {0, 0x8000}) {
            const float side = sign == 0 ? 1.0f : -1.0f, value = valueOf(bits), middle = 0.5f * (value + valueOf(bits + 1));
            ASSERT_EQ(halfBits(side * value), sign | bits);
            ASSERT_EQ(halfBits(side * middle), sign | (bits + bits % 2)) << middle;
            ASSERT_EQ(halfBits(side * std::nextafter(middle, 0.0f)), sign | bits) << middle;
            ASSERT_EQ(halfBits(side * std::nextafter(middle, infinity)), sign | (bits + 1)) << middle;
        }
    EXPECT_EQ(halfBits(infinity), 0x7c00);
    EXPECT_EQ(halfBits(std::numeric_limits<float>::max()), 0x7c00);
    EXPECT_GT(halfBits(std::numeric_limits<float>::quiet_NaN()) & 0x7fff, 0x7c00);
}

TEST_F(Texture, RefusesLevelsThatDoNotBelongTogether)
{
    const std::vector<EnvironmentMap> mixed{EnvironmentMap({Parameterization::Latlong, 8, 0}),
                                            EnvironmentMap({Parameterization::Cube, 4, 0})};
    EXPECT_THROW(EnvironmentTexture(mixed, TexelFormat::Half), InvalidArgument);
    EXPECT_THROW(EnvironmentTexture(std::vector<EnvironmentMap>{}, TexelFormat::Half), InvalidArgument);
    EnvironmentMap wrong({Parameterization::Latlong, 8, 0});
    wrong.image = Image(8, 8, 3);
    EXPECT_THROW(EnvironmentTexture(std::vector{wrong}, TexelFormat::Half), InvalidArgument);
}
