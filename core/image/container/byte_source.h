#pragma once

#include "core/base/error.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Little-endian numbers in strings of bytes, on any machine.
namespace mirrorball {

template <std::unsigned_integral Number>
void appendLittle(std::string& bytes, Number value)
{
    for (size_t i = 0; i < sizeof(Number); ++i)
        bytes.push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i)));
}

/// The number at `at`, which must lie inside.
template <std::unsigned_integral Number>
Number littleAt(std::string_view bytes, size_t at)
{
    std::uint64_t value = 0;
    for (size_t i = 0; i < sizeof(Number); ++i)
        value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return static_cast<Number>(value);
}

/// Reads a file in memory from front to back; every step is checked against what is there.
class ByteSource {
public:
    /// @param name  stands in messages
    ByteSource(std::string_view bytes, const std::string& name) : m_bytes(bytes), m_name(name) {}

    /// @throws FileError where fewer bytes are left
    std::string_view take(std::uint64_t count)
    {
        if (count > m_bytes.size() - m_position)
            damaged("it ends early");
        const std::string_view taken = m_bytes.substr(m_position, static_cast<size_t>(count));
        m_position += static_cast<size_t>(count);
        return taken;
    }
    template <std::unsigned_integral Number>
    Number number()
    {
        return littleAt<Number>(take(sizeof(Number)), 0);
    }
    std::uint32_t u32() { return number<std::uint32_t>(); }
    std::uint64_t u64() { return number<std::uint64_t>(); }
    size_t position() const { return m_position; }
    size_t left() const { return m_bytes.size() - m_position; }

    [[noreturn]] void damaged(const std::string& how) const
    {
        throw FileError(m_name, "the file is damaged: " + how + "; copy or download it again");
    }
    [[noreturn]] void unsupported(const std::string& what) const { throw FileError(m_name, what); }

private:
    std::string_view m_bytes;
    const std::string& m_name;
    size_t m_position = 0;
};

} // namespace mirrorball
