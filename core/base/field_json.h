#pragma once

#include "error.h"
#include "field_checks.h"
#include "fields.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// Settings structs (fields.h) as JSON: what the files of scenes, materials and sphere maps share.
///
/// Files are not trusted: they may hold at most 128 MiB, nested at most 64 deep, no key twice in an object. Whatever is wrong gives one
/// line with the field, what it must be and what it is. A type with a form of its own has overloads of
///   void readJson(const std::string& path, const nlohmann::json&, T&)   and   nlohmann::ordered_json writeJson(const T&)
namespace mirrorball::field_json {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

/// @throws InvalidArgument: "path: must be ...; it is ..."
[[noreturn]] void refuse(const std::string& path, const std::string& must, const Json& found);

/// "a, b or c"
std::string listed(std::span<const std::string_view> words);

/// The index of a word among those of an enum. @throws InvalidArgument naming the field and the known words
size_t readWord(const std::string& path, const Json& json, std::span<const std::string_view> known);

/// Reads an object's members into a settings struct. Members that are not fields are unknownKeys().
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

    UnknownKeys unknownKeys() const;
    /// Names that unknownKeys() leaves out.
    std::set<std::string, std::less<>>& known() { return m_known; }

    /// One value of any kind that a field may have.
    template <typename T>
    static void read(const std::string& path, const Field& field, const Json& json, T& value)
    {
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int> || std::is_same_v<T, double> || std::is_same_v<T, std::string>) {
            readPlain(path, field, json, value);
        } else if constexpr (std::is_same_v<T, glm::dvec3>) {
            if (!json.is_array() || json.size() != 3)
                refuse(path, "a list of three numbers", json);
            for (int c = 0; c < 3; ++c)
                readPlain(path + "[" + std::to_string(c) + "]", field, json[static_cast<size_t>(c)], value[c]);
        } else if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(readWord(path, json, words(T{})));
        } else if constexpr (hasFields<T>) {
            Reader reader(path, json);
            T::visitFields(value, reader);
            value.unknown = reader.unknownKeys();
        } else {
            readJson(path, json, value);
        }
    }
    template <typename T>
    static void read(const std::string& path, const Field& field, const Json& json, std::vector<T>& value)
    {
        if (!json.is_array())
            refuse(path, "a list in [ ]", json);
        checkCount(path, field, json.size());
        value.assign(json.size(), T{});
        for (size_t i = 0; i < json.size(); ++i)
            read(path + "[" + std::to_string(i) + "]", field, json[i], value[i]);
    }
    /// An enum that may be left to the program is written "auto" then; a struct that may be missing is null.
    template <typename T>
    static void read(const std::string& path, const Field& field, const Json& json, std::optional<T>& value)
    {
        value.reset();
        if constexpr (std::is_enum_v<T>) {
            std::vector<std::string_view> known{"auto"};
            known.insert(known.end(), words(T{}).begin(), words(T{}).end());
            const size_t word = readWord(path, json, known);
            if (word > 0)
                value = static_cast<T>(word - 1);
        } else if (!json.is_null()) {
            read(path, field, json, value.emplace());
        }
    }

private:
    static void readPlain(const std::string& path, const Field& field, const Json& json, double& value);
    static void readPlain(const std::string& path, const Field& field, const Json& json, int& value);
    static void readPlain(const std::string& path, const Field& field, const Json& json, bool& value);
    static void readPlain(const std::string& path, const Field& field, const Json& json, std::string& value);

    std::string m_path;
    const Json& m_object;
    std::set<std::string, std::less<>> m_known;
};

/// Puts a settings struct's members into an object, then its unknown keys.
class Writer {
public:
    explicit Writer(OrderedJson& object) : m_object(object) { m_object = OrderedJson::object(); }

    template <typename T>
    void operator()(const Field& field, const T& value)
    {
        m_object[std::string(field.name)] = toJson(value);
    }
    void writeUnknown(const UnknownKeys& unknown);

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
            return wordOf(value);
        } else if constexpr (std::is_same_v<T, glm::dvec3>) {
            return {value.x, value.y, value.z};
        } else if constexpr (requires { writeJson(value); }) {
            return writeJson(value);
        } else {
            return value;
        }
    }
    template <typename T>
    static OrderedJson toJson(const std::vector<T>& list)
    {
        OrderedJson json = OrderedJson::array();
        for (const T& entry : list)
            json.push_back(toJson(entry));
        return json;
    }
    template <typename T>
    static OrderedJson toJson(const std::optional<T>& value)
    {
        if (value)
            return toJson(*value);
        if constexpr (std::is_enum_v<T>)
            return "auto";
        else
            return nullptr;
    }

private:
    OrderedJson& m_object;
};

/// Parses JSON, refusing what nlohmann's parser lets through: deep nesting and keys that occur twice.
/// @param what  "scene": for messages. @throws InvalidArgument
Json parse(const std::string& text, std::string_view what);

/// The text of a file as UTF-8, which it is or, by its byte order mark, UTF-16. @throws InvalidArgument without the file's name (see
/// namingFile)
std::string readText(const std::filesystem::path& path, std::string_view what);

/// Checks the member "version". @throws InvalidArgument for a file of a newer version or none
void checkVersion(const Json& json, int version, std::string_view what);

/// Runs `load` and puts the file's name before whatever it has to say.
template <typename Load>
auto namingFile(const std::filesystem::path& path, Load&& load)
{
    try {
        return load();
    } catch (const FileError&) { // of another file, which it names
        throw;
    } catch (const InvalidArgument& error) {
        throw FileError(path.string(), error.what());
    }
}

/// Writes a file, whole or not at all. @throws InvalidArgument where it could not be read again: then what was there stays; WorkError
void save(const OrderedJson& json, const std::filesystem::path& path, std::string_view what);

/// The folder that a file lies in, absolute.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// A path that was relative to the folder `from`, relative to `to`. Empty, absolute and "builtin:" ones stay. Where folders are links, so
/// that
/// ".." leads elsewhere than it reads, it becomes absolute. Both folders must be absolute.
std::string rebased(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to);

/// A path of a file of Windows, with `/` for every `\`; others stay, and so does the name of a file of `folder` that has a `\` in it.
std::string withSlashes(const std::string& path, const std::filesystem::path& folder);

/// A path as a file in the folder `to` keeps it: rebased(), and relative where it is absolute but lies in `to` or below, so that the folder
/// can be moved as a whole.
std::string storedPath(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace mirrorball::field_json
