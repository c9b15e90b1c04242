#include "gl_fixture.h"

#include "core/filter/lookup_table.h"

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;

using BrdfLookupsShader = mirrorball::test::GlTest;

TEST_F(BrdfLookupsShader, ReadsTheTableAsTheLibraryDoes)
{
    const int columns = 6;
    const Image table = makeLookupTable(brdfFromText("ggx:alpha=0.81,metal=gold"), {LookupKind::Fitted, 5}, columns);
    ASSERT_GT(std::abs(table.texel(1, 2)[2]), 0.1f) << "some lookups lie beside the plane of incidence";
    const GlObject texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(texture, 1, GL_RGB32F, table.width, table.height);
    glTextureSubImage2D(texture, 0, 0, 0, table.width, table.height, GL_RGB, GL_FLOAT, table.texels.data());
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);

    // r at +Z, its meridian towards +Y: the normal lies in the plane of Y and Z; a lookup is moved by the offset in it and then turned out
    // of it, positive towards -X, which is r x n.
    std::vector<glm::vec4> inputs;
    for (int i = 1; i < 60; ++i)
        inputs.emplace_back(float(i) * 0.025f, 0.0f, 0.0f, 0.0f);
    for (int k = 0; k < 5; ++k) {
        const std::string call = "#include \"lib/brdf_lookups.glsl\"\nuniform sampler2D lookups;\n"
                                 "BrdfLookup at(float t) { return brdfLookup(lookups, " +
                                 std::to_string(k) + ", vec3(0.0, sin(t), cos(t)), vec3(0.0, 0.0, 1.0)); }\n";
        const auto prepare = [&](const ShaderProgram& program) {
            glBindTextureUnit(1, texture);
            program.set("lookups", 1);
        };
        const auto places =
            test::evaluateGlsl(call + "vec4 twin(vec4 x) { return vec4(at(x.x).axis, at(x.x).alpha); }", inputs, {}, prepare);
        const auto weights =
            test::evaluateGlsl(call + "vec4 twin(vec4 x) { return vec4(at(x.x).weight, brdfLookupCount(lookups)); }", inputs, {}, prepare);
        for (size_t i = 0; i < inputs.size(); ++i) {
            const double view = inputs[i].x;
            const BrdfLookup expected = lookupsAt(table, view).lookups.at(static_cast<size_t>(k));
            const double c = std::cos(expected.turn);
            const glm::dvec3 axis(-std::sin(expected.turn), c * std::sin(expected.offset), c * std::cos(expected.offset));
            EXPECT_LT(glm::distance(glm::dvec3(places[i]), axis), 2e-4) << view;
            EXPECT_NEAR(places[i].w, expected.alpha, 1e-4) << view;
            EXPECT_LT(glm::distance(glm::dvec3(weights[i]), expected.weight), 1e-3) << view;
            EXPECT_EQ(weights[i].w, 5.0f);
        }
    }
}
