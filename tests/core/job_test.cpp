#include "core/base/error.h"
#include "core/base/job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mirrorball {
namespace {

TEST(ParallelRows, VisitsEveryRowOnce)
{
    for (const int threads : {1, 2, 5}) {
        std::vector<std::atomic<int>> visits(1003);
        parallelRows(1003, {.threads = threads}, [&](int first, int last) {
            for (int y = first; y < last; ++y)
                ++visits[static_cast<size_t>(y)];
        });
        for (const auto& count : visits)
            EXPECT_EQ(count, 1);
    }
}

TEST(ParallelRows, RethrowsTheErrorOfABody)
{
    EXPECT_THROW(parallelRows(100, {.threads = 2},
                              [](int first, int) {
                                  if (first >= 40)
                                      throw std::runtime_error("row 40");
                              }),
                 std::runtime_error);
}

TEST(ParallelRows, StopsBetweenRowsWhenAsked)
{
    std::stop_source source;
    std::atomic<int> rows{0};
    EXPECT_THROW(parallelRows(
                     10000, {.stop = source.get_token(), .threads = 2},
                     [&](int, int) {
                         if (++rows == 3)
                             source.request_stop();
                     },
                     1),
                 Cancelled);
    EXPECT_LT(rows, 100);
}

TEST(ParallelRows, ReportsProgressThatEndsAtOne)
{
    std::vector<float> seen;
    parallelRows(64, {.progress = [&](float f) { seen.push_back(f); }, .threads = 2}, [](int, int) {});
    ASSERT_FALSE(seen.empty());
    EXPECT_FLOAT_EQ(seen.back(), 1.0f);
}

TEST(ParallelRows, RunsALoopWithinALoopOnTheThreadThatIsThere)
{
    std::atomic<int> rows{0};
    parallelRows(
        8, {.threads = 3},
        [&](int first, int last) {
            for (int y = first; y < last; ++y) {
                const std::thread::id outer = std::this_thread::get_id();
                parallelRows(
                    5, {.threads = 3},
                    [&](int from, int to) {
                        EXPECT_EQ(std::this_thread::get_id(), outer);
                        rows += to - from;
                    },
                    1);
            }
        },
        1);
    EXPECT_EQ(rows, 8 * 5);
}

TEST(ParallelRows, KeepsItsThreadsFromLoopToLoopAndEachThreadItsOwn)
{
    std::mutex mutex;
    const auto idsOf = [&](int loops) {
        std::set<std::thread::id> ids;
        for (int i = 0; i < loops; ++i)
            parallelRows(
                64, {.threads = 3},
                [&](int, int) {
                    const std::lock_guard lock(mutex);
                    ids.insert(std::this_thread::get_id());
                },
                1);
        return ids;
    };
    const std::set<std::thread::id> here = idsOf(50);
    EXPECT_LE(here.size(), 3u);
    std::set<std::thread::id> there;
    std::thread([&] { there = idsOf(50); }).join();
    EXPECT_LE(there.size(), 3u);
}

// Threads that spin between loops would take all of the time here, on each core.
TEST(ParallelRows, TakesNoTimeBetweenLoops)
{
    timespec before{}, after{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
    constexpr int loops = 20, milliseconds = 5;
    for (int i = 0; i < loops; ++i) {
        parallelRows(
            4, {.threads = 4}, [](int, int) {}, 1);
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
    const double seconds = static_cast<double>(after.tv_sec - before.tv_sec) + 1e-9 * static_cast<double>(after.tv_nsec - before.tv_nsec);
    EXPECT_LT(seconds, 0.5 * 1e-3 * loops * milliseconds);
}

TEST(PartOf, FillsItsShareOfTheProgressAndNeverGoesBack)
{
    std::vector<float> reported;
    const JobControl whole{.progress = [&](float fraction) { reported.push_back(fraction); }};
    const JobControl part = partOf(whole, 0.5f, 0.75f);
    for (const float fraction : {0.0f, 1.0f, 0.0f, 0.5f})
        part.progress(fraction);
    EXPECT_EQ(reported, (std::vector<float>{0.5f, 0.75f, 0.75f, 0.75f}));
    EXPECT_FALSE(partOf({}, 0.0f, 1.0f).progress);
}

} // namespace
} // namespace mirrorball
