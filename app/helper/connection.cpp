#include "connection.h"

#include <cerrno>
#include <cstdlib>

#include <poll.h>
#include <unistd.h>

namespace mirrorball::helper {
namespace {

constexpr std::size_t longestRequest = std::size_t{1} << 28; ///< PNG pictures come whole; all else is a path and some numbers

void readAll(void* bytes, std::size_t size)
{
    for (auto* at = static_cast<char*>(bytes); size > 0;) {
        const ssize_t count = ::read(channel, at, size);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            ::_exit(0); // the program has ended
        at += count;
        size -= static_cast<std::size_t>(count);
    }
}

void writeAll(const void* bytes, std::size_t size)
{
    for (const auto* at = static_cast<const char*>(bytes); size > 0;) {
        const ssize_t count = ::write(channel, at, size);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            ::_exit(0);
        at += count;
        size -= static_cast<std::size_t>(count);
    }
}

} // namespace

Received Connection::receive()
{
    pollfd state{channel, POLLIN, 0};
    if (::poll(&state, 1, static_cast<int>(idleSeconds) * 1000) == 0)
        ::_exit(0);
    Received received;
    readAll(&received.head, sizeof received.head);
    if (received.head.size > longestRequest)
        ::_exit(2);
    received.bytes.resize(received.head.size);
    readAll(received.bytes.data(), received.bytes.size());
    return received;
}

void Connection::send(Answer kind, const void* bytes, std::size_t size)
{
    const Head head{.kind = static_cast<std::uint32_t>(kind), .size = size};
    writeAll(&head, sizeof head);
    writeAll(bytes, size);
}

} // namespace mirrorball::helper
