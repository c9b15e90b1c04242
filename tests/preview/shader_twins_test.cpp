#include "gl_fixture.h"
#include "test_environments.h"

#include "core/preview/bound_map.h"
#include "core/preview/texture.h"
#include "core/shading/conductor.h"
#include "core/shading/fresnel.h"
#include "core/shading/lambda.h"

#include <cmath>
#include <string>

using namespace mirrorball;
using namespace mirrorball::preview;
using namespace mirrorball::test;

using ShaderTwins = mirrorball::test::GlTest;

namespace {

std::vector<glm::vec4> asInputs(const std::vector<glm::dvec3>& directions, float w = 0.0f)
{
    std::vector<glm::vec4> inputs;
    for (const glm::dvec3& d : directions)
        inputs.emplace_back(glm::vec3(d), w);
    return inputs;
}

/// The shader that calls a mapping's function for a direction in xyz.
std::string twinOf(const MapLayout& layout, const char* what)
{
    return "#include \"lib/mappings.glsl\"\n"
           "vec4 widened(vec3 v) { return vec4(v, 0.0); }\n"
           "vec4 widened(float v) { return vec4(v); }\n"
           "vec4 twin(vec4 d) { return widened(" +
           shaderFunction(layout.kind, what) + "(d.xyz, " + std::to_string(layout.size) + ".0, " + std::to_string(layout.border) +
           ".0)); }";
}

} // namespace

TEST_F(ShaderTwins, FresnelOfDielectrics)
{
    for (const double n : {1.0, 1.0 + 1e-9, 1.0001, 1.5, 5.0, 200.0, 1e6, 0.9, 0.5}) {
        std::vector<glm::vec4> inputs;
        for (int i = 0; i <= 2000; ++i)
            inputs.emplace_back(float(i) / 2000.0f, float((n - 1.0) * (n + 1.0)), 0.0f, 0.0f);
        const auto results =
            evaluateGlsl("#include \"lib/fresnel.glsl\"\nvec4 twin(vec4 x) { return vec4(fresnelDielectric(x.x, x.y)); }", inputs);
        for (size_t i = 0; i < inputs.size(); ++i) {
            const double expected = fresnelDielectric(inputs[i].x, n);
            // Near the critical angle F is as steep as a square root, which lifts 1e-7 to 1e-3.
            const double critical = n < 1.0 ? std::sqrt(1.0 - n * n) : -1.0;
            const double tolerance = std::abs(inputs[i].x - critical) < 1e-3 ? 5e-3 : 1e-5;
            ASSERT_NEAR(results[i].x, expected, tolerance) << "n " << n << " cos " << inputs[i].x;
        }
    }
}

TEST_F(ShaderTwins, FresnelOfConductors)
{
    std::vector<ConductorIndex> indices{{{1.0, 1.5, 3.0}, {100.0, 1e-3, 0.5}}, {{0.05, 1.0, 40.0}, {4.0, 0.01, 40.0}}};
    for (const Conductor& metal : conductors())
        indices.push_back(metal.index);
    for (const ConductorIndex& index : indices) {
        std::vector<glm::vec4> inputs;
        for (int i = 0; i <= 1000; ++i)
            inputs.emplace_back(float(i) / 1000.0f, 0.0f, 0.0f, 0.0f);
        const auto results = evaluateGlsl("#include \"lib/fresnel.glsl\"\nuniform vec3 n;\nuniform vec3 k;\n"
                                          "vec4 twin(vec4 x) { return vec4(fresnelConductor(x.x, n, k), 0.0); }",
                                          inputs, {}, [&](const ShaderProgram& program) {
                                              program.set("n", glm::vec3(index.n));
                                              program.set("k", glm::vec3(index.k));
                                          });
        for (size_t i = 0; i < inputs.size(); ++i) {
            const glm::dvec3 expected = fresnelConductor(inputs[i].x, index);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(results[i][c], expected[c], 5e-5) << "n " << index.n[c] << " k " << index.k[c] << " cos " << inputs[i].x;
        }
    }
}

