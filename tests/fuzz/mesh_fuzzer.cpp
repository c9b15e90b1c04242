#include "input_file.h"

#include "core/preview/mesh_file.h"

// The first byte chooses the format, which meshes have by name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    if (size == 0)
        return 0;
    const auto extensions = preview::meshExtensions();
    const std::string_view extension = extensions[bytes[0] % extensions.size()];
    return fuzz::refusingPolitely([&] { preview::readMesh(fuzz::fileOf(bytes + 1, size - 1, extension)); });
}
