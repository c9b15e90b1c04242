#include "scene_file.h"

#include "../atomic_file.h"
#include "../error.h"
#include "field_checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <set>
#include <type_traits>

namespace mirrorball {

namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr size_t largestFile = size_t{16} << 20;
constexpr int deepest = 64;

// ---- reading -------------------------------------------------------------------------------------------------------------------

[[noreturn]] void refuse(const std::string& path, const std::string& must, const Json& found)
{
    std::string what;
    if (found.is_object())
        what = "an object";
    else if (found.is_array())
        what = "a list of " + std::to_string(found.size());
    else if (found.is_string())
        what = inQuotes(found.get_ref<const std::string&>());
    else
        what = found.dump();
    throw InvalidArgument((path.empty() ? "the file" : path) + ": must be " + must + "; it is " + what);
}

std::string listed(std::span<const std::string_view> words)
{
    std::string text;
    for (size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string(words[i]);
    return text;
}

/// Reads an object's members into a settings struct. Members that are not fields go into its `unknown`.
class Reader {
public:
    Reader(std::string path, const Json& object) : m_path(std::move(path)), m_object(object)
    {
        if (!object.is_object())
            refuse(m_path, "an object in { }", object);
    }

    template <typename T>
    void operator()(const Field& field, T& value)
    {
        m_known.emplace(field.name);
        const auto found = m_object.find(field.name);
        if (found != m_object.end())
            read(fieldPath(m_path, field.name), field, *found, value);
    }

    UnknownKeys unknownKeys() const
    {
        UnknownKeys unknown;
        for (const auto& [key, value] : m_object.items())
            if (!m_known.contains(key))
                unknown.emplace(key, value.dump());
        return unknown;
    }

    std::set<std::string, std::less<>>& known() { return m_known; }

private:
    static void read(const std::string& path, const Field& field, const Json& json, double& value)
    {
        if (!json.is_number())
            refuse(path, "a number", json);
        value = json.get<double>();
        checkRange(path, field, value);
    }
    static void read(const std::string& path, const Field& field, const Json& json, int& value)
    {
        if (!json.is_number_integer())
            refuse(path, "a whole number", json);
        checkRange(path, field, json.get<double>());
        value = json.get<int>();
    }
    static void read(const std::string& path, const Field&, const Json& json, bool& value)
    {
        if (!json.is_boolean())
            refuse(path, "true or false", json);
        value = json.get<bool>();
    }
    static void read(const std::string& path, const Field&, const Json& json, std::string& value)
    {
        if (!json.is_string())
            refuse(path, "a text in quotes", json);
        value = json.get<std::string>();
        if (value.find('\0') != std::string::npos)
            refuse(path, "a text without NUL", json);
    }
    static void read(const std::string& path, const Field& field, const Json& json, glm::dvec3& value)
    {
        if (!json.is_array() || json.size() != 3)
            refuse(path, "a list of three numbers", json);
        for (int c = 0; c < 3; ++c)
            read(path + "[" + std::to_string(c) + "]", field, json[static_cast<size_t>(c)], value[c]);
    }
    template <typename E>
        requires std::is_enum_v<E>
    static void read(const std::string& path, const Field&, const Json& json, E& value)
    {
        const auto known = words(E{});
        const auto found = json.is_string() ? std::find(known.begin(), known.end(), json.get_ref<const std::string&>()) : known.end();
        if (found == known.end())
            refuse(path, listed(known), json);
        value = static_cast<E>(found - known.begin());
    }
    static void read(const std::string& path, const Field& field, const Json& json, std::optional<Parameterization>& value)
    {
        if (json == "auto") {
            value.reset();
            return;
        }
        const auto known = words(Parameterization{});
        if (!json.is_string() || std::find(known.begin(), known.end(), json.get_ref<const std::string&>()) == known.end())
            refuse(path, "auto, " + listed(known), json);
        read(path, field, json, value.emplace());
    }
    static void read(const std::string& path, const Field&, const Json& json, std::vector<ExportTarget>& value)
    {
        if (!json.is_array() || json.size() > 1000)
            refuse(path, "a list of at most 1000 exports", json);
        value.clear();
        for (size_t i = 0; i < json.size(); ++i)
            read(path + "[" + std::to_string(i) + "]", {}, json[i], value.emplace_back());
    }
    template <typename T>
        requires hasFields<T>
    static void read(const std::string& path, const Field&, const Json& json, T& value)
    {
        Reader reader(path, json);
        T::visitFields(value, reader);
        value.unknown = reader.unknownKeys();
    }

    std::string m_path;
    const Json& m_object;
    std::set<std::string, std::less<>> m_known;
};

/// Parses JSON, refusing what nlohmann's parser lets through: deep nesting and keys that occur twice.
Json parse(const std::string& text)
{
    std::vector<std::set<std::string>> keys;
    const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth > deepest)
            throw InvalidArgument("is nested more than " + std::to_string(deepest) + " deep; this is no scene");
        if (event == Json::parse_event_t::object_start)
            keys.emplace_back();
        else if (event == Json::parse_event_t::object_end)
            keys.pop_back();
        else if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get_ref<const std::string&>()).second)
            throw InvalidArgument("the key " + inQuotes(parsed.get_ref<const std::string&>()) + " occurs twice in one object; remove one");
        return true;
    };
    try {
        return Json::parse(text, check);
    } catch (const Json::parse_error& error) {
        const size_t end = std::min(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        throw InvalidArgument("is no JSON from line " + std::to_string(line) + " on; mend it there or load another file");
    } catch (const Json::exception&) {
        throw InvalidArgument("holds a number too large for any computer; mend it or load another file");
    }
}

