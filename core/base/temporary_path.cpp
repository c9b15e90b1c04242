#include "temporary_path.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace mirrorball {
namespace {

constexpr std::string_view mark = ".mirrorball-tmp";

// ---- what a signal removes: fixed memory, because a handler may neither allocate nor lock ------------------------------------------

enum SlotState { Free, Filling, Filled };
struct Slot {
    std::atomic<int> state{Free};
    std::array<char, 4096> path{};
};
std::array<Slot, 64> slots; // beyond these a path is left to the next process

int registerPath(const std::filesystem::path& path)
{
    const std::string& text = path.native();
    for (size_t i = 0; text.size() < slots[0].path.size() && i < slots.size(); ++i)
        if (int free = Free; slots[i].state.compare_exchange_strong(free, Filling)) {
            std::memcpy(slots[i].path.data(), text.c_str(), text.size() + 1);
            slots[i].state = Filled;
            return static_cast<int>(i);
        }
    return -1;
}

void unregister(int slot)
{
    if (slot >= 0)
        slots[static_cast<size_t>(slot)].state = Free;
}

/// Removes a file, or a folder with what is in it, by system calls alone. Links are removed, never followed.
void removeRaw(int folder, const char* name, int depth)
{
    if (::unlinkat(folder, name, 0) == 0 || depth > 3)
        return;
    const int inside = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (inside < 0)
        return;
    struct Entry { // linux_dirent64 of getdents64(2)
        std::uint64_t inode;
        std::int64_t offset;
        unsigned short length;
        unsigned char type;
        char name[1];
    };
    alignas(Entry) std::array<char, 2048> entries;
    for (;;) {
        const long count = ::syscall(SYS_getdents64, inside, entries.data(), entries.size());
        if (count <= 0)
            break;
        for (long at = 0; at < count;) {
            const auto* entry = reinterpret_cast<const Entry*>(entries.data() + at);
            if (std::strcmp(entry->name, ".") != 0 && std::strcmp(entry->name, "..") != 0)
                removeRaw(inside, entry->name, depth + 1);
            at += entry->length;
        }
    }
    ::close(inside);
    ::unlinkat(folder, name, AT_REMOVEDIR);
}

extern "C" void removeAndEnd(int signal)
{
    removeTemporaries();
    ::signal(signal, SIG_DFL);
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    ::raise(signal);
}

// ---- what dead processes left -----------------------------------------------------------------------------------------------------------

/// This machine by a number that others hardly share: FNV-1a of its name.
std::uint32_t machineNumber()
{
    std::array<char, 256> name{};
    static_cast<void>(::gethostname(name.data(), name.size() - 1));
    std::uint32_t number = 2166136261u;
    for (const char* c = name.data(); *c != '\0'; ++c)
        number = (number ^ static_cast<unsigned char>(*c)) * 16777619u;
    return number;
}

/// The numbers of ".NAME.mirrorball-tmpMACHINE-PROCESS-COUNT"; empty for other names.
std::string_view temporaryNumbers(std::string_view name)
{
    const size_t at = name.rfind(mark);
    if (name.empty() || name.front() != '.' || at == std::string_view::npos)
        return {};
    const std::string_view numbers = name.substr(at + mark.size());
    const bool isOurs = numbers.find('-') != std::string_view::npos && numbers.find_first_not_of("0123456789-") == std::string_view::npos;
    return isOurs ? numbers : std::string_view{};
}

/// A share need not show one machine the locks of another: what those leave is theirs to remove, until it is too old to be in use.
bool mayBeInUseElsewhere(std::string_view numbers, int descriptor)
{
    constexpr time_t longestUse = 7 * 24 * 3600;
    if (numbers.starts_with(std::to_string(machineNumber()) + "-") || std::count(numbers.begin(), numbers.end(), '-') < 2)
        return false;
    struct stat now {};
    return ::fstat(descriptor, &now) != 0 || ::time(nullptr) - now.st_mtime < longestUse;
}

/// Whoever holds the lock of a temporary path is alive. Where a file system knows no locks nothing is removed.
void sweep(const std::filesystem::path& folder)
{
    DIR* const listing = ::opendir(folder.empty() ? "." : folder.c_str());
    if (!listing)
        return;
    const int inside = ::dirfd(listing);
    while (const dirent* entry = ::readdir(listing)) {
        const std::string_view numbers = temporaryNumbers(entry->d_name);
        if (numbers.empty())
            continue;
        const int found = ::openat(inside, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (found < 0)
            continue;
        if (!mayBeInUseElsewhere(numbers, found) && ::flock(found, LOCK_EX | LOCK_NB) == 0)
            removeRaw(inside, entry->d_name, 0);
        ::close(found);
    }
    ::closedir(listing);
}

/// Once a folder and process: a sequence of a thousand files reads the folder once.
void sweepOnce(const std::filesystem::path& folder)
{
    static std::mutex mutex;
    static std::set<std::filesystem::path> swept;
    {
        const std::lock_guard lock(mutex);
        if (!swept.insert(folder).second)
            return;
    }
    sweep(folder);
}

std::filesystem::path newName(const std::filesystem::path& target)
{
    static std::atomic<unsigned> counter{0};
    // The name of a target may use up all that the file system allows, so only part of it is repeated.
    static const std::string machine = std::to_string(machineNumber());
    const std::string name = "." + target.filename().string().substr(0, 200) + std::string(mark) + machine + "-" +
                             std::to_string(::getpid()) + "-" + std::to_string(counter++);
    return target.parent_path() / name;
}

int openNew(const std::filesystem::path& path, TemporaryPath::Kind kind)
{
    if (kind == TemporaryPath::Kind::File)
        return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (::mkdir(path.c_str(), 0777) != 0)
        return -1;
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        ::rmdir(path.c_str());
    return descriptor;
}

/// Whether the path leads to what the descriptor is open on.
bool isStillNamed(int descriptor, const std::filesystem::path& path)
{
    struct stat open {
    }, named{};
    return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

} // namespace

TemporaryPath::TemporaryPath(const std::filesystem::path& target, Kind kind)
{
    sweepOnce(target.parent_path());
    for (;;) {
        m_path = newName(target);
        m_slot = registerPath(m_path); // before it is made: a signal may come between
        m_descriptor = openNew(m_path, kind);
        if (m_descriptor >= 0 &&
            ((::flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) || !isStillNamed(m_descriptor, m_path))) {
            ::close(m_descriptor); // a sweep of another process came between making and locking: it is gone
            m_descriptor = -1;
            errno = EEXIST;
        }
        if (m_descriptor >= 0)
            return;
        const int error = errno;
        unregister(m_slot);
        if (error != EEXIST)
            throw std::system_error(error, std::generic_category());
    }
}

TemporaryPath::~TemporaryPath()
{
    if (!m_path.empty())
        removeRaw(AT_FDCWD, m_path.c_str(), 0);
    release();
}

void TemporaryPath::release()
{
    unregister(m_slot);
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    m_slot = m_descriptor = -1;
    m_path.clear();
}

void removeTemporaries() noexcept
{
    const int error = errno;
    for (Slot& slot : slots)
        if (slot.state == Filled)
            removeRaw(AT_FDCWD, slot.path.data(), 0);
    errno = error;
}

void removeTemporariesOnSignals()
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler != SIG_DFL)
            continue;
        struct sigaction ending {};
        ending.sa_handler = &removeAndEnd;
        ::sigaction(signal, &ending, nullptr);
    }
}

} // namespace mirrorball
