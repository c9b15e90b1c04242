#include "job.h"

#include "error.h"
#include "sanitized.h"
#include "worker_team.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace mirrorball {

int JobControl::threadCount() const
{
    if (threads > 0)
        return threads;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void JobControl::checkStop() const
{
    if (stop.stop_requested())
        throw Cancelled();
}

JobControl partOf(const JobControl& job, float from, float to)
{
    JobControl part{.stop = job.stop, .progress = {}, .threads = job.threads};
    if (job.progress)
        part.progress = [progress = job.progress, from, to, reached = std::make_shared<float>(0.0f)](float fraction) {
            *reached = std::max(*reached, fraction);
            progress(from + (to - from) * *reached);
        };
    return part;
}

void needThreads(int threads)
{
    thread_local int proven = 1; // teams are each thread's own
    if (threads <= proven)
        return;
#ifndef MIRRORBALL_THREAD_SANITIZED
    const std::lock_guard serial([]() -> std::mutex& {
        static std::mutex mutex;
        return mutex;
    }());
    std::mutex gate;
    std::vector<std::jthread> trial;
    const std::unique_lock closed(gate); // all of them at a time; opened before they are joined
    try {
        for (int i = 1; i < threads; ++i)
            trial.emplace_back([&gate] { const std::lock_guard pass(gate); });
    } catch (const std::system_error&) {
        throw WorkError("only " + std::to_string(trial.size() + 1) + " of " + std::to_string(threads) +
                        " threads can be started; allow more processes or memory, or ask for fewer threads");
    }
#endif
    proven = threads;
}

void parallelRows(int rows, const JobControl& job, const std::function<void(int, int)>& body, int grain)
{
    if (rows <= 0)
        return;
    grain = std::max(1, grain);
    std::atomic<int> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex; // guards error and the progress callback
    std::exception_ptr error;
    int finished = 0;

    const auto work = [&] {
        try {
            for (;;) {
                if (failed.load(std::memory_order_relaxed))
                    return;
                job.checkStop();
                const int first = next.fetch_add(grain);
                if (first >= rows)
                    return;
                const int last = std::min(rows, first + grain);
                body(first, last);
                if (job.progress) {
                    const std::lock_guard lock(mutex);
                    finished += last - first;
                    job.progress(static_cast<float>(finished) / static_cast<float>(rows));
                }
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!error)
                error = std::current_exception();
            failed = true;
        }
    };

    const int chunks = (rows + grain - 1) / grain;
    const int workers = std::min(job.threadCount(), chunks);
    WorkerTeam::ofThisThread().run(workers, work);
    if (error)
        std::rethrow_exception(error);
}

} // namespace mirrorball
