#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mirrorball {

/// Threads that one thread shares its loops with. They sleep between loops: what spins instead takes the time of whoever has work, ten
/// milliseconds a loop with OpenMP's defaults.
class WorkerTeam {
public:
    /// The calling thread's own; its threads end with it.
    static WorkerTeam& ofThisThread();

    WorkerTeam() = default;
    WorkerTeam(const WorkerTeam&) = delete;
    WorkerTeam& operator=(const WorkerTeam&) = delete;
    ~WorkerTeam();

    /// Runs `work` on this thread and on up to workers - 1 others at once, and returns when all that began it have ended it: a short
    /// `work` waits for none that is slow to wake. It must not throw. Within it run() runs `work` once, on the thread that calls.
    /// @throws WorkError where the system starts too few threads
    void run(int workers, const std::function<void()>& work);

    /// Whether the calling thread is within run() of several workers.
    static bool isWorking();

private:
    void grow(size_t threads);
    void loop();

    std::mutex m_mutex{}; // guards what follows
    std::condition_variable m_wake{}, m_ended{};
    const std::function<void()>* m_work = nullptr;
    int m_wanted = 0;  ///< threads that may still begin m_work
    int m_running = 0; ///< threads within it
    bool m_ends = false;
    std::vector<std::thread> m_threads{};
};

} // namespace mirrorball
