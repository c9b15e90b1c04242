#pragma once

#include "byte_source.h"

#include "core/base/helper_process.h"

#include <cstdint>
#include <string>
#include <string_view>

/// Zstandard frames, the compressed levels of textures. Those of others are unpacked in the helper (core/base/helper_process.h).
namespace mirrorball::zstd {

/// Bytes as one frame. @throws WorkError
std::string packed(std::string_view bytes);

/// Unpacks the frames of one file. They go through one helper, and what it may spend counts for all of them.
class Unpacker {
public:
    /// @param file      stands in messages; lives longer than this
    /// @param allBytes  that the frames hold together
    /// @throws WorkError where there is no helper
    Unpacker(const ByteSource& file, std::uint64_t allBytes);

    /// The bytes in a frame. Memory grows as they arrive, whatever the frame claims.
    /// @param expected  how many there must be
    /// @throws FileError for a damaged frame and for another number of bytes
    std::string unpacked(std::string_view frame, std::uint64_t expected);

private:
    struct Step;
    Step next(std::string_view piece, bool begins, std::uint64_t most);

    const ByteSource& m_file;
    HelperLimits m_limits;
    bool m_isFirst = true; ///< nothing was asked for yet
    Helper m_helper;
};

} // namespace mirrorball::zstd
