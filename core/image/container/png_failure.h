#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>

/// How libpng's failures are heard, where it writes and, in the helper, where it reads.
namespace mirrorball::png {

/// What libpng said when it gave up; it leaves by longjmp, over no object with a destructor.
struct Failure {
    std::array<char, 160> message{};
};

inline void onError(png_structp png, png_const_charp message)
{
    auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
    std::strncpy(failure->message.data(), message, failure->message.size() - 1);
    png_longjmp(png, 1);
}

inline void onWarning(png_structp, png_const_charp) {}

} // namespace mirrorball::png