std::string readText(const std::filesystem::path& path)
{
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InvalidArgument("is a folder; give a file");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InvalidArgument(std::filesystem::exists(path, error) ? "cannot be opened; check its permissions"
                                                                   : "does not exist; check the path");
    std::string text(largestFile + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad())
        throw InvalidArgument("cannot be read; check the disk");
    text.resize(static_cast<size_t>(file.gcount()));
    if (text.size() > largestFile)
        throw InvalidArgument("holds more than 16 MiB; this is no scene");
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InvalidArgument("is empty; write a scene into it or load another file");
    return text;
}

void checkVersion(const Json& json)
{
    const auto found = json.find("version");
    if (found == json.end())
        throw InvalidArgument("version: is missing; a scene file begins with {\"version\": 1, ...}");
    if (!found->is_number_integer() || found->get<double>() < 1)
        refuse("version", "a whole number from 1", *found);
    if (found->get<double>() > sceneFileVersion)
        throw InvalidArgument("version: is " + found->dump() + ", but this program reads up to " + std::to_string(sceneFileVersion) +
                              "; update Mirrorball");
}

Scene sceneFromJson(const Json& json)
{
    Scene scene;
    Reader reader("", json);
    checkVersion(json);
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

/// Runs `load` and puts the file's name before whatever it has to say.
template <typename Load>
auto namingFile(const std::filesystem::path& path, Load&& load)
{
    try {
        return load();
    } catch (const InvalidArgument& error) {
        throw FileError(path.string(), error.what());
    }
}

// ---- writing -------------------------------------------------------------------------------------------------------------------

/// Puts a settings struct's members into an object, then its unknown keys.
class Writer {
public:
    explicit Writer(OrderedJson& object) : m_object(object) { m_object = OrderedJson::object(); }

    template <typename T>
    void operator()(const Field& field, const T& value)
    {
        m_object[std::string(field.name)] = toJson(value);
    }

    template <typename T>
    static OrderedJson toJson(const T& value)
    {
        if constexpr (hasFields<T>) {
            OrderedJson object;
            Writer writer(object);
            T::visitFields(value, writer);
            writer.writeUnknown(value.unknown);
            return object;
        } else if constexpr (std::is_enum_v<T>) {
            return words(value)[static_cast<size_t>(value)];
        } else if constexpr (std::is_same_v<T, std::optional<Parameterization>>) {
            return value ? name(*value) : "auto";
        } else if constexpr (std::is_same_v<T, glm::dvec3>) {
            return {value.x, value.y, value.z};
        } else if constexpr (std::is_same_v<T, std::vector<ExportTarget>>) {
            OrderedJson list = OrderedJson::array();
            for (const ExportTarget& target : value)
                list.push_back(toJson(target));
            return list;
        } else {
            return value;
        }
    }

    void writeUnknown(const UnknownKeys& unknown)
    {
        auto& members = m_object.get_ref<OrderedJson::object_t&>();
        for (const auto& [key, value] : unknown) // appended without a search: there may be very many
            members.push_back({key, OrderedJson::parse(value)});
    }

private:
    OrderedJson& m_object;
};

OrderedJson sceneToJson(const Scene& scene)
{
    OrderedJson json;
    Writer writer(json);
    json["version"] = sceneFileVersion;
    Scene::visitFields(scene, writer);
    writer.writeUnknown(scene.unknown);
    return json;
}

void saveJson(const OrderedJson& json, const std::filesystem::path& path)
{
    std::string text;
    try {
        text = json.dump(2) + "\n";
    } catch (const OrderedJson::exception&) {
        throw InvalidArgument(path.string() + ": a text of the scene is not UTF-8 and cannot be saved; rename the file it names");
    }
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return std::filesystem::absolute(file).lexically_normal().parent_path();
}

/// A path that was relative to `from`, relative to `to`.
void rebase(std::string& path, const std::filesystem::path& from, const std::filesystem::path& to)
{
    if (path.empty() || path.starts_with("builtin:") || std::filesystem::path(path).is_absolute())
        return;
    const std::filesystem::path moved = (from / path).lexically_normal().lexically_relative(to);
    path = moved.empty() ? (from / path).string() : moved.string();
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
        } else if constexpr (std::is_same_v<T, std::vector<ExportTarget>>) {
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
        Scene scene = sceneFromJson(parse(readText(path)));
        scene.folder = folderOf(path);
        return scene;
    });
}

