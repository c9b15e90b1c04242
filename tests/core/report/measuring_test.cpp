#include "core/report/peak_memory.h"
#include "core/report/run_times.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <ctime>
#include <memory>
#include <thread>

namespace mirrorball {
namespace {

TEST(RunTimes, TakeTheMedianOfOddAndEvenRuns)
{
    EXPECT_EQ((RunTimes{{3.0, 1.0, 2.0}}.median()), 2.0);
    EXPECT_EQ((RunTimes{{4.0, 1.0, 2.0, 3.0}}.median()), 2.5);
    EXPECT_EQ((RunTimes{{3.0, 1.0, 2.0}}.shortest()), 1.0);
    EXPECT_EQ((RunTimes{{3.0, 1.0, 2.0}}.longest()), 3.0);
    EXPECT_EQ(RunTimes{}.median(), 0.0);
}

TEST(RunTimes, AreRepeatedUntilTheirTimeIsSpentButAtLeastOnce)
{
    const auto aSecond = [] { return RunTime{.wall = 1.0, .cpu = 2.0}; };
    EXPECT_EQ(repeated(5, 100.0, aSecond).seconds.size(), 5u);
    EXPECT_EQ(repeated(5, 2.5, aSecond).seconds.size(), 3u); // the third begins before 2.5 s are spent
    EXPECT_EQ(repeated(5, 0.0, aSecond).seconds.size(), 1u);
}

TEST(RunTimes, CountTheProcessorsBesideTheClock)
{
    const RunTime asleep = timeOf([] { std::this_thread::sleep_for(std::chrono::milliseconds(50)); });
    EXPECT_GE(asleep.wall, 0.05);
    EXPECT_LT(asleep.cpu, 0.5 * asleep.wall);

    const auto computeFor = [](std::clock_t ticks) {
        for (const std::clock_t end = std::clock() + ticks; std::clock() < end;) {
        }
    };
    const RunTime busy = timeOf([&] { computeFor(CLOCKS_PER_SEC / 20); });
    EXPECT_NEAR(busy.cpu, 0.05, 0.01);
    EXPECT_LT(busy.cpu, busy.wall + 0.01);

    RunTimes times;
    for (const double cpu : {3.0, 1.0, 2.0})
        times.add({.wall = 0.5 * cpu, .cpu = cpu});
    EXPECT_EQ(times.cpuMedian(), 2.0);
    EXPECT_EQ(times.median(), 1.0);
}

/// Peak of allocating that many bytes and writing to all of them.
double megabytesOf(size_t megabytes)
{
    const PeakMemory watch;
    const size_t bytes = megabytes << 20;
    const auto block = std::make_unique_for_overwrite<char[]>(bytes);
    std::memset(block.get(), 1, bytes);
    const auto peak = watch.bytes();
    return peak && block[bytes / 2] == 1 ? static_cast<double>(*peak) / (1 << 20) : -1.0;
}

TEST(PeakMemory, CountsWhatAPieceOfWorkTakesEachTimeAnew)
{
    if (!PeakMemory().bytes())
        GTEST_SKIP() << "this system does not let the high-water mark be reset";
    // The second block could come from the pages of the first, and the third is smaller than the peak so far: neither must hide.
    EXPECT_NEAR(megabytesOf(64), 64.0, 3.0);
    EXPECT_NEAR(megabytesOf(64), 64.0, 3.0);
    EXPECT_NEAR(megabytesOf(20), 20.0, 3.0);
}

TEST(PeakMemory, SeesSmallBlocksThatEarlierWorkFreed)
{
    if (!PeakMemory().bytes())
        GTEST_SKIP() << "this system does not let the high-water mark be reset";
    const auto small = [] { // 32 MB in blocks of 1 kB, which the heap keeps when they are freed
        const PeakMemory watch;
        std::vector<std::unique_ptr<std::array<char, 1024>>> blocks;
        for (int i = 0; i < 32 * 1024; ++i) {
            blocks.push_back(std::make_unique<std::array<char, 1024>>());
            blocks.back()->fill(1);
        }
        return static_cast<double>(*watch.bytes()) / (1 << 20);
    };
    const double first = small();
    EXPECT_GE(first, 32.0);
    EXPECT_LE(first, 48.0); // with what the allocator adds: a fiftieth, or a sanitizer's half
    EXPECT_NEAR(small(), first, 2.0);
}

} // namespace
} // namespace mirrorball
