#include "core/report/peak_memory.h"
#include "core/report/run_times.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

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
    const auto aSecond = [] { return 1.0; };
    EXPECT_EQ(repeated(5, 100.0, aSecond).seconds.size(), 5u);
    EXPECT_EQ(repeated(5, 2.5, aSecond).seconds.size(), 3u); // the third begins before 2.5 s are spent
    EXPECT_EQ(repeated(5, 0.0, aSecond).seconds.size(), 1u);
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
