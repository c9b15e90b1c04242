#pragma once

#include "connection.h"

#include <memory>

struct ZSTD_DCtx_s;

namespace mirrorball::helper {

/// Unpacks Zstandard frames, one at a time, piece by piece (core/image/container/zstd_codec.h).
class ZstdService {
public:
    /// Answers a request for what the next piece of a frame holds. @throws InvalidArgument for damaged data
    void serve(const Received& request, Connection& connection);

private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> m_context{}; ///< of the frame that has begun
};

} // namespace mirrorball::helper
