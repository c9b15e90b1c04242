#include "job_processes.h"

#include "progress.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace mirrorball::cli {
namespace {

using Clock = std::chrono::steady_clock;

class Descriptor {
public:
    explicit Descriptor(int number = -1) : m_number(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int number() const { return m_number; }
    void close()
    {
        if (m_number >= 0)
            ::close(m_number);
        m_number = -1;
    }

private:
    int m_number;
};

WorkError cannotStart(int error)
{
    return WorkError(std::string("a process for a job cannot be started: ") + std::strerror(error) +
                     "; give fewer --jobs or allow more processes");
}

/// The end of a pipe that a process prints into, by lines.
class Lines {
public:
    explicit Lines(int descriptor) : m_descriptor(descriptor) {}
    int descriptor() const { return m_descriptor.number(); }

    /// Takes what has arrived. At the end of the file the last line may lack its break.
    void take(const std::function<void(const std::string&)>& line)
    {
        std::array<char, 4096> block{};
        const ssize_t count = ::read(m_descriptor.number(), block.data(), block.size());
        if (count < 0 && errno == EINTR)
            return;
        if (count > 0)
            m_text.append(block.data(), static_cast<size_t>(count));
        for (size_t end = m_text.find('\n'); end != std::string::npos; end = m_text.find('\n')) {
            line(m_text.substr(0, end));
            m_text.erase(0, end + 1);
        }
        constexpr size_t longestLine = size_t{1} << 16;
        if (!m_text.empty() && (count <= 0 || m_text.size() > longestLine)) {
            line(m_text);
            m_text.clear();
        }
        if (count <= 0)
            m_descriptor.close();
    }

private:
    Descriptor m_descriptor;
    std::string m_text{};
};

/// The two ends of a pipe that no other process inherits.
std::array<int, 2> newPipe()
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw cannotStart(errno);
    return ends;
}

/// Signals that this object takes from their usual way: read them from `descriptor()`.
class TakenSignals {
public:
    TakenSignals()
    {
        ::sigemptyset(&m_set);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD})
            ::sigaddset(&m_set, signal);
        ::pthread_sigmask(SIG_BLOCK, &m_set, &m_before);
        m_descriptor = ::signalfd(-1, &m_set, SFD_CLOEXEC | SFD_NONBLOCK);
        if (m_descriptor < 0) {
            ::pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
            throw cannotStart(errno);
        }
    }
    TakenSignals(const TakenSignals&) = delete;
    TakenSignals& operator=(const TakenSignals&) = delete;
    ~TakenSignals()
    {
        ::close(m_descriptor);
        ::pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }

    int descriptor() const { return m_descriptor; }
    /// The last of those that ask for an end; 0 where there is none.
    int takeEnding()
    {
        int ending = 0;
        signalfd_siginfo info{};
        while (::read(m_descriptor, &info, sizeof info) == static_cast<ssize_t>(sizeof info))
            if (info.ssi_signo != SIGCHLD)
                ending = static_cast<int>(info.ssi_signo);
        return ending;
    }

private:
    sigset_t m_set{}, m_before{};
    int m_descriptor = -1;
};

pid_t start(const ProgramCall& call, int out, int err)
{
    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
    ::posix_spawn_file_actions_addchdir_np(&files, call.folder.c_str());
    sigset_t none, usual;
    ::sigemptyset(&none);
    ::sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) // also where `nohup` had them ignored: this program answers for its calls
        ::sigaddset(&usual, signal);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &usual);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::vector<char*> words{const_cast<char*>("mirrorball")};
    for (const std::string& word : call.words)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    pid_t id = 0;
    const int error = ::posix_spawn(&id, "/proc/self/exe", &files, &attributes, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    if (error != 0)
        throw cannotStart(error);
    return id;
}

