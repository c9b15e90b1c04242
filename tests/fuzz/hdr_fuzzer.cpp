#include "input_file.h"

#include "core/image/hdr_format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    return fuzz::refusingPolitely([&] { fuzz::readRows(*hdr::open(OpenedFile(fuzz::fileOf(bytes, size, ".hdr")))); });
}
