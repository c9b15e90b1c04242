#include "zstd_codec.h"

#include "core/base/error.h"
#include "core/base/wire.h"

#include <zstd.h>

#include <algorithm>

namespace mirrorball::zstd {

namespace {

// Frames pass in pieces, so that neither side holds one twice.
constexpr std::size_t largestPiece = std::size_t{1} << 22; ///< compressed
constexpr std::uint64_t largestStep = std::uint64_t{1} << 24;

HelperLimits limitsFor(std::uint64_t allBytes)
{
    constexpr std::uint64_t mib = std::uint64_t{1} << 20;
    return {.seconds = helperSlowdown * (1.0 + static_cast<double>(allBytes) / static_cast<double>(64 * mib)),
            .memoryBytes = 256 * mib}; // the largest window that libzstd takes without being told to is 128 MiB
}

} // namespace

/// What came of a piece.
struct Unpacker::Step {
    std::uint64_t taken = 0; ///< bytes of the piece
    bool ends = false;       ///< the frame is whole
    std::string bytes{};
};

std::string packed(std::string_view bytes)
{
    std::string result(ZSTD_compressBound(bytes.size()), '\0');
    const size_t size = ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), 9);
    if (ZSTD_isError(size) != 0)
        throw WorkError(std::string("a level of a texture cannot be compressed: ") + ZSTD_getErrorName(size));
    result.resize(size);
    return result;
}

Unpacker::Unpacker(const ByteSource& file, std::uint64_t allBytes)
    : m_file(file), m_limits(limitsFor(allBytes)), m_helper(HelperWork::Payloads)
{
}

std::string Unpacker::unpacked(std::string_view frame, std::uint64_t expected)
{
    std::string result;
    bool ends = false;
    for (bool begins = true, goesOn = true; goesOn; begins = false) {
        const std::uint64_t room = expected - result.size();
        const Step step = next(frame.substr(0, largestPiece), begins, std::min(room + 1, largestStep));
        if (step.bytes.size() > room)
            m_file.damaged("a level is longer than its size asks for");
        frame.remove_prefix(step.taken);
        result += step.bytes;
        ends = step.ends;
        goesOn = !ends && (step.taken > 0 || !step.bytes.empty()); // a frame that is cut leaves nothing to do
    }
    if (!ends || result.size() != expected)
        m_file.damaged("a level is shorter than its size asks for");
    return result;
}

Unpacker::Step Unpacker::next(std::string_view piece, bool begins, std::uint64_t most)
{
    WireWriter request;
    request << begins << most << piece;
    try {
        const std::string answer = m_helper.ask(helper::Request::UnpackZstd, std::move(request).bytes(), m_isFirst ? &m_limits : nullptr);
        m_isFirst = false;
        Step step;
        WireReader reader(answer);
        reader >> step.taken >> step.ends >> step.bytes;
        if (!reader.isDone() || step.taken > piece.size() || step.bytes.size() > most)
            throw HelperEnded("it breaks the reader");
        return step;
    } catch (const HelperEnded& ended) {
        m_file.damaged(std::string("a level cannot be decompressed, because ") + ended.what());
    } catch (const InvalidArgument&) {
        m_file.damaged("a level cannot be decompressed");
    }
}

} // namespace mirrorball::zstd
