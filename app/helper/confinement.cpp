#include "confinement.h"

#include "core/base/error.h"
#include "core/base/sanitized.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace mirrorball::helper {
namespace {

constexpr std::uint64_t mostMemory = std::uint64_t{12} << 30; ///< whatever is asked for
/// Sanitizers surround every block and keep those that were freed. Their shadow, terabytes of addresses, is there from the start and counts
/// as what the process has; without a limit, a reader that spins takes all the memory of the machine under them.
#ifdef MIRRORBALL_SANITIZED
constexpr std::uint64_t memoryFactor = 4;
#else
constexpr std::uint64_t memoryFactor = 1;
#endif

std::uint64_t addressSpace()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard)
{
    rlimit now{};
    ::getrlimit(resource, &now);
    const rlimit limits{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
    ::setrlimit(resource, &limits);
}

/// What readers of files need and nothing more; everything else fails with EPERM, which the libraries take as any other failure.
constexpr int plainCalls[] = {
    SCMP_SYS(read),
    SCMP_SYS(pread64),
    SCMP_SYS(readv),
    SCMP_SYS(preadv),
    SCMP_SYS(lseek),
    SCMP_SYS(close),
    SCMP_SYS(fstat),
    SCMP_SYS(newfstatat),
    SCMP_SYS(stat),
    SCMP_SYS(lstat),
    SCMP_SYS(statx),
    SCMP_SYS(access),
    SCMP_SYS(faccessat),
    SCMP_SYS(faccessat2),
    SCMP_SYS(readlink),
    SCMP_SYS(readlinkat),
    SCMP_SYS(getcwd),
    SCMP_SYS(getdents64),
    SCMP_SYS(fadvise64),
    SCMP_SYS(fcntl),
    SCMP_SYS(mmap),
    SCMP_SYS(mprotect),
    SCMP_SYS(munmap),
    SCMP_SYS(mremap),
    SCMP_SYS(madvise),
    SCMP_SYS(brk),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigaltstack),
    SCMP_SYS(futex),
    SCMP_SYS(set_robust_list),
    SCMP_SYS(rseq),
    SCMP_SYS(sched_yield),
    SCMP_SYS(sched_getaffinity),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
    SCMP_SYS(getpid),
    SCMP_SYS(gettid),
    SCMP_SYS(getuid),
    SCMP_SYS(geteuid),
    SCMP_SYS(getgid),
    SCMP_SYS(getegid),
    SCMP_SYS(uname),
    SCMP_SYS(sysinfo),
    SCMP_SYS(getrusage),
    SCMP_SYS(getrlimit),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(clock_getres),
    SCMP_SYS(clock_nanosleep),
    SCMP_SYS(nanosleep),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(time),
    SCMP_SYS(getrandom),
    SCMP_SYS(poll),
    SCMP_SYS(ppoll),
    SCMP_SYS(setitimer),
    SCMP_SYS(restart_syscall),
    SCMP_SYS(arch_prctl),
    SCMP_SYS(membarrier),
    SCMP_SYS(set_tid_address),
};

struct Release {
    void operator()(scmp_filter_ctx filter) const { seccomp_release(filter); }
};

class Filter {
public:
    Filter() : m_filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)))
    {
        if (!m_filter)
            throw cannot(ENOMEM);
        check(seccomp_attr_set(m_filter.get(), SCMP_FLTATR_CTL_TSYNC, 1)); // threads that libraries have started, too
    }
    void allow(int call) { check(seccomp_rule_add(m_filter.get(), SCMP_ACT_ALLOW, call, 0)); }
    void allow(int call, scmp_arg_cmp condition) { check(seccomp_rule_add_array(m_filter.get(), SCMP_ACT_ALLOW, call, 1, &condition)); }
    void deny(int call, int error) { check(seccomp_rule_add(m_filter.get(), SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), call, 0)); }
    void load() { check(seccomp_load(m_filter.get())); }

private:
    static WorkError cannot(int error)
    {
        return WorkError("files of other formats are not read, because their reader cannot be locked in: " +
                         std::string(std::strerror(error)) + "; use a kernel with seccomp, or convert the file to .exr or .hdr elsewhere");
    }
    static void check(int result)
    {
        if (result < 0)
            throw cannot(-result);
    }
    std::unique_ptr<void, Release> m_filter;
};

} // namespace

void limitProcess()
{
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, 0, 0);
    limit(RLIMIT_NOFILE, 128, 128);
}

void confine(int descriptor)
{
#ifdef MIRRORBALL_SANITIZED
    static_cast<void>(descriptor); // their reports need more than the file's reader may
#else
    Filter filter;
    for (const int call : plainCalls)
        filter.allow(call);
    for (const int call : {SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(sendto), SCMP_SYS(recvfrom)})
        filter.allow(call, SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(descriptor)));
    constexpr scmp_datum_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
    filter.allow(SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, writing, 0));
    filter.allow(SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, writing, 0));
    filter.deny(SCMP_SYS(clone3), ENOSYS); // its flags cannot be seen here; the C library then calls clone
    filter.allow(SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
    filter.allow(SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()))); // abort()
    filter.allow(SCMP_SYS(prlimit64), SCMP_A0(SCMP_CMP_EQ, 0));
    filter.allow(SCMP_SYS(setrlimit), SCMP_A0(SCMP_CMP_EQ, RLIMIT_AS));
    filter.allow(SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME));
    filter.load();
#endif
}

void allow(std::uint32_t milliseconds, std::uint64_t memoryBytes)
{
    if (milliseconds > 0) {
        const itimerval until{{0, 0}, {static_cast<time_t>(milliseconds / 1000), static_cast<suseconds_t>(milliseconds % 1000 * 1000)}};
        ::setitimer(ITIMER_PROF, &until, nullptr); // its signal ends the process
    }
    if (memoryBytes > 0)
        limit(RLIMIT_AS, addressSpace() + memoryFactor * std::min(memoryBytes, mostMemory), RLIM_INFINITY);
}

} // namespace mirrorball::helper
