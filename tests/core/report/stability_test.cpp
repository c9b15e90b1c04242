#include "core/report/stability.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace mirrorball
