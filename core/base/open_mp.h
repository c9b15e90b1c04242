#pragma once

namespace mirrorball {

/// libsharp runs on OpenMP's threads and takes their number from OpenMP's setting for the calling thread: this sets it for a scope, and
/// ends the threads after it. Left alone they would spin for ten milliseconds after each transform, beside whoever has work to do.
/// Within a parallelRows() it is one thread.
class OpenMpThreads {
public:
    /// @throws WorkError where the system cannot run so many: OpenMP itself would end the process
    explicit OpenMpThreads(int threads);
    ~OpenMpThreads();
    OpenMpThreads(const OpenMpThreads&) = delete;
    OpenMpThreads& operator=(const OpenMpThreads&) = delete;

private:
    int m_before;
    bool m_several;
};

} // namespace mirrorball
