#include "helper_process.h"

#include "code_folder.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirrorball {

using helper::Answer;
using helper::Head;
using helper::Request;
using Clock = std::chrono::steady_clock;

namespace {

constexpr const char* programName = "mirrorball-helper";
/// Of HelperWork, as the helper is told on its command line.
constexpr std::array<const char*, 3> workWords{"pictures", "meshes", "payloads"};
constexpr std::uint64_t longestText = 4096;
constexpr std::uint64_t longestAnswer = std::uint64_t{4} << 30;

/// What a helper takes over from this process' environment: where libraries are, and how sanitizers report.
std::vector<std::string> helperEnvironment()
{
    // One thread: what a file may cost is processor time, and every further one takes address space.
    std::vector<std::string> kept{"LC_ALL=C.UTF-8", "OPENIMAGEIO_THREADS=1", "MALLOC_ARENA_MAX=2"};
    for (const char* name : {"LD_LIBRARY_PATH", "LD_PRELOAD", "ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS", "LSAN_OPTIONS"})
        if (const char* value = std::getenv(name))
            kept.push_back(std::string(name) + "=" + value);
    return kept;
}

struct SpawnActions {
    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
    SpawnActions()
    {
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawnattr_init(&attributes);
    }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions()
    {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }
};

constexpr bool isSanitized()
{
#ifdef MIRRORBALL_SANITIZED
    return true;
#else
    return false;
#endif
}

pid_t start(HelperWork work, int socket)
{
    const std::string program = helperProgram().string();
    SpawnActions actions;
    ::posix_spawn_file_actions_addopen(&actions.files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!isSanitized()) // else its findings would be lost
        ::posix_spawn_file_actions_addopen(&actions.files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions.files, socket, helper::channel);
    ::posix_spawn_file_actions_addclosefrom_np(&actions.files, helper::channel + 1);
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&actions.attributes, &none);
    ::posix_spawnattr_setsigdefault(&actions.attributes, &all);
    ::posix_spawnattr_setpgroup(&actions.attributes, 0); // Ctrl-C is for the program, whose end is the helper's
    ::posix_spawnattr_setflags(&actions.attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

    const std::string version = std::to_string(helper::version);
    std::array<const char*, 4> arguments{programName, workWords[static_cast<size_t>(work)], version.c_str(), nullptr};
    const std::vector<std::string> environment = helperEnvironment();
    std::vector<const char*> variables;
    for (const std::string& variable : environment)
        variables.push_back(variable.c_str());
    variables.push_back(nullptr);
    pid_t id = 0;
    const int error = ::posix_spawn(&id, program.c_str(), &actions.files, &actions.attributes, const_cast<char**>(arguments.data()),
                                    const_cast<char**>(variables.data()));
    if (error != 0)
        throw WorkError("the program that reads files of other formats cannot be started: " + std::string(std::strerror(error)) +
                        "; close some programs or allow more processes");
    return id;
}

} // namespace

std::filesystem::path helperProgram()
{
    const auto here = folderOfThisCode();
    std::error_code ignored;
    for (const std::filesystem::path& folder :
         {here, here / "../bin", here / "../../bin", here / MIRRORBALL_HELPER_FROM_BIN, std::filesystem::path(MIRRORBALL_HELPER_INSTALLED)})
        if (std::filesystem::exists(folder / programName, ignored))
            return folder / programName;
    throw WorkError("formats other than .exr and .hdr, and meshes, need " + std::string(programName) +
                    ", which is not installed; reinstall Mirrorball or convert the file");
}

/// A running helper and this side of its socket; ends with this object.
struct Helper::Process {
    HelperWork work;
    pid_t id = 0;
    int socket = -1;
    bool isNew = true;      ///< it has not answered yet under this owner
    bool isWorking = false; ///< a request is on its way
    Clock::time_point deadline{};

