#pragma once

#include <cstdint>

/// What this program and its helper (app/helper) say to each other: a head, then its bytes. Both are of one build.
namespace mirrorball::helper {

inline constexpr int channel = 3;           ///< the helper's descriptor of the socket
inline constexpr int version = 4;           ///< told on the command line; a helper of another one ends at once
inline constexpr unsigned idleSeconds = 20; ///< after which a helper that nobody asks ends itself

enum class Request : std::uint32_t {
    OpenPicture,  ///< path, format, level -> PictureInfo
    ReadRows,     ///< first row, rows -> their samples, as floats
    ClosePicture, ///< no answer
    ReadMesh,     ///< path, limits -> mesh
    DecodePng,    ///< most texels, the bytes of a file -> width, height, 8-bit RGBA texels
    UnpackZstd,   ///< whether a frame begins, most bytes, the next ones of the frame -> how many were taken, whether it ends, bytes
};

enum class Answer : std::uint32_t {
    Result,
    Refused, ///< the text of an InvalidArgument
    Failed,  ///< the text of a WorkError
};

struct Head {
    std::uint32_t kind = 0;         ///< Request or Answer
    std::uint32_t milliseconds = 0; ///< request: processor time for it and what follows on the same file; 0: goes on as it is
    std::uint64_t memory = 0;       ///< request: bytes that may be taken for it; 0: goes on as it is
    std::uint64_t size = 0;         ///< of what follows
};

} // namespace mirrorball::helper
