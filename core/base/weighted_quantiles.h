#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace mirrorball {

struct WeightedValue {
    double value, weight; ///< a weight is not negative
};

namespace weighted_quantiles {

/// Finds in [first, last), before which values of the weight `passed` lie, those at which the sums [sum, sumEnd) are reached. Halves that
/// hold none of them are left unsorted.
template <typename Value>
void find(Value first, Value last, double passed, const double* sum, const double* sumEnd, double* found)
{
    constexpr std::ptrdiff_t few = 32;
    const auto rises = [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; };
    if (sum == sumEnd || first == last)
        return;
    if (last - first <= few) {
        std::sort(first, last, rises);
        std::fill(found, found + (sumEnd - sum), (last - 1)->value); // where rounding keeps the sum from getting there
        for (; first != last; ++first) {
            passed += first->weight;
            for (; sum != sumEnd && passed >= *sum; ++sum)
                *found++ = first->value;
        }
        return;
    }
    const Value middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, rises);
    double before = passed;
    for (Value v = first; v != middle; ++v)
        before += v->weight;
    const double* const beyond = std::find_if(sum, sumEnd, [before](double wanted) { return wanted > before; });
    find(first, middle, passed, sum, beyond, found);
    find(middle, last, before, beyond, sumEnd, found + (beyond - sum));
}

} // namespace weighted_quantiles

/// For each share in [0, 1], the smallest of the values at which so much of the whole weight is reached. 0 where there is no value.
/// @param shares  in rising order
template <std::size_t Count>
std::array<double, Count> weightedQuantiles(std::vector<WeightedValue> values, const std::array<double, Count>& shares)
{
    double total = 0.0;
    for (const WeightedValue& v : values)
        total += v.weight;
    std::array<double, Count> found{}, sums{};
    std::transform(shares.begin(), shares.end(), sums.begin(), [total](double share) { return share * total; });
    weighted_quantiles::find(values.begin(), values.end(), 0.0, sums.data(), sums.data() + Count, found.data());
    return found;
}

} // namespace mirrorball
