#include "machine.h"

#include "core/base/job.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <sys/utsname.h>
#include <unistd.h>

namespace mirrorball {

namespace {

std::string processorName()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return {};
}

} // namespace

Machine thisMachine()
{
    Machine machine{.processor = processorName(), .cores = JobControl{}.threadCount()};
    machine.memoryBytes = std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE);
    if (utsname names{}; uname(&names) == 0)
        machine.system = std::string(names.sysname) + " " + names.release + " " + names.machine;
#if defined(__clang__)
    machine.compiler = "clang " __clang_version__;
#else
    machine.compiler = "g++ " __VERSION__;
#endif
#if defined(NDEBUG)
    machine.build = "optimized";
#else
    machine.build = "with assertions";
#endif
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> text{};
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    machine.date = text.data();
    double load = 0.0;
    if (getloadavg(&load, 1) == 1)
        machine.load = load;
    return machine;
}

} // namespace mirrorball
