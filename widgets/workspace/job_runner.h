#pragma once

#include "core/base/job.h"

#include <QObject>
#include <QString>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace mirrorball::studio {

/// What becomes of the request that runs when a newer one comes.
enum class Running {
    Stop,   ///< its stop token fires and its result is dropped
    Finish, ///< it runs to its end and its result is used, for it is newer than what there is; for short work that repeats during a drag
};

/// One worker thread. The newest request wins: of those that wait only the last is kept.
///
/// Work gets its input by value and returns a result; the result is used on the thread that owns this object, unless it is stale by then.
/// The only place of the widgets where a worker's exceptions are caught: they come out as failed().
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(QObject* parent = nullptr);
    /// Stops what runs and waits for it.
    ~JobRunner() override;

    /// @param make  R(const JobControl&), on the worker
    /// @param use   void(R), here
    template <typename Make, typename Use>
    void start(Make make, Use use, Running running = Running::Stop)
    {
        enqueue(
            [make = std::move(make), use = std::move(use)](const JobControl& job) mutable -> Deliver {
                using Result = decltype(make(job));
                auto result = std::make_shared<Result>(make(job));
                return [result, use = std::move(use)]() mutable { use(std::move(*result)); };
            },
            running);
    }
    /// Stops what runs and forgets what waits; stopped() follows unless nothing was going on.
    void stop();
    /// From a request until its result was used, dropped or failed.
    bool isBusy() const { return m_pending > 0; }

signals:
    void busyChanged(bool busy);
    /// Fraction of the running request, in [0, 1].
    void progressed(double fraction);
    void stopped();
    void failed(const QString& message);

private:
    using Deliver = std::function<void()>;
    using Work = std::function<Deliver(const JobControl&)>;
    struct Request {
        Work work{};
        unsigned generation = 0;
        std::stop_source stop{};
    };

    void enqueue(Work work, Running running);
    void run(const std::stop_token& end);
    void finish(unsigned generation, const Deliver& deliver, const QString& error);
    void setPending(int pending);

    std::mutex m_mutex; ///< guards the two requests
    std::condition_variable_any m_wake;
    std::optional<Request> m_waiting;
    std::optional<std::stop_source> m_running;

    unsigned m_generation = 0; ///< of the newest request; the rest belongs to the owner's thread
    unsigned m_oldestWanted = 0;
    int m_pending = 0;
    std::jthread m_thread; ///< last: it ends first
};

} // namespace mirrorball::studio
