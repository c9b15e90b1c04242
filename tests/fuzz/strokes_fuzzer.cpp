#include "input_file.h"

#include "core/spheremap/strokes/stroke_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    return fuzz::refusingPolitely([&] { loadStrokes(fuzz::fileOf(bytes, size, ".strokes")); });
}
