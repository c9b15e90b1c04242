#include "input_file.h"

#include "core/spheremap/document/sphere_map_file.h"

// What was read is written so that it reads the same again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    return fuzz::refusingPolitely([&] {
        const std::string text = sphereMapToText(sphereMapFromText(std::string(reinterpret_cast<const char*>(bytes), size)));
        if (sphereMapToText(sphereMapFromText(text)) != text)
            __builtin_trap();
    });
}
