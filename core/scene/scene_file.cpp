#include "scene_file.h"

#include "sphere_map_source.h"

#include "core/base/error.h"
#include "core/base/field_json.h"
#include "core/shading/brdf_file.h"
#include "core/spheremap/document/sphere_map_json.h"

#include <algorithm>

namespace mirrorball {

using namespace field_json;

namespace {

constexpr std::string_view what = "scene"; // for messages

Scene sceneFromJson(const Json& json)
{
    Scene scene;
    Reader reader("", json);
    checkVersion(json, sceneFileVersion, what);
    reader.known().insert("version");
    Scene::visitFields(scene, reader);
    scene.unknown = reader.unknownKeys();
    validate(scene);
    return scene;
}

Material materialFromJson(const Json& json)
{
    Material material;
    Reader reader("", json);
    Material::visitFields(material, reader);
    material.unknown = reader.unknownKeys();
    validate(material);
    return material;
}

OrderedJson sceneToJson(const Scene& scene)
{
    OrderedJson json;
    Writer writer(json);
    json["version"] = sceneFileVersion;
    Scene::visitFields(scene, writer);
    writer.writeUnknown(scene.unknown);
    return json;
}

/// Where relative paths inside an embedded map start from.
void setFolder(EmbeddedSphereMap& map, const std::filesystem::path& folder)
{
    if (!map)
        return;
    SphereMapDocument document = *map.document;
    document.folder = folder;
    map.document = std::make_shared<const SphereMapDocument>(std::move(document));
}

/// Collects the fields of a settings struct and of those inside it.
class Lister {
public:
    Lister(std::string path, std::vector<FieldEntry>& entries) : m_path(std::move(path)), m_entries(entries) {}

