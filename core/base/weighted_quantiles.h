#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace mirrorball {

struct WeightedValue {
    double value, weight; ///< a weight is not negative
};

/// For each share in [0, 1], the smallest of the values at which so much of the whole weight is reached. 0 where there is no value.
/// @param shares  in rising order
template <std::size_t Count>
std::array<double, Count> weightedQuantiles(std::vector<WeightedValue> values, const std::array<double, Count>& shares)
{
    double total = 0.0, passed = 0.0;
    for (const WeightedValue& v : values)
        total += v.weight;
    std::sort(values.begin(), values.end(), [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
    std::array<double, Count> found{};
    found.fill(values.empty() ? 0.0 : values.back().value); // where rounding keeps the sum from getting there
    std::size_t next = 0;
    for (const WeightedValue& v : values) {
        passed += v.weight;
        for (; next < Count && passed >= shares[next] * total; ++next)
            found[next] = v.value;
    }
    return found;
}

} // namespace mirrorball
