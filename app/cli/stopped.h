#pragma once

#include "core/base/error.h"

namespace mirrorball::cli {

/// `batch` was asked to end before it was done and wants to run again: exit status 75 (EX_TEMPFAIL of sysexits.h), which schedulers take
/// for "put it back into the queue".
class Stopped : public Error {
public:
    static constexpr int status = 75;
    using Error::Error;
};

} // namespace mirrorball::cli