TEST_F(ShaderTwins, LambdaByAngle)
{
    std::vector<glm::vec4> inputs;
    for (int i = 0; i <= 400; ++i)
        for (const float lambda : {0.0f, 2.5f, 7.0f})
            for (const float grazing : {0.0f, 1.0f, 3.0f})
                inputs.emplace_back(lambda, grazing, float(i) / 400.0f, 0.0f);
    const auto results = evaluateGlsl("#include \"lib/lambda.glsl\"\nvec4 twin(vec4 x) { return vec4(lambdaAt(x.x, x.y, x.z)); }", inputs);
    for (size_t i = 0; i < inputs.size(); ++i)
        ASSERT_NEAR(results[i].x, lambdaAt(inputs[i].x, inputs[i].y, inputs[i].z), 2e-5)
            << inputs[i].x << ' ' << inputs[i].y << ' ' << inputs[i].z;
}

TEST_F(ShaderTwins, CoordinatesOfEveryMapping)
{
    const auto directions = manyDirections();
    for (const Parameterization kind : allParameterizations) {
        if (kind == Parameterization::Cube) // its faces are the hardware's
            continue;
        const MapLayout layout{kind, 256, mapping(kind).hasBorder ? 4 : 0};
        const auto results = evaluateGlsl(twinOf(layout, "Coordinate"), asInputs(directions));
        for (size_t i = 0; i < directions.size(); ++i) {
            // Compared as directions: where a mapping is singular or cut (the poles, the rim) one direction has many coordinates.
            const glm::dvec2 p(double(results[i].x) + double(results[i].z) * layout.size, results[i].y);
            const glm::dvec3 back = direction(layout, p);
            // 1/400 texel; at the sphere map's rim the direction runs as the square root of the place.
            const bool isAtRim = layout.kind == Parameterization::Sphere && directions[i].z < -0.99;
            ASSERT_LT(glm::distance(back, glm::normalize(directions[i])), isAtRim ? 1e-3 : 6e-5)
                << name(layout.kind) << ' ' << directions[i].x << ' ' << directions[i].y << ' ' << directions[i].z;
            // Away from cuts the coordinates themselves agree.
            const glm::dvec2 expected = coordinate(layout, directions[i]);
            if (std::abs(directions[i].x) > 0.01 && directions[i].z > -0.9 && std::abs(directions[i].z) > 1e-4) {
                ASSERT_LT(glm::distance(p, expected), 5e-3) << name(layout.kind);
            }
        }
    }
}

TEST_F(ShaderTwins, TexelAnglesAreTheRootOfTheTexelsSolidAngle)
{
    const auto directions = manyDirections(1000);
    for (const Parameterization kind : allParameterizations) {
        if (mapping(kind).longestSide != 0.0) // the longer side of texels that are not square
            continue;
        const MapLayout layout{kind, 64, mapping(kind).hasBorder ? 3 : 0};
        const auto results = evaluateGlsl(twinOf(layout, "TexelAngle"), asInputs(directions));
        for (size_t i = 0; i < directions.size(); ++i) {
            if (layout.kind == Parameterization::Sphere && directions[i].z < -0.999)
                continue; // at the rim the density is cut off
            const double expected = std::sqrt(density(layout, coordinate(layout, directions[i])));
            if (expected > 0.0) {
                ASSERT_NEAR(results[i].x / expected, 1.0, 1e-4) << name(layout.kind);
            }
        }
    }
}

TEST_F(ShaderTwins, ToneCurvesAndSrgb)
{
    std::vector<glm::vec4> inputs;
    for (int i = 0; i <= 1000; ++i)
        inputs.emplace_back(std::exp2(-12.0f + 0.024f * float(i)), 0.0f, 0.0f, 0.0f);
    inputs.emplace_back(0.0f);
    const auto evaluate = [&](const std::string& expression) {
        return evaluateGlsl("#include \"lib/color.glsl\"\nvec4 twin(vec4 x) { return vec4(" + expression + ", 0.0); }", inputs);
    };
    const auto none = evaluate("toneCurve(x.xxx, 0)"), reinhard = evaluate("toneCurve(x.xxx, 1)"), filmic = evaluate("toneCurve(x.xxx, 2)");
    const auto srgb = evaluate("encodeSrgb(min(x.xxx, 1.0))");
    for (size_t i = 0; i < inputs.size(); ++i) {
        const double x = inputs[i].x, one = std::min(x, 1.0);
        ASSERT_NEAR(none[i].x, one, 1e-6);
        ASSERT_NEAR(reinhard[i].x, x / (1.0 + x), 1e-6);
        ASSERT_NEAR(filmic[i].x, std::min(1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)), 1e-5);
        ASSERT_NEAR(srgb[i].x, one <= 0.0031308 ? 12.92 * one : 1.055 * std::pow(one, 1.0 / 2.4) - 0.055, 2e-5);
    }
}
