#pragma once

/// MIRRORBALL_SANITIZED is defined in builds under AddressSanitizer or ThreadSanitizer, MIRRORBALL_THREAD_SANITIZED under the latter. GCC
/// says so by macros; Clang, whose fuzzers run the same code, by its features, and has learned the macros only lately.
#if defined(__SANITIZE_THREAD__)
#define MIRRORBALL_THREAD_SANITIZED
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define MIRRORBALL_THREAD_SANITIZED
#endif
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(MIRRORBALL_THREAD_SANITIZED)
#define MIRRORBALL_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define MIRRORBALL_SANITIZED
#endif
#endif
