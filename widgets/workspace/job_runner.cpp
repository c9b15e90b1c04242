#include "job_runner.h"

#include "core/base/error.h"
#include "core/base/failure.h"

#include <QElapsedTimer>
#include <QMetaObject>

#include <exception>

namespace mirrorball::studio {

namespace {

constexpr qint64 progressPeriod = 40; // ms: often enough to look smooth

} // namespace

JobRunner::JobRunner(QObject* parent) : QObject(parent), m_thread([this](const std::stop_token& end) { run(end); }) {}

JobRunner::~JobRunner()
{
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.reset();
        if (m_running)
            m_running->request_stop();
    }
    m_thread.request_stop();
    m_thread.join();
}

void JobRunner::enqueue(Work work, Running running)
{
    int pending = m_pending + 1;
    ++m_generation;
    if (running == Running::Stop)
        m_oldestWanted = m_generation;
    {
        const std::lock_guard lock(m_mutex);
        if (m_waiting)
            --pending;
        if (running == Running::Stop && m_running)
            m_running->request_stop();
        m_waiting = Request{std::move(work), m_generation, {}};
    }
    m_wake.notify_one();
    setPending(pending);
}

void JobRunner::stop()
{
    if (m_pending == 0)
        return;
    int pending = m_pending;
    m_oldestWanted = m_generation + 1;
    {
        const std::lock_guard lock(m_mutex);
        if (m_waiting)
            --pending;
        m_waiting.reset();
        if (m_running)
            m_running->request_stop();
    }
    setPending(pending);
    emit stopped();
}

void JobRunner::run(const std::stop_token& end)
{
    for (;;) {
        Request request;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, end, [this] { return m_waiting.has_value(); }))
                return;
            request = std::move(*m_waiting);
            m_waiting.reset();
            m_running = request.stop;
        }
        QElapsedTimer sinceReport;
        sinceReport.start();
        const JobControl job{.stop = request.stop.get_token(), .progress = [this, &sinceReport](float fraction) {
                                 if (sinceReport.elapsed() < progressPeriod)
                                     return;
                                 sinceReport.start();
                                 QMetaObject::invokeMethod(
                                     this, [this, fraction] { emit progressed(fraction); }, Qt::QueuedConnection);
                             }};
        Deliver deliver;
        QString error;
        try {
            deliver = request.work(job);
        } catch (const Cancelled&) {
        } catch (const std::exception& failure) {
            error = QString::fromStdString(messageOf(failure));
        }
        {
            const std::lock_guard lock(m_mutex);
            m_running.reset();
        }
        QMetaObject::invokeMethod(
            this, [this, generation = request.generation, deliver, error] { finish(generation, deliver, error); }, Qt::QueuedConnection);
    }
}

void JobRunner::finish(unsigned generation, const Deliver& deliver, const QString& error)
{
    if (generation >= m_oldestWanted) {
        if (deliver)
            deliver();
        else if (!error.isEmpty())
            emit failed(error);
    }
    setPending(m_pending - 1);
}

void JobRunner::setPending(int pending)
{
    const bool wasBusy = isBusy();
    m_pending = pending;
    if (isBusy() != wasBusy)
        emit busyChanged(isBusy());
}

} // namespace mirrorball::studio
