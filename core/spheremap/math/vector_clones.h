#pragma once

#include "core/base/sanitized.h"

/// Before a function that loops over a run of texels: the compiler makes it twice, once for processors with 256-bit vectors, and the
/// program takes what the processor has. Both give the same bits: the wider one has no FMA, whose single rounding would give others.
/// Sanitizers are not yet running when the choice is made, so under them there is one version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(MIRRORBALL_SANITIZED)
#define MIRRORBALL_VECTOR_CLONES __attribute__((target_clones("avx2", "default"), flatten))
#else
#define MIRRORBALL_VECTOR_CLONES
#endif
