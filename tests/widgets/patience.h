#pragma once

#include "core/base/sanitized.h"

namespace mirrorball::test {

/// The milliseconds that a picture, maps or a program may take before a test gives them up: a software renderer on a machine that is busy.
#ifdef MIRRORBALL_SANITIZED
constexpr int patience = 300'000;
#else
constexpr int patience = 60'000;
#endif

} // namespace mirrorball::test
