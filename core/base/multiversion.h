#pragma once

/// Before a hot function: builds it for AVX2 and fused multiply-add as well, chosen when the program starts. Sanitizers cannot run such
/// start-up code.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MIRRORBALL_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define MIRRORBALL_CLONES
#endif