    explicit Process(HelperWork kind) : work(kind)
    {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
            throw WorkError("no connection to another process can be made; close some files or programs");
        socket = ends[0];
        try {
            id = start(kind, ends[1]);
        } catch (...) {
            ::close(ends[0]);
            ::close(ends[1]);
            throw;
        }
        ::close(ends[1]);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process()
    {
        ::close(socket);
        if (id > 0) // not awaited yet
            ::kill(id, SIGKILL);
        wait();
    }

    int wait()
    {
        int status = 0;
        while (id > 0 && ::waitpid(id, &status, 0) < 0 && errno == EINTR) {
        }
        id = 0;
        return status;
    }
    /// It is there and says nothing unasked.
    bool isReady() const
    {
        pollfd state{socket, POLLIN, 0};
        return ::poll(&state, 1, 0) == 0;
    }
};

namespace {

/// Helpers that wait for the next file. At most one of each kind is kept; each ends by itself when it has waited long enough.
template <class Process>
class Waiting {
public:
    std::unique_ptr<Process> take(HelperWork work)
    {
        const std::lock_guard lock(m_mutex);
        auto process = std::move(m_waiting[static_cast<size_t>(work)]);
        return process && process->isReady() ? std::move(process) : nullptr;
    }
    void keep(std::unique_ptr<Process> process)
    {
        const std::lock_guard lock(m_mutex);
        m_waiting[static_cast<size_t>(process->work)].swap(process); // the other one ends here
    }

private:
    std::mutex m_mutex;
    std::array<std::unique_ptr<Process>, workWords.size()> m_waiting;
};

template <class Process>
Waiting<Process>& waiting()
{
    static Waiting<Process> helpers; // ended with the process
    return helpers;
}

} // namespace

Helper::Helper(HelperWork work) : m_process(waiting<Process>().take(work))
{
    if (m_process)
        m_process->isNew = false;
    else
        m_process = std::make_unique<Process>(work);
}

Helper::~Helper()
{
    if (m_process && !m_process->isWorking)
        waiting<Process>().keep(std::move(m_process));
}

std::string Helper::ask(Request request, std::string_view bytes, const HelperLimits* limits, const JobControl& job)
{
    send(request, bytes, limits);
    const Head head = awaitHead(job);
    if (head.kind != static_cast<std::uint32_t>(Answer::Result))
        throwAnswer(head, job);
    if (head.size > longestAnswer)
        end("its answer is too long");
    std::string answer;
    while (answer.size() < head.size) { // grows as the bytes come: a size alone costs no memory
        const size_t before = answer.size();
        answer.resize(std::min<std::uint64_t>(head.size, before + std::max<size_t>(before, size_t{1} << 20)));
        receive(answer.data() + before, answer.size() - before, job);
    }
    m_process->isWorking = false;
    return answer;
}

void Helper::askInto(Request request, std::string_view bytes, void* answer, std::size_t size, const JobControl& job)
{
    send(request, bytes, nullptr);
    const Head head = awaitHead(job);
    if (head.kind != static_cast<std::uint32_t>(Answer::Result))
        throwAnswer(head, job);
    if (head.size != size)
        end("its answer has the wrong length");
    receive(answer, size, job);
    m_process->isWorking = false;
}

void Helper::tell(Request request) noexcept
{
    try {
        if (m_process) {
            send(request, {}, nullptr);
            m_process->isWorking = false;
        }
    } catch (...) { // it has ended
        m_process.reset();
    }
}

void Helper::send(Request request, std::string_view bytes, const HelperLimits* limits)
{
    if (!m_process)
        throw HelperEnded("it has ended before");
    Head head{.kind = static_cast<std::uint32_t>(request), .size = bytes.size()};
    if (limits) {
        head.milliseconds = static_cast<std::uint32_t>(limits->seconds * 1000.0);
        head.memory = limits->memoryBytes;
        m_process->deadline = Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(limits->seconds * 20e3) + 30'000);
    }
    m_process->isWorking = true;
    std::string message(reinterpret_cast<const char*>(&head), sizeof head);
    message += bytes;
    for (size_t sent = 0; sent < message.size();) {
        const ssize_t count = ::send(m_process->socket, message.data() + sent, message.size() - sent, MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0) {
            if (m_process->isNew || sent > 0 || !limits)
                end("it has ended");
            m_process = std::make_unique<Process>(m_process->work); // the one that waited had just gone
            send(request, bytes, limits);
            return;
        }
        sent += static_cast<size_t>(count);
    }
}

Head Helper::awaitHead(const JobControl& job)
{
    Head head;
    receive(&head, sizeof head, job);
    m_process->isNew = false;
    return head;
}

void Helper::receive(void* bytes, std::size_t size, const JobControl& job)
{
    auto* at = static_cast<char*>(bytes);
    for (std::size_t rest = size; rest > 0;) {
        try {
            job.checkStop();
        } catch (...) {
            m_process.reset();
            throw;
        }
        pollfd state{m_process->socket, POLLIN, 0};
        const int ready = ::poll(&state, 1, 50);
        if (ready <= 0) {
            if (Clock::now() > m_process->deadline)
                end("it takes too long");
            continue;
        }
        const ssize_t count = ::recv(m_process->socket, at, rest, 0);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            end({});
        at += count;
        rest -= static_cast<std::size_t>(count);
    }
}

void Helper::end(const std::string& reason)
{
    const auto process = std::move(m_process);
    if (!reason.empty())
        throw HelperEnded(reason);
    const int status = process->wait();
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGPROF || signal == SIGXCPU)
        throw HelperEnded("it takes too much time");
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw WorkError(helperProgram().string() + ": cannot run on this system; reinstall Mirrorball");
    throw HelperEnded(signal == SIGKILL || signal == SIGABRT ? "it takes too much memory or breaks the reader" : "it breaks the reader");
}

void Helper::throwAnswer(const Head& head, const JobControl& job)
{
    if (head.size > longestText)
        end("its answer is too long");
    std::string text(head.size, '\0');
    receive(text.data(), text.size(), job);
    m_process->isWorking = false;
    if (head.kind == static_cast<std::uint32_t>(Answer::Failed))
        throw WorkError(text);
    throw InvalidArgument(text);
}

} // namespace mirrorball
