#include "input_file.h"

#include "core/scene/plan.h"
#include "core/scene/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace mirrorball;
    return fuzz::refusingPolitely([&] {
        const Scene scene = loadScene(fuzz::fileOf(bytes, size, ".mirrorball"));
        makePlan(scene, {Parameterization::Latlong, 16, 0});
    });
}
