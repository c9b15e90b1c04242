#include "presets.h"

#include "sphere_map_file.h"

#include <algorithm>

namespace mirrorball {

namespace {

std::vector<SphereMapPreset> presetsOf(std::span<const SphereMapFile> files)
{
    std::vector<SphereMapPreset> read;
    for (const SphereMapFile& file : files) {
        SphereMapDocument document = sphereMapFromText(std::string(file.text));
        read.push_back({std::string(file.name), document.title, document.description, std::move(document)});
    }
    return read;
}

} // namespace

std::span<const SphereMapPreset> sphereMapPresets()
{
    static const std::vector<SphereMapPreset> presets = presetsOf(embeddedSphereMaps());
    return presets;
}

std::span<const SphereMapPreset> windowViewPresets()
{
    static const std::vector<SphereMapPreset> presets = presetsOf(embeddedWindowViews());
    return presets;
}

const SphereMapPreset* findSphereMapPreset(std::string_view name)
{
    for (const std::span<const SphereMapPreset> presets : {sphereMapPresets(), windowViewPresets()}) {
        const auto found = std::find_if(presets.begin(), presets.end(), [&](const SphereMapPreset& p) { return p.name == name; });
        if (found != presets.end())
            return &*found;
    }
    return nullptr;
}

} // namespace mirrorball
