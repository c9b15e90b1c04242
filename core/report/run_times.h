#pragma once

#include <chrono>
#include <functional>
#include <utility>
#include <vector>

namespace mirrorball {

/// Wall times of repeated runs of one piece of work, in seconds.
struct RunTimes {
    std::vector<double> seconds{}; ///< in the order of the runs

    bool empty() const { return seconds.empty(); }
    double median() const; ///< 0 when there are none
    double shortest() const;
    double longest() const;
};

/// Seconds of one call.
template <typename Work>
double secondsOf(Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    std::forward<Work>(work)();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Calls `run`, which returns its own seconds, up to `times` times, but not again once `limit` seconds are spent.
RunTimes repeated(int times, double limit, const std::function<double()>& run);

/// How often that calls a run of so many seconds.
int repeats(int times, double limit, double seconds);

} // namespace mirrorball
