#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mirrorball {

/// What a step takes: wall time, and memory that it leaves in use.
struct StageCost {
    double seconds = 0.0;
    std::int64_t bytes = 0;
    bool operator==(const StageCost&) const = default;
};

/// One step of a job: done, with its wall time, or left out, with the reason. What `--explain` prints before the work and `--stats`
/// records after it.
struct Stage {
    std::string name{}; ///< a stage that touches files has read, load, write or save in its name
    double seconds = 0.0;
    bool leftOut = false;
    std::string why{};
    StageCost expected{}; ///< in plans: about; 0 where it is not worth telling
};

/// Runs one stage, appends its time to the list and returns what the work returned.
template <typename Work>
auto timedStage(std::vector<Stage>& stages, std::string name, Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    const auto record = [&] {
        stages.push_back(
            {.name = std::move(name), .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
    };
    if constexpr (std::is_void_v<decltype(work())>) {
        work();
        record();
    } else {
        auto result = work();
        record();
        return result;
    }
}

} // namespace mirrorball
