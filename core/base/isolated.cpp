#include "isolated.h"

#include "error.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limitsMemory = false; // their shadow memory spans terabytes of addresses
#else
constexpr bool limitsMemory = true;
#endif

std::uintmax_t addressSpace()
{
    std::uintmax_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource resource, std::uintmax_t value)
{
    rlimit now{};
    ::getrlimit(resource, &now);
    const auto wanted = std::min(static_cast<rlim_t>(value), now.rlim_max);
    const rlimit limits{wanted, wanted};
    ::setrlimit(resource, &limits);
}

void writeAll(int pipe, const char* bytes, size_t count)
{
    while (count > 0) {
        const ssize_t written = ::write(pipe, bytes, count);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            ::_exit(3);
        bytes += written;
        count -= static_cast<size_t>(written);
    }
}

// Runs in the child and ends it. The first byte tells a result from a message.
[[noreturn]] void runChild(int pipe, const IsolationLimits& limits, std::uintmax_t memory, const std::function<std::string()>& work)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGPIPE})
        ::signal(signal, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, limits.seconds);
    if (limitsMemory)
        limit(RLIMIT_AS, memory);
    if (::freopen("/dev/null", "w", stderr) == nullptr) // what a failing library has to say on its way out
        ::_exit(3);
    std::string answer;
    try {
        answer = 'r' + work();
    } catch (const Error& error) {
        answer = std::string("e") + error.what();
    } catch (...) {
        ::_exit(2);
    }
    writeAll(pipe, answer.data(), answer.size());
    ::_exit(0);
}

// The child's end, awaited however this scope is left.
class Child {
public:
    explicit Child(pid_t id) : m_id(id) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        if (m_id <= 0)
            return;
        ::kill(m_id, SIGKILL);
        wait();
    }
    bool endedWell()
    {
        const int status = wait();
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

private:
    int wait()
    {
        int status = 0;
        while (::waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
        }
        m_id = 0;
        return status;
    }
    pid_t m_id;
};

struct Descriptor {
    int number;
    ~Descriptor() { ::close(number); }
};

} // namespace

std::optional<std::string> runIsolated(const IsolationLimits& limits, const JobControl& job, const std::function<std::string()>& work)
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw WorkError("no pipe to another process can be made; close some files or programs");
    const std::uintmax_t memory = addressSpace() + limits.memoryBytes;
    const pid_t id = ::fork();
    if (id == 0) {
        ::close(ends[0]);
        runChild(ends[1], limits, memory, work);
    }
    ::close(ends[1]);
    const Descriptor pipe{ends[0]};
    if (id < 0)
        throw WorkError("no other process can be started; close some programs");
    Child child(id);

    std::string answer;
    std::string chunk(size_t{1} << 20, '\0');
    for (;;) {
        job.checkStop();
        pollfd waiting{pipe.number, POLLIN, 0};
        if (::poll(&waiting, 1, 50) == 0)
            continue;
        const ssize_t count = ::read(pipe.number, chunk.data(), chunk.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            break;
        answer.append(chunk, 0, static_cast<size_t>(count));
    }
    if (!child.endedWell() || answer.empty())
        return std::nullopt;
    if (answer.front() == 'e')
        throw InvalidArgument(answer.substr(1));
    answer.erase(0, 1);
    return answer;
}

} // namespace mirrorball
