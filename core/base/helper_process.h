#pragma once

#include "error.h"
#include "helper_protocol.h"
#include "job.h"
#include "sanitized.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

/// Files of others are read by code of others - OpenImageIO, assimp - and both have crashed, spun and eaten memory. So that code runs in a
/// program of its own, `mirrorball-helper`, which may read files and answer, and nothing else: no network, no writing, limited memory and
/// time. This is the side that asks.
namespace mirrorball {

enum class HelperWork {
    Pictures, ///< files, through OpenImageIO
    Meshes,
    Payloads, ///< what is compressed inside of other files: PNG pictures, Zstandard frames
};

/// How many times as long the helper takes under AddressSanitizer or ThreadSanitizer, which it then runs under too. Much of what a fuzzer
/// finds makes readers spin for as long as they may: under it that is what Clang's AddressSanitizer costs, and little more.
#if defined(__has_feature)
#if __has_feature(coverage_sanitizer)
#define MIRRORBALL_FUZZED
#endif
#endif
#if defined(MIRRORBALL_FUZZED)
inline constexpr double helperSlowdown = 4.0;
#elif defined(MIRRORBALL_SANITIZED)
inline constexpr double helperSlowdown = 20.0;
#else
inline constexpr double helperSlowdown = 1.0;
#endif

/// What the helper may spend on one file.
struct HelperLimits {
    double seconds = 1.0;           ///< processor time; on the clock it may take 20 times that and half a minute
    std::uintmax_t memoryBytes = 0; ///< beyond what the helper has when it is idle
};

/// The helper came to its end over a file: it crashed or passed a limit. The message has no remedy: the caller knows the file.
class HelperEnded : public Error {
public:
    using Error::Error;
};

/// A helper process for as long as this object lives; then it waits, for twenty seconds, for the next one: starting it costs a third of a
/// second for pictures, and folders of them are read at a time. Not for use by two threads at once.
class Helper {
public:
    /// Takes one that waits or starts one. @throws WorkError when none can be started
    explicit Helper(HelperWork work);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    ~Helper();

    /// Sends a request and awaits its answer. Without limits those of the last request go on: they count for a file as a whole.
    /// @throws InvalidArgument, WorkError with the helper's words; HelperEnded; Cancelled, which ends the helper
    std::string ask(helper::Request request, std::string_view bytes, const HelperLimits* limits, const JobControl& job = {});
    /// The same for an answer of a known size. @throws HelperEnded too where the answer has another
    void askInto(helper::Request request, std::string_view bytes, void* answer, std::size_t size, const JobControl& job = {});
    /// Sends a request that has no answer. Errors show up in the next one.
    void tell(helper::Request request) noexcept;

private:
    struct Process;
    void send(helper::Request request, std::string_view bytes, const HelperLimits* limits);
    helper::Head awaitHead(const JobControl& job);
    void receive(void* bytes, std::size_t size, const JobControl& job);
    [[noreturn]] void end(const std::string& reason);
    [[noreturn]] void throwAnswer(const helper::Head& head, const JobControl& job);

    std::unique_ptr<Process> m_process;
};

/// Where the helper is: beside this program, in its libexec, or where this build installs to. @throws WorkError when it is nowhere
std::filesystem::path helperProgram();

} // namespace mirrorball
