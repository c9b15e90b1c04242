#include "core/base/weighted_quantiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace mirrorball {
namespace {

/// By sorting all of them, as the definition says.
double plainQuantile(std::vector<WeightedValue> values, double share)
{
    std::sort(values.begin(), values.end(), [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
    double total = 0.0, passed = 0.0;
    for (const WeightedValue& v : values)
        total += v.weight;
    for (const WeightedValue& v : values)
        if ((passed += v.weight) >= share * total)
            return v.value;
    return values.back().value;
}

// Weights are whole numbers, so that sums are the same in any order.
TEST(WeightedQuantiles, AreThoseOfTheSortedValues)
{
    std::mt19937 random(3);
    for (const size_t count : {1u, 2u, 31u, 32u, 33u, 100u, 5000u})
        for (int round = 0; round < 10; ++round) {
            std::vector<WeightedValue> values;
            for (size_t i = 0; i < count; ++i)
                values.push_back({static_cast<double>(random() % (round < 5 ? 50u : 1000000u)) - 20.0, static_cast<double>(random() % 4u)});
            const std::array shares{0.0, 0.005, 0.5, 0.5, 0.995, 1.0};
            const auto found = weightedQuantiles(values, shares);
            for (size_t i = 0; i < shares.size(); ++i)
                ASSERT_EQ(found[i], plainQuantile(values, shares[i])) << count << " values, share " << shares[i];
        }
}

TEST(WeightedQuantiles, OfNothingAreZero) { EXPECT_EQ(weightedQuantiles({}, std::array{0.1, 0.9}), (std::array{0.0, 0.0})); }

} // namespace
} // namespace mirrorball