    template <typename T>
    void operator()(const Field& field, const T& value)
    {
        FieldEntry entry{.path = fieldPath(m_path, field.name), .field = field};
        if constexpr (hasFields<T>) {
            T::visitFields(value, Lister(entry.path, m_entries));
            return;
        } else if constexpr (std::is_same_v<T, std::vector<ExportTarget>> || std::is_same_v<T, EmbeddedSphereMap>) {
            return;
        } else if constexpr (std::is_enum_v<T>) {
            entry.words.assign(words(value).begin(), words(value).end());
        } else if constexpr (std::is_same_v<T, bool>) {
            entry.words = {"true", "false"};
        } else if constexpr (std::is_same_v<T, std::optional<Parameterization>>) {
            entry.words = {"auto"};
            entry.words.insert(entry.words.end(), words(Parameterization{}).begin(), words(Parameterization{}).end());
        }
        m_entries.push_back(std::move(entry));
    }

private:
    std::string m_path;
    std::vector<FieldEntry>& m_entries;
};

} // namespace

Scene loadScene(const std::filesystem::path& path)
{
    return namingFile(path, [&] {
        Scene scene = sceneFromJson(parse(readText(path, what), what));
        scene.folder = folderOf(path);
        setFolder(scene.material.sphereMap.document, scene.folder);
        for (std::string* file : {&scene.probe.source, &scene.view.geometry, &scene.material.sphereMap.source, &scene.view.window.middle,
                                  &scene.view.window.far, &scene.view.display.config, &scene.material.diffuse.picture,
                                  &scene.material.normalMap.source, &scene.material.sphereMap.flecks.pattern})
            *file = withSlashes(*file, scene.folder);
        if (std::string& model = scene.material.brdf.model; isBrdfFile(model))
            model = withSlashes(model, scene.folder);
        return scene;
    });
}

namespace {

/// A file whose name, by itself, would be read as the name of something built in.
std::string asFile(const std::string& path) { return std::filesystem::path(path).has_parent_path() ? path : "./" + path; }

/// The scene with the paths that a file in the folder keeps, see storedPath().
Scene storedIn(Scene scene, const std::filesystem::path& folder)
{
    const std::filesystem::path from = std::filesystem::absolute(scene.folder.empty() ? "." : scene.folder).lexically_normal();
    const auto store = [&](std::string& path) { path = storedPath(path, from, folder); };
    const auto storeFile = [&](std::string& path, auto&& isName) {
        if (isName(path))
            return;
        store(path);
        if (isName(path))
            path = asFile(path);
    };
    store(scene.probe.source);
    storeFile(scene.view.geometry, [](const std::string& path) { return builtinGeometry(path).has_value(); });
    for (std::string* map : {&scene.material.sphereMap.source, &scene.view.window.middle, &scene.view.window.far})
        storeFile(*map, [](const std::string& path) { return !isSphereMapFile(path); });
    if (isBrdfFile(scene.material.brdf.model))
        store(scene.material.brdf.model);
    store(scene.material.diffuse.picture);
    store(scene.material.normalMap.source);
    store(scene.material.sphereMap.flecks.pattern);
    storeFile(scene.view.display.config, [](const std::string& path) { return path == "env"; });
    scene.material.sphereMap.document = storedIn(scene.material.sphereMap.document, folder);
    return scene;
}

} // namespace

void saveScene(const Scene& scene, const std::filesystem::path& path)
{
    validate(scene);
    save(sceneToJson(storedIn(scene, folderOf(path))), path, what);
}

Material loadMaterial(const std::filesystem::path& path)
{
    return namingFile(path, [&] {
        const Json json = parse(readText(path, what), what);
        Material material = json.is_object() && json.contains("version") ? sceneFromJson(json).material : materialFromJson(json);
        setFolder(material.sphereMap.document, folderOf(path));
        if (std::string& map = material.sphereMap.source; isSphereMapFile(map))
            map = (folderOf(path) / map).lexically_normal().string(); // an absolute path replaces the folder
        if (std::string& model = material.brdf.model; isBrdfFile(model))
            model = (folderOf(path) / model).lexically_normal().string();
        for (std::string* picture : {&material.diffuse.picture, &material.normalMap.source, &material.sphereMap.flecks.pattern})
            if (!picture->empty())
                *picture = (folderOf(path) / *picture).lexically_normal().string();
        return material;
    });
}

void saveMaterial(const Scene& scene, const std::filesystem::path& path)
{
    validate(scene.material);
    save(Writer::toJson(storedIn(scene, folderOf(path)).material), path, what);
}

std::vector<FieldEntry> sceneFields()
{
    std::vector<FieldEntry> entries;
    const Scene scene;
    Scene::visitFields(scene, Lister("", entries));
    return entries;
}

std::vector<FieldEntry> exportFields()
{
    std::vector<FieldEntry> entries;
    const ExportTarget target;
    ExportTarget::visitFields(target, Lister("exports[0]", entries));
    return entries;
}

namespace {

/// The value at a path inside a scene's JSON. @throws InvalidArgument that says what there is
template <typename AnyJson>
AnyJson& placeOf(AnyJson& json, const std::string& path)
{
    AnyJson* place = &json;
    std::string walked;
    for (size_t at = 0; at < path.size();) {
        const size_t end = std::min({path.find('.', at), path.find('[', at), path.size()});
        if (path[at] == '[') { // an index, "[3]"
            const size_t close = path.find(']', at);
            const std::string digits = close == std::string::npos ? "" : path.substr(at + 1, close - at - 1);
            if (digits.empty() || digits.size() > 4 || digits.find_first_not_of("0123456789") != std::string::npos || !place->is_array() ||
                std::stoul(digits) >= place->size())
                throw InvalidArgument(inQuotes(path) + ": the scene has no such entry; " + walked + " has " +
                                      std::to_string(place->is_array() ? place->size() : 0));
            place = &(*place)[std::stoul(digits)];
            walked = path.substr(0, close + 1);
            at = close + 1 < path.size() && path[close + 1] == '.' ? close + 2 : close + 1;
            continue;
        }
        const std::string key = path.substr(at, end - at);
        if (!place->is_object() || !place->contains(key)) {
            std::string known;
            for (const auto& item : place->items())
                known += (known.empty() ? "" : ", ") + item.key();
            throw InvalidArgument(inQuotes(path) + ": the scene has no such field; " + (walked.empty() ? "there" : walked) +
                                  (place->is_object() ? " is " + known : " holds no fields"));
        }
        place = &(*place)[key];
        walked = path.substr(0, end);
        at = end < path.size() && path[end] == '.' ? end + 1 : end;
    }
    return *place;
}

} // namespace

std::string fieldText(const Scene& scene, const std::string& path)
{
    const OrderedJson json = sceneToJson(scene);
    return placeOf(json, path).dump();
}

void setField(Scene& scene, const std::string& path, const std::string& value)
{
    Json json = Json(sceneToJson(scene));
    Json* place = &placeOf(json, path);
    if (place == &json || place->is_object())
        throw InvalidArgument(inQuotes(path) + ": names a group of fields; name one of them");
    if (place->is_string() && !value.starts_with('"')) {
        *place = value;
    } else {
        Json read = value; // a text, which the reader refuses by the field's name
        if (Json::accept(value))
            try {
                read = parse(value, what);
            } catch (const InvalidArgument& error) {
                throw InvalidArgument(inQuotes(path) + ": the value " + error.what());
            }
        *place = std::move(read);
    }
    Scene changed = sceneFromJson(json);
    changed.folder = scene.folder;
    if (scene.material.sphereMap.document)
        setFolder(changed.material.sphereMap.document, scene.material.sphereMap.document.document->folder);
    scene = std::move(changed);
}

} // namespace mirrorball
