#pragma once

#include <chrono>
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

namespace mirrorball {

/// Of one run, in seconds: of the clock, and of all processors that the program had meanwhile, which what else a machine does hardly moves.
struct RunTime {
    double wall = 0.0, cpu = 0.0;
};

/// Times of repeated runs of one piece of work, in seconds.
struct RunTimes {
    std::vector<double> seconds{};    ///< of the clock, in the order of the runs
    std::vector<double> cpuSeconds{}; ///< of all processors; empty where they were not counted

    void add(const RunTime& run);
    bool empty() const { return seconds.empty(); }
    double median() const; ///< 0 when there are none
    double cpuMedian() const;
    double shortest() const;
    double longest() const;
};

template <typename Work>
RunTime timeOf(Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t before = std::clock();
    std::forward<Work>(work)();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC};
}

/// Seconds of one call, by the clock.
template <typename Work>
double secondsOf(Work&& work)
{
    return timeOf(std::forward<Work>(work)).wall;
}

/// Calls `run`, which returns its own times, up to `times` times, but not again once `limit` seconds of the clock are spent.
RunTimes repeated(int times, double limit, const std::function<RunTime()>& run);

/// How often that calls a run of so many seconds.
int repeats(int times, double limit, double seconds);

} // namespace mirrorball
