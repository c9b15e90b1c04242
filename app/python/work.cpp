#include "work.h"

#include "core/base/error.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

/// How long Ctrl-C may go unheard.
constexpr auto betweenSignals = std::chrono::milliseconds(20);

bool isMainThread()
{
    const py::module_ threading = py::module_::import("threading");
    const py::object main = threading.attr("main_thread")().attr("ident"), here = threading.attr("get_ident")();
    return main.equal(here);
}

/// What Python raised while C++ worked; the first of them counts. Touched by whoever holds the interpreter.
class Raised {
public:
    explicit Raised(std::stop_source& stop) : m_stop(stop) {}
    void keep(py::error_already_set error)
    {
        if (!m_error)
            m_error.emplace(std::move(error));
        m_stop.request_stop();
    }
    explicit operator bool() const { return m_error.has_value(); }
    void rethrow() const
    {
        if (m_error)
            throw py::error_already_set(*m_error);
    }

private:
    std::stop_source& m_stop;
    std::optional<py::error_already_set> m_error{};
};

/// Calls the body on a thread of its own, while this one looks for signals.
void runHearingSignals(const std::function<void()>& body, Raised& raised)
{
    std::mutex mutex;
    std::condition_variable ended;
    bool isDone = false;
    const std::jthread worker([&] {
        body();
        const std::lock_guard lock(mutex);
        isDone = true;
        ended.notify_one();
    });
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, betweenSignals, [&] { return isDone; })) {
        lock.unlock();
        {
            const py::gil_scoped_acquire held;
            if (!raised && PyErr_CheckSignals() != 0)
                raised.keep(py::error_already_set());
        }
        lock.lock();
    }
}

} // namespace

void runWork(int threads, const py::object& progress, const std::function<void(const JobControl&)>& body)
{
    if (threads < 0 || threads > 1024)
        throw InvalidArgument("threads: must lie in 0 (one per core) to 1024; it is " + std::to_string(threads));
    if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
        throw py::type_error("progress: must be None or a function of the share that is done");
    std::stop_source stop;
    Raised raised(stop);
    JobControl job{.stop = stop.get_token(), .threads = threads};
    if (!progress.is_none())
        job.progress = [&](float share) {
            const py::gil_scoped_acquire held;
            try {
                if (!raised)
                    progress(share);
            } catch (py::error_already_set& error) {
                raised.keep(std::move(error));
            }
        };
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            body(job);
        } catch (...) {
            failure = std::current_exception();
        }
    };
    const bool hearsSignals = isMainThread();
    {
        const py::gil_scoped_release released;
        if (hearsSignals)
            runHearingSignals(run, raised);
        else
            run();
    }
    raised.rethrow();
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace mirrorball::python