void saveScene(const Scene& scene, const std::filesystem::path& path)
{
    Scene saved = scene;
    const std::filesystem::path from = std::filesystem::absolute(scene.folder.empty() ? "." : scene.folder), to = folderOf(path);
    if (from.lexically_normal() != to) {
        rebase(saved.probe.source, from, to);
        if (!isBuiltinGeometry(saved.view.geometry))
            rebase(saved.view.geometry, from, to);
        if (std::filesystem::path(saved.material.sphereMap.source).has_parent_path())
            rebase(saved.material.sphereMap.source, from, to);
    }
    validate(saved);
    saveJson(sceneToJson(saved), path);
}

Material loadMaterial(const std::filesystem::path& path)
{
    return namingFile(path, [&] {
        const Json json = parse(readText(path));
        return json.is_object() && json.contains("version") ? sceneFromJson(json).material : materialFromJson(json);
    });
}

void saveMaterial(const Material& material, const std::filesystem::path& path)
{
    validate(material);
    saveJson(Writer::toJson(material), path);
}

std::vector<FieldEntry> sceneFields()
{
    std::vector<FieldEntry> entries;
    const Scene scene;
    Scene::visitFields(scene, Lister("", entries));
    return entries;
}

void setField(Scene& scene, const std::string& path, const std::string& value)
{
    Json json = Json(sceneToJson(scene));
    Json* place = &json;
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
    if (place == &json || place->is_object())
        throw InvalidArgument(inQuotes(path) + ": names a group of fields; name one of them");
    if (place->is_string() && !value.starts_with('"')) {
        *place = value;
    } else {
        *place = Json::parse(value, nullptr, false);
        if (place->is_discarded())
            *place = value; // a text, which the reader refuses by the field's name
    }
    Scene changed = sceneFromJson(json);
    changed.folder = scene.folder;
    scene = std::move(changed);
}

} // namespace mirrorball
