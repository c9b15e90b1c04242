#include "input_file.h"

// Formats of others, decoded in the helper: whatever it does there, here comes a picture or an error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    return fuzz::refusingPolitely([&] { fuzz::readRows(*openImage(fuzz::fileOf(bytes, size, ".tga"))); });
}
