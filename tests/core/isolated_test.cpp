#include "core/base/isolated.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

using namespace mirrorball;

TEST(Isolated, ReturnsWhatTheWorkReturned)
{
    const std::string large(std::size_t{5} << 20, 'x');
    EXPECT_EQ(runIsolated({}, {}, [&] { return large; }), large);
    EXPECT_EQ(runIsolated({}, {}, [] { return std::string(); }), "");
}

TEST(Isolated, ErrorsKeepTheirMessage)
{
    try {
        runIsolated({}, {}, []() -> std::string { throw FileError("x.obj", "is damaged"); });
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_STREQ(error.what(), "x.obj: is damaged");
    }
}

TEST(Isolated, ACrashIsNoCrashHere)
{
    EXPECT_EQ(runIsolated({}, {},
                          []() -> std::string {
                              std::raise(SIGKILL);
                              return "x";
                          }),
              std::nullopt);
    EXPECT_EQ(runIsolated({}, {}, []() -> std::string { throw std::runtime_error("of a library"); }), std::nullopt);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Isolated, MemoryWithoutEndEnds)
{
    const auto hungry = []() -> std::string {
        std::vector<std::string> kept;
        for (;;)
            kept.emplace_back(std::size_t{16} << 20, 'x');
    };
    EXPECT_EQ(runIsolated({.memoryBytes = std::uintmax_t{128} << 20}, {}, hungry), std::nullopt);
}
#endif

TEST(Isolated, AStopRequestEndsTheChild)
{
    std::stop_source stop;
    const std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stop.request_stop();
    });
    const auto endless = []() -> std::string {
        for (;;)
            std::this_thread::sleep_for(std::chrono::seconds(1));
    };
    EXPECT_THROW(runIsolated({}, {.stop = stop.get_token()}, endless), Cancelled);
}
