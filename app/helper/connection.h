#pragma once

#include "core/base/helper_protocol.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace mirrorball::helper {

/// A request as it arrived.
struct Received {
    Head head{};
    std::string bytes{};
};

/// The socket to the program that asks. When it is closed, says something odd, or nothing for a while, this process ends.
class Connection {
public:
    Received receive();
    void send(Answer kind, std::string_view bytes) { send(kind, bytes.data(), bytes.size()); }
    void send(Answer kind, const void* bytes, std::size_t size);
};

} // namespace mirrorball::helper
