#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace mirrorball {

struct WeightedValue {
    double value, weight; ///< a weight is not negative
};

namespace weighted_quantiles {

/// Whole numbers in the order of the values.
inline std::uint64_t rank(double value)
{
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return bits & sign ? ~bits : bits | sign;
}

/// Finds among the values, before which others of the weight `passed` lie, those at which the sums are reached. They are shared out to
/// buckets, and only those buckets are looked into in which one of them lies.
inline void find(std::span<WeightedValue> values, double passed, std::span<const double> sums, double* found)
{
    constexpr size_t few = 32, buckets = 1024;
    constexpr int bucketBits = 10;
    const auto rises = [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; };
    if (sums.empty() || values.empty())
        return;
    if (values.size() <= few) {
        std::sort(values.begin(), values.end(), rises);
        std::fill_n(found, sums.size(), values.back().value); // where rounding keeps the sum from getting there
        auto sum = sums.begin();
        for (const WeightedValue& v : values) {
            passed += v.weight;
            for (; sum != sums.end() && passed >= *sum; ++sum)
                *found++ = v.value;
        }
        return;
    }
    std::uint64_t low = ~std::uint64_t{0}, high = 0;
    for (const WeightedValue& v : values) {
        low = std::min(low, rank(v.value));
        high = std::max(high, rank(v.value));
    }
    if (low == high) {
        std::fill_n(found, sums.size(), values.front().value);
        return;
    }
    const int shift = std::max(0, static_cast<int>(std::bit_width(high - low)) - bucketBits);
    const auto bucketOf = [low, shift](const WeightedValue& v) { return static_cast<size_t>((rank(v.value) - low) >> shift); };
    std::array<double, buckets> weights{};
    for (const WeightedValue& v : values)
        weights[bucketOf(v)] += v.weight;
    std::vector<WeightedValue> inside;
    const size_t last = static_cast<size_t>((high - low) >> shift);
    for (size_t bucket = 0; !sums.empty(); ++bucket) {
        const double next = passed + weights[bucket];
        const auto beyond = bucket < last ? std::find_if(sums.begin(), sums.end(), [next](double sum) { return sum > next; }) : sums.end();
        if (const auto here = static_cast<size_t>(beyond - sums.begin()); here > 0) {
            inside.clear();
            std::copy_if(values.begin(), values.end(), std::back_inserter(inside),
                         [&](const WeightedValue& v) { return bucketOf(v) == bucket; });
            find(inside, passed, sums.first(here), found);
            found += here;
            sums = sums.subspan(here);
        }
        passed = next;
    }
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
    weighted_quantiles::find(values, 0.0, sums, found.data());
    return found;
}

} // namespace mirrorball
