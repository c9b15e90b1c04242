#pragma once

#include "connection.h"

namespace mirrorball::helper {

/// Answers a request for the texels of a PNG picture (core/image/container/png_codec.h). @throws InvalidArgument for damaged data
void servePng(const Received& request, Connection& connection);

} // namespace mirrorball::helper
