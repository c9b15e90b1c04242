#include "scene_words.h"

#include "material_presets.h"
#include "scene_file.h"

#include "core/base/error.h"

#include <filesystem>

namespace mirrorball {

Material materialFromWord(const std::string& parameter, const std::string& word)
{
    if (const MaterialPreset* preset = findMaterialPreset(word))
        return preset->material;
    if (word.find_first_of("./\\") != std::string::npos)
        return loadMaterial(word);
    std::string known;
    for (const MaterialPreset& preset : materialPresets())
        known += (known.empty() ? "" : ", ") + std::string(preset.name);
    throw InvalidArgument(parameter + ": '" + word + "' is neither a preset (" + known + ") nor a file");
}

std::string probeFromWord(const std::string& word)
{
    return word.starts_with("builtin:") ? word : std::filesystem::absolute(word).string();
}

} // namespace mirrorball
