#pragma once

#include <functional>
#include <stop_token>

/// Stopping, progress and threads of one piece of work.
namespace mirrorball {

/// Handed into every operation that can take long. Copyable; the default neither stops nor reports and uses all cores.
struct JobControl {
    std::stop_token stop{};                ///< checked between rows; an operation that sees it throws Cancelled
    std::function<void(float)> progress{}; ///< fraction in [0, 1]; may be called from any worker, never concurrently
    int threads = 0;                       ///< 0: one per core; results never depend on it

    /// Threads to use: `threads`, or the number of cores when that is 0.
    int threadCount() const;
    /// @throws Cancelled when a stop was requested
    void checkStop() const;
};

/// The job of a part of the work: same stop and threads, and its progress, [0, 1], fills [from, to] of the whole's without ever going back,
/// however often the part starts to count anew.
JobControl partOf(const JobControl& job, float from, float to);

/// Asks the system once whether so many threads can run at a time: OpenMP ends the process where it can start none.
/// @throws WorkError
void needThreads(int threads);

/// The one loop driver: calls `body(first, last)` for disjoint row ranges that cover [0, rows), on job.threadCount() threads.
/// Ranges are handed out in chunks of `grain` rows, so rows may cost differently. The first exception of a body is rethrown here
/// after all workers have stopped; a stop request ends in Cancelled. Progress counts finished rows.
void parallelRows(int rows, const JobControl& job, const std::function<void(int first, int last)>& body, int grain = 8);

} // namespace mirrorball
