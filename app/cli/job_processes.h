#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mirrorball::cli {

/// A run of this program with other words.
struct ProgramCall {
    std::vector<std::string> words{}; ///< without the program's name
    std::filesystem::path folder{};   ///< where it runs
    std::string label{};              ///< stands before each line that it prints on stderr
};

/// How a call ended.
struct CallEnd {
    int status = 0; ///< its exit status, or 128 plus the signal that ended it
    double seconds = 0.0;
    bool wasStopped = false; ///< it failed after a signal had asked for the end, and may well succeed another time
};

/// Runs calls of this very program, each in a process of its own, so many at once. What one of them does to itself, the others do not see.
class JobProcesses {
public:
    struct Events {
        /// The next call; none when there are no more. Asked whenever there is room for one.
        std::function<std::optional<ProgramCall>()> next{};
        /// A call is so far: [0, 1], by its `openjd_progress` lines.
        std::function<void(size_t call, float fraction)> progressed{};
        std::function<void(size_t call, const CallEnd& end)> ended{};
    };

    /// Runs until there are no more calls, or until SIGINT, SIGTERM or SIGHUP arrives: that one goes on to the calls, which clean up and
    /// end. Other lines of their stdout go to stdout. @return the signal, 0 where none came
    /// @throws WorkError where no process can be started
    static int run(int atOnce, const Events& events);
};

} // namespace mirrorball::cli
