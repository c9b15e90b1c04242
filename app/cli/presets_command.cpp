#include "command.h"

#include "core/image/builtin_probes.h"
#include "core/scene/material_presets.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace mirrorball::cli {

namespace {

struct Preset {
    std::string name, kind, description;
};

std::vector<Preset> allPresets()
{
    std::vector<Preset> presets;
    for (const BuiltinProbe& probe : builtinProbes())
        presets.push_back({"builtin:" + std::string(probe.name), "probe", std::string(probe.description)});
    for (const MaterialPreset& material : materialPresets())
        presets.push_back({std::string(material.name), "material", std::string(material.description)});
    return presets;
}

void run(bool json)
{
    if (json) {
        nlohmann::json list = nlohmann::json::array();
        for (const Preset& p : allPresets())
            list.push_back({{"name", p.name}, {"kind", p.kind}, {"description", p.description}});
        std::printf("%s\n", list.dump(2).c_str());
        return;
    }
    for (const Preset& p : allPresets())
        std::printf("%s\t%s\t%s\n", p.name.c_str(), p.kind.c_str(), p.description.c_str());
}

} // namespace

void addPresetsCommand(CLI::App& program)
{
    const auto json = std::make_shared<bool>(false);
    CLI::App* command = program.add_subcommand("presets", "List the built-in probes and materials");
    command->add_flag("--json", *json, "as JSON");
    command->callback([json] { run(*json); });
}

} // namespace mirrorball::cli