/// A call whose process runs. One that goes early takes its process with it.
class Running {
public:
    Running(size_t number, ProgramCall call) : m_number(number), m_label(call.label)
    {
        const auto out = newPipe();
        m_out = std::make_unique<Lines>(out[0]);
        const Descriptor outWriter(out[1]);
        const auto err = newPipe();
        m_err = std::make_unique<Lines>(err[0]);
        const Descriptor errWriter(err[1]);
        m_id = start(call, outWriter.number(), errWriter.number());
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running()
    {
        if (m_id > 0) {
            ::kill(m_id, SIGKILL);
            ::waitpid(m_id, nullptr, 0);
        }
    }

    size_t number() const { return m_number; }
    void forward(int signal) const { ::kill(m_id, signal); }

    void addTo(std::vector<pollfd>& watched) const
    {
        for (const Lines* lines : {m_out.get(), m_err.get()})
            if (lines->descriptor() >= 0)
                watched.push_back({lines->descriptor(), POLLIN, 0});
    }
    /// Takes what was printed on a descriptor that is ready, where it is one of this call's.
    void take(int ready, const JobProcesses::Events& events)
    {
        if (ready == m_out->descriptor())
            m_out->take([&](const std::string& line) { takeOut(line, events); });
        else if (ready == m_err->descriptor())
            m_err->take([&](const std::string& line) { takeErr(line); });
    }
    /// How it ended; none while it runs or has more to print.
    std::optional<CallEnd> end()
    {
        int status = 0;
        if (m_out->descriptor() >= 0 || m_err->descriptor() >= 0 || ::waitpid(m_id, &status, 0) != m_id)
            return std::nullopt;
        m_id = 0;
        return CallEnd{WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
                       std::chrono::duration<double>(Clock::now() - m_started).count(), false};
    }

private:
    void takeOut(const std::string& line, const JobProcesses::Events& events) const
    {
        int percent = 0;
        if (line.starts_with(openjdProgress) &&
            std::from_chars(line.data() + openjdProgress.size(), line.data() + line.size(), percent).ec == std::errc()) {
            events.progressed(m_number, static_cast<float>(percent) / 100.0f);
            return;
        }
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }
    void takeErr(const std::string& line) const
    {
        constexpr std::string_view own = "mirrorball: ";
        std::fprintf(stderr, "mirrorball: %s: %s\n", m_label.c_str(), line.c_str() + (line.starts_with(own) ? own.size() : 0));
    }

    size_t m_number;
    std::string m_label;
    std::unique_ptr<Lines> m_out{}, m_err{};
    pid_t m_id = 0;
    Clock::time_point m_started = Clock::now();
};

} // namespace

int JobProcesses::run(int atOnce, const Events& events)
{
    TakenSignals signals;
    std::vector<std::unique_ptr<Running>> running;
    int ending = 0;
    for (size_t number = 0, more = 1; more > 0 || !running.empty();) {
        while (more > 0 && ending == 0 && running.size() < static_cast<size_t>(atOnce)) {
            std::optional<ProgramCall> call = events.next();
            more = call ? 1 : 0;
            if (call)
                running.push_back(std::make_unique<Running>(number++, std::move(*call)));
            ending = std::max(ending, signals.takeEnding()); // one that came while a call was looked for
            if (ending != 0)
                for (const auto& each : running)
                    each->forward(ending);
        }
        if (running.empty())
            break;
        std::vector<pollfd> watched{{signals.descriptor(), POLLIN, 0}};
        for (const auto& each : running)
            each->addTo(watched);
        ::poll(watched.data(), watched.size(), -1);
        if (const int arrived = signals.takeEnding(); arrived != 0) {
            ending = arrived;
            for (const auto& each : running)
                each->forward(arrived);
        }
        for (size_t i = 1; i < watched.size(); ++i)
            if (watched[i].revents != 0)
                for (const auto& each : running)
                    each->take(watched[i].fd, events);
        std::erase_if(running, [&](const std::unique_ptr<Running>& each) {
            std::optional<CallEnd> end = each->end();
            if (end)
                end->wasStopped = ending != 0 && end->status != 0;
            if (end)
                events.ended(each->number(), *end);
            return end.has_value();
        });
    }
    return ending;
}

} // namespace mirrorball::cli
