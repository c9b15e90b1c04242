#pragma once

#include <cstdint>
#include <optional>

namespace mirrorball {

/// Watches how much more memory the process holds at most than it held when the watch began.
///
/// It starts by giving freed pages back to the system, so that earlier work leaves nothing to be reused unseen, and by resetting the
/// kernel's high-water mark (proc(5), clear_refs). One process can thus measure many pieces of work one after the other, each by
/// itself, where a child process for each would have to read the probe again and would count that too. What is counted is resident
/// memory of this process: textures on a graphics card are not in it. Pages are counted to about 1 MB.
class PeakMemory {
public:
    PeakMemory();
    /// Bytes at most above the start, so far; empty where the system does not let the mark be reset.
    std::optional<std::int64_t> bytes() const;

private:
    std::optional<std::int64_t> m_start{};
};

} // namespace mirrorball
