#include "gl_fixture.h"

#include "core/filter/lookup_table.h"
#include "core/filter/reflection_frame.h"

#include <cmath>

using namespace mirrorball;
using namespace mirrorball::preview;

using BrdfLookupsShader = mirrorball::test::GlTest;

TEST_F(BrdfLookupsShader, ReadsTheTableAsTheLibraryDoes)
{
    const int columns = 6;
    const Image table = makeLookupTable(brdfFromText("ggx:alpha=0.3,metal=gold"), {LookupKind::Fitted, 2}, columns);
    const GlObject texture = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(texture, 1, GL_RGB32F, table.width, table.height);
    glTextureSubImage2D(texture, 0, 0, 0, table.width, table.height, GL_RGB, GL_FLOAT, table.texels.data());
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);

    // r at +Z, its meridian towards +Y: the normal lies in the plane of Y and Z, and a lookup moved by the offset does too.
    std::vector<glm::vec4> inputs;
    for (int i = 1; i < 60; ++i)
        inputs.emplace_back(float(i) * 0.025f, 0.0f, 0.0f, 0.0f);
    for (int k = 0; k < 2; ++k) {
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
            const glm::dvec3 axis = normalAt({0.0, 0.0, 1.0}, {expected.offset, 0.0});
            EXPECT_LT(glm::distance(glm::dvec3(places[i]), axis), 2e-4) << view;
            EXPECT_NEAR(places[i].w, expected.alpha, 1e-4) << view;
            EXPECT_LT(glm::distance(glm::dvec3(weights[i]), expected.weight), 1e-3) << view;
            EXPECT_EQ(weights[i].w, 2.0f);
        }
    }
}
