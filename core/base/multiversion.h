#pragma once

#include "sanitized.h"

/// Before a hot function: builds it for AVX2 and fused multiply-add as well, chosen when the program starts. The two round differently:
/// where the same bytes are promised on every processor it is MIRRORBALL_VECTOR_CLONES that is used. Sanitizers cannot run such start-up
/// code; MIRRORBALL_PLAIN_PATH leaves the plain one alone, for tests of it.
#if defined(__x86_64__) && !defined(MIRRORBALL_SANITIZED) && !defined(MIRRORBALL_PLAIN_PATH)
#define MIRRORBALL_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define MIRRORBALL_CLONES
#endif
