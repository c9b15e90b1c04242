#pragma once

#include "color.h"

#include "core/base/opened_file.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The header of a Radiance picture, and the bytes that follow it.
namespace mirrorball::hdr {

using Rgbe = std::array<std::uint8_t, 4>;

inline constexpr int smallestRleWidth = 8; ///< narrower and wider scanlines have no per-component run-length form
inline constexpr int largestRleWidth = 32767;

/// The bytes of a file, buffered, with an error that says the file ends early instead of a short count.
class ByteSource {
public:
    explicit ByteSource(OpenedFile file) : m_file(std::move(file)), m_buffer(size_t{1} << 18) {}
    const OpenedFile& file() const { return m_file; }
    /// The next `count` bytes, at most the buffer's size, in one piece.
    const std::uint8_t* take(size_t count)
    {
        if (m_end - m_next < count)
            refill(count);
        const std::uint8_t* bytes = m_buffer.data() + m_next;
        m_next += count;
        return bytes;
    }
    /// A line of the header without its end.
    std::string line();
    /// Steps back over bytes just taken.
    void putBack(size_t count) { m_next -= count; }
    /// Back to the file's first byte.
    void restart();

private:
    void refill(size_t count);

    OpenedFile m_file;
    std::vector<std::uint8_t> m_buffer;
    size_t m_next = 0;
    size_t m_end = 0;
    size_t m_headerBytes = 0;
};

/// How scanlines lie in the picture: the first axis of the resolution line counts scanlines, the second the texels in one.
struct Order {
    bool transposed = false; ///< scanlines are columns
    bool upward = false;     ///< "+Y": the first row stored is the bottom one
    bool leftward = false;   ///< "-X"
};

struct Header {
    int width = 0;
    int height = 0;
    Order order{};
    glm::dvec3 gain{1.0}; ///< 1 / (EXPOSURE * COLORCORR), both multiplied up over their lines
    std::optional<glm::mat3> toRec709{};
    std::string encoding{};           ///< in words
    std::vector<std::string> notes{}; ///< what of it is not used, and why

    int scanlines() const { return order.transposed ? width : height; }
    int scanlineTexels() const { return order.transposed ? height : width; }
};

/// @throws FileError for an unknown format and a missing or absurd resolution
Header readHeader(ByteSource& bytes);

} // namespace mirrorball::hdr
