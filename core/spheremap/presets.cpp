#include "presets.h"

#include "sphere_map_file.h"

#include <algorithm>

namespace mirrorball {

std::span<const SphereMapPreset> sphereMapPresets()
{
    static const std::vector<SphereMapPreset> presets = [] {
        std::vector<SphereMapPreset> read;
        for (const SphereMapFile& file : embeddedSphereMaps()) {
            SphereMapDocument document = sphereMapFromText(std::string(file.text));
            read.push_back({std::string(file.name), document.title, document.description, std::move(document)});
        }
        return read;
    }();
    return presets;
}

const SphereMapPreset* findSphereMapPreset(std::string_view name)
{
    const auto presets = sphereMapPresets();
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const SphereMapPreset& p) { return p.name == name; });
    return found == presets.end() ? nullptr : &*found;
}

} // namespace mirrorball
