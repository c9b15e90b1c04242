#include "embedded_sphere_map.h"

#include "core/base/error.h"
#include "sphere_map_file.h"
#include "sphere_map_json.h"

namespace mirrorball {

namespace {

/// Puts the place of the map before whatever is wrong inside it.
template <typename Work>
auto namingPlace(const std::string& path, Work&& work)
{
    try {
        return work();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(path + "." + error.what());
    }
}

} // namespace

void checkFields(const std::string& path, const EmbeddedSphereMap& map)
{
    if (map)
        namingPlace(path, [&] { validate(*map.document); });
}

EmbeddedSphereMap storedIn(const EmbeddedSphereMap& map, const std::filesystem::path& folder)
{
    if (!map)
        return map;
    return {std::make_shared<const SphereMapDocument>(storedIn(*map.document, folder))};
}

void readJson(const std::string& path, const nlohmann::json& json, EmbeddedSphereMap& map)
{
    if (json.is_null())
        map.document.reset();
    else if (!json.is_object())
        field_json::refuse(path, "a sphere map in { }, or null", json);
    else
        map.document = namingPlace(path, [&] { return std::make_shared<const SphereMapDocument>(sphereMapFromJson(json)); });
}

nlohmann::ordered_json writeJson(const EmbeddedSphereMap& map) { return map ? sphereMapToJson(*map.document) : nlohmann::ordered_json(); }

} // namespace mirrorball
