#include "input_file.h"

#include "core/image/container/container_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    return fuzz::refusingPolitely([&] { readContainer(std::string_view(reinterpret_cast<const char*>(bytes), size), "input"); });
}
