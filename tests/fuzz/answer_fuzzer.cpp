#include "input_file.h"

#include "app/helper/gltf_text.h"
#include "app/helper/obj_text.h"
#include "app/helper/off_text.h"
#include "core/image/picture_wire.h"
#include "core/preview/mesh_wire.h"

// What a helper that a file has taken over may answer, and the texts that are looked at before assimp gets them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    ImageFileInfo picture;
    if (openimageio::fromWire(text, picture) && openimageio::toWire(picture).size() > size)
        __builtin_trap();
    preview::ImportedMesh mesh;
    if (preview::fromWire(text, mesh) && preview::toWire(mesh) != text)
        __builtin_trap();
    const helper::ObjText good = helper::withoutBadFaces(std::string(text));
    if (helper::withoutBadFaces(good.text).dropped > 0 || good.text.size() > size)
        __builtin_trap();
    fuzz::refusingPolitely([&] {
        if (helper::cleanedOff(helper::cleanedOff(std::string(text)).text).dropped > 0)
            __builtin_trap();
    });
    fuzz::refusingPolitely([&] {
        const auto beside = [](const std::string&) { return std::optional<std::string>(std::string(64, '\1')); };
        const helper::GltfText floats = helper::withFloatAttributes(std::string(text), beside);
        if (!helper::withFloatAttributes(floats.bytes, beside).floats.empty())
            __builtin_trap();
    });
    return 0;
}
