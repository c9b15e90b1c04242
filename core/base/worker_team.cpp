#include "worker_team.h"

#include "job.h"

namespace mirrorball {

namespace {

thread_local bool working = false;

} // namespace

WorkerTeam& WorkerTeam::ofThisThread()
{
    thread_local WorkerTeam team;
    return team;
}

bool WorkerTeam::isWorking() { return working; }

WorkerTeam::~WorkerTeam()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ends = true;
    }
    m_wake.notify_all();
    for (std::thread& thread : m_threads)
        thread.join();
}

void WorkerTeam::grow(size_t threads)
{
    needThreads(static_cast<int>(threads) + 1);
    while (m_threads.size() < threads)
        m_threads.emplace_back([this] { loop(); });
}

void WorkerTeam::loop()
{
    working = true;
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_ends || m_wanted > 0; });
        if (m_ends)
            return;
        --m_wanted;
        ++m_running;
        const std::function<void()>& work = *m_work;
        lock.unlock();
        work();
        lock.lock();
        if (--m_running == 0)
            m_ended.notify_one();
    }
}

void WorkerTeam::run(int workers, const std::function<void()>& work)
{
    if (workers <= 1 || working) {
        work();
        return;
    }
    grow(static_cast<size_t>(workers) - 1);
    {
        const std::lock_guard lock(m_mutex);
        m_work = &work;
        m_wanted = workers - 1;
    }
    for (int i = 1; i < workers; ++i)
        m_wake.notify_one();
    working = true;
    work();
    working = false;
    std::unique_lock lock(m_mutex);
    m_wanted = 0;
    m_ended.wait(lock, [this] { return m_running == 0; });
}

} // namespace mirrorball
