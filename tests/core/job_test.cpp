#include "core/base/error.h"
#include "core/base/job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
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
