#include "input_file.h"

#include "core/image/exr_format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    const auto path = fuzz::fileOf(bytes, size, ".exr");
    fuzz::refusingPolitely([&] {
        if (const auto pass = exr::openPass(OpenedFile(path), "diffuse"))
            fuzz::readRows(*pass);
    });
    return fuzz::refusingPolitely([&] { fuzz::readRows(*exr::open(OpenedFile(path), 0)); });
}
