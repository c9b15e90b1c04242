#include "core/report/shading_stability.h"
#include "core/report/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

namespace mirrorball {
namespace {

/// Every extreme case of filtering, with every method: done as promised, or refused with a reason that names the method.
class Stability : public ::testing::TestWithParam<Method> {};

TEST_P(Stability, HoldsInEveryCase)
{
    const Method method = GetParam();
    int ran = 0;
    for (const StabilityCase& test : stabilityCases()) {
        const StabilityRow row = runStability(test, method, {.threads = 1});
        if (!row.refused.empty()) {
            EXPECT_NE(row.refused.find(name(method)), std::string::npos) << row.refused;
            continue;
        }
        ++ran;
        for (const std::string& failure : row.failures)
            ADD_FAILURE() << test.name << ", " << name(method) << ": " << failure;
    }
    EXPECT_GT(ran, 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, Stability, ::testing::ValuesIn(allMethods),
                         [](const auto& method) { return std::string(name(method.param)); });

/// A verdict says something only if it can fail: the same outcome passes, and with a fault in its map does not.
TEST(StabilityTable, SeesAFaultPlantedInEachPromise)
{
    StabilityCase test = stabilityCases().front();
    ASSERT_TRUE(test.name.starts_with("sun of 1e6")) << test.name;
    test.lobe = phongLobe(50.0);
    FilterSource source = test.source({});
    const PrefilterOptions options{.lobe = test.lobe, .target = test.target, .tolerance = test.tolerance};
    const PrefilterOutcome outcome = prefilter(source, options);
    const EnvironmentMap expected = prefilter(source, {.lobe = test.lobe, .target = test.target, .method = Method::Reference}).map;
    const auto verdictOf = [&](const std::function<void(std::vector<float>&)>& plant) {
        PrefilterOutcome changed = outcome;
        plant(changed.map.image.texels);
        std::string failures;
        for (const std::string& failure : judgeStability(test, changed, outcome.predicted.relRms, expected).failures)
            failures += failure + "; ";
        return failures;
    };
    EXPECT_EQ(verdictOf([](std::vector<float>&) {}), "");
    EXPECT_NE(verdictOf([](std::vector<float>& t) { t[0] = std::nanf(""); }).find("not finite"), std::string::npos);
    // The sun's image alone: the root mean square sees it, the median does not.
    const auto brighten = [](std::vector<float>& t) { *std::max_element(t.begin(), t.end()) *= 1.001f; };
    EXPECT_NE(verdictOf(brighten).find("rel_rms"), std::string::npos);
    // All of the sky, which is nothing beside the sun.
    const auto darken = [](std::vector<float>& t) {
        std::vector<float> sorted = t;
        std::sort(sorted.begin(), sorted.end());
        for (float& v : t)
            v = v < sorted[sorted.size() * 3 / 4] ? 1.01f * v : v;
    };
    EXPECT_NE(verdictOf(darken).find("median_rel"), std::string::npos);
    EXPECT_EQ(verdictOf(darken).find("rel_rms"), std::string::npos) << "the root mean square alone would not have seen it";
    // A few texels of it.
    const auto spoil = [](std::vector<float>& t) {
        std::vector<float> sorted = t;
        std::sort(sorted.begin(), sorted.end());
        for (float& v : t)
            v = v < sorted[sorted.size() / 20] ? 3.0f * v : v;
    };
    EXPECT_NE(verdictOf(spoil).find("p99_rel"), std::string::npos);
    EXPECT_EQ(verdictOf(spoil).find("median_rel"), std::string::npos);
    const auto negative = [](std::vector<float>& t) {
        const float mean = std::accumulate(t.begin(), t.end(), 0.0f) / static_cast<float>(t.size());
        *std::min_element(t.begin(), t.end()) = -1e-5f * mean;
    };
    EXPECT_NE(verdictOf(negative).find("negative"), std::string::npos);
}

TEST(StabilityTable, SeesAFaultPlantedInAConstantAndInAnApproximation)
{
    const std::vector<StabilityCase> cases = stabilityCases();
    const auto constant =
        std::find_if(cases.begin(), cases.end(), [](const StabilityCase& c) { return c.constant && c.lobe == diffuseLobe(); });
    ASSERT_NE(constant, cases.end());
    FilterSource source = constant->source({});
    for (const Method method : {Method::Auto, Method::Importance, Method::Mip, Method::Sh9}) {
        const PrefilterOptions options{.lobe = constant->lobe, .target = constant->target, .method = method};
        PrefilterOutcome outcome = prefilter(source, options);
        const EnvironmentMap expected =
            prefilter(source, {.lobe = constant->lobe, .target = constant->target, .method = Method::Reference}).map;
        const double predicted = informedErrors(outcome, options, source).relRms;
        EXPECT_TRUE(judgeStability(*constant, outcome, predicted, expected).holds()) << name(method);
        for (float& v : outcome.map.image.texels)
            v *= 1.3f;
        EXPECT_FALSE(judgeStability(*constant, outcome, predicted, expected).holds()) << name(method);
    }
}

TEST(StabilityTable, AutoNeverPicksAMethodThatRefuses)
{
    for (const StabilityCase& test : stabilityCases()) {
        const FilterSource source = test.source({});
        const PrefilterOptions options{.lobe = test.lobe, .target = test.target, .tolerance = test.tolerance, .knobs = test.knobs};
        const PrefilterPlan plan = planPrefilter(options, traits(source));
        EXPECT_NE(plan.method, Method::Auto);
        EXPECT_EQ(refusal(plan.method, options, traits(source)), "") << test.name;
    }
}

TEST(ShadingStability, HoldsInEveryCaseAndSeesAFaultPlantedInEach)
{
    std::set<std::string> families;
    for (const ShadingCase& test : shadingCases()) {
        families.insert(test.family);
        const ShadingCase::Values computed = test.compute({.threads = 1});
        const ShadingRow row = judgeShading(test, computed);
        EXPECT_TRUE(row.holds()) << test.family << ", " << test.name << ": " << (row.holds() ? "" : row.failures.front());
        EXPECT_GT(row.places, 4u) << test.name;
        for (const double fault : {std::nan(""), 1e-4, -3.0}) {
            ShadingCase::Values spoiled = computed;
            double& value = spoiled.values[spoiled.values.size() / 3];
            value = std::isnan(fault) ? fault : value + fault;
            EXPECT_FALSE(judgeShading(test, spoiled).holds()) << test.family << ", " << test.name << ": " << fault;
        }
    }
    EXPECT_EQ(families, (std::set<std::string>{"Fresnel, dielectric", "Fresnel, conductor", "lambda", "sphere map", "painted map"}));
}

} // namespace
} // namespace mirrorball
