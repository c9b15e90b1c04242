#pragma once

#include <stop_token>
#include <thread>

namespace mirrorball::cli {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a stop request while it lives. A second one ends the program at once, as without it.
/// Make it before the program starts other threads: they must inherit that the two signals are left to this one.
class Interrupt {
public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();

    std::stop_token token() const { return m_stop.get_token(); }
    bool wasRequested() const { return m_stop.stop_requested(); }

private:
    std::stop_source m_stop{};
    std::jthread m_waiter{};
};

} // namespace mirrorball::cli
