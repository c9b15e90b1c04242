#include "interrupt.h"

#include <csignal>
#include <ctime>

namespace mirrorball::cli {

namespace {

sigset_t interruptions()
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

} // namespace

Interrupt::Interrupt()
{
    const sigset_t set = interruptions();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    m_waiter = std::jthread([this, set](std::stop_token ended) {
        constexpr timespec tenth{0, 100'000'000};
        while (!ended.stop_requested()) {
            const int signal = sigtimedwait(&set, nullptr, &tenth);
            if (signal < 0)
                continue;
            if (m_stop.stop_requested()) { // the second one: this thread takes the signal with its usual effect
                std::signal(signal, SIG_DFL);
                pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
                raise(signal);
            }
            m_stop.request_stop();
        }
    });
}

Interrupt::~Interrupt()
{
    m_waiter = {}; // asks it to end and joins
    const sigset_t set = interruptions();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

} // namespace mirrorball::cli
