#include "peak_memory.h"

#include <fstream>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace mirrorball {

namespace {

/// A line "VmHWM:   1234 kB" of /proc/self/status, in bytes.
std::optional<std::int64_t> statusBytes(const std::string& field)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(field + ":"))
            return std::stoll(line.substr(field.size() + 1)) * 1024;
    return std::nullopt;
}

} // namespace

PeakMemory::PeakMemory()
{
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
    std::ofstream marks("/proc/self/clear_refs");
    marks << "5" << std::flush; // 5: VmHWM falls to what is resident now
    if (marks)
        m_start = statusBytes("VmRSS");
}

std::optional<std::int64_t> PeakMemory::bytes() const
{
    const auto peak = statusBytes("VmHWM");
    if (!m_start || !peak)
        return std::nullopt;
    return std::max<std::int64_t>(0, *peak - *m_start);
}

} // namespace mirrorball
