#pragma once

#include <cstdint>
#include <string>

namespace mirrorball {

/// Where figures were measured: what a reader needs to place them. Empty or 0 where the system does not tell.
struct Machine {
    std::string processor{};
    int cores = 0; ///< that this process may use
    std::int64_t memoryBytes = 0;
    std::string system{}; ///< kernel and its release
    std::string compiler{};
    std::string build{}; ///< "optimized" or "with assertions"
    std::string date{};  ///< UTC, ISO 8601
    double load = 0.0;   ///< processes that wanted a core in the minute before: above 0.5 others disturbed the times
};

Machine thisMachine();

} // namespace mirrorball
