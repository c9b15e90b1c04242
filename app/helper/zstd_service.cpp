#include "zstd_service.h"

#include "core/base/error.h"
#include "core/base/wire.h"

#include <zstd.h>

#include <algorithm>
#include <string>

namespace mirrorball::helper {

void ZstdService::Free::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }

void ZstdService::serve(const Received& request, Connection& connection)
{
    constexpr std::uint64_t largestAnswer = std::uint64_t{1} << 24;
    bool begins = false;
    std::uint64_t most = 0;
    std::string piece;
    WireReader(request.bytes) >> begins >> most >> piece;
    if (begins)
        m_context.reset(ZSTD_createDCtx());
    if (!m_context)
        throw InvalidArgument("no frame has begun");
    std::string block(std::min(most, largestAnswer), '\0');
    ZSTD_inBuffer in{piece.data(), piece.size(), 0};
    ZSTD_outBuffer out{block.data(), block.size(), 0};
    size_t state = 0; // 0: the frame is whole
    do {
        state = ZSTD_decompressStream(m_context.get(), &out, &in);
        if (ZSTD_isError(state) != 0)
            throw InvalidArgument(ZSTD_getErrorName(state));
    } while (state != 0 && in.pos < in.size && out.pos < out.size);
    block.resize(out.pos);
    WireWriter answer;
    answer << std::uint64_t{in.pos} << (state == 0) << block;
    connection.send(Answer::Result, std::move(answer).bytes());
}

} // namespace mirrorball::helper
