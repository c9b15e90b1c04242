#include "field_json.h"

#include "atomic_file.h"
#include "file_log.h"

#include <fstream>

namespace mirrorball::field_json {

namespace {

constexpr size_t largestFile = size_t{128} << 20; // a list of strokes at its limits (stroke.h) takes about 100 MiB
constexpr size_t mostValues = size_t{1} << 23;    // such a list as lists of numbers, [x, y, pressure], is 6 million
constexpr size_t deepest = 64;

/// Refuses what nlohmann's parser lets through: deep nesting, keys that occur twice, and more values than memory should be spent on. A pass
/// of its own, because the parser's callback takes time that grows with the square of a list's length.
class Checker : public Json::json_sax_t {
public:
    explicit Checker(std::string_view what) : m_what(what) {}

    bool null() override { return count(); }
    bool boolean(bool) override { return count(); }
    bool number_integer(number_integer_t) override { return count(); }
    bool number_unsigned(number_unsigned_t) override { return count(); }
    bool number_float(number_float_t, const string_t&) override { return count(); }
    bool string(string_t&) override { return count(); }
    bool binary(binary_t&) override { return count(); }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& key) override
    {
        if (!m_keys.back().insert(key).second)
            throw InvalidArgument("the key " + inQuotes(key) + " occurs twice in one object; remove one");
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; } // told by the parser itself

private:
    bool count()
    {
        if (++m_values > mostValues)
            throw InvalidArgument("holds more than " + std::to_string(mostValues) + " values; this is no " + std::string(m_what));
        return true;
    }
    bool open()
    {
        m_keys.emplace_back();
        if (m_keys.size() > deepest)
            throw InvalidArgument("is nested more than " + std::to_string(deepest) + " deep; this is no " + std::string(m_what));
        return count();
    }
    bool close()
    {
        m_keys.pop_back();
        return true;
    }

    std::string_view m_what;
    size_t m_values = 0;
    std::vector<std::set<std::string>> m_keys; ///< of the objects and lists that are open
};

} // namespace

// ---- reading -------------------------------------------------------------------------------------------------------------------

void refuse(const std::string& path, const std::string& must, const Json& found)
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

size_t readWord(const std::string& path, const Json& json, std::span<const std::string_view> known)
{
    const auto found = json.is_string() ? std::find(known.begin(), known.end(), json.get_ref<const std::string&>()) : known.end();
    if (found == known.end())
        refuse(path, listed(known), json);
    return static_cast<size_t>(found - known.begin());
}

UnknownKeys Reader::unknownKeys() const
{
    UnknownKeys unknown;
    for (const auto& [key, value] : m_object.items())
        if (!m_known.contains(key))
            unknown.emplace(key, value.dump());
    return unknown;
}

void Reader::readPlain(const std::string& path, const Field& field, const Json& json, double& value)
{
    if (!json.is_number())
        refuse(path, "a number", json);
    value = json.get<double>();
    checkRange(path, field, value);
}

void Reader::readPlain(const std::string& path, const Field& field, const Json& json, int& value)
{
    if (!json.is_number_integer())
        refuse(path, "a whole number", json);
    checkRange(path, field, json.get<double>());
    value = json.get<int>();
}

void Reader::readPlain(const std::string& path, const Field&, const Json& json, bool& value)
{
    if (!json.is_boolean())
        refuse(path, "true or false", json);
    value = json.get<bool>();
}

void Reader::readPlain(const std::string& path, const Field&, const Json& json, std::string& value)
{
    if (!json.is_string())
        refuse(path, "a text in quotes", json);
    value = json.get<std::string>();
    if (value.find('\0') != std::string::npos)
        refuse(path, "a text without NUL", json);
}

Json parse(const std::string& text, std::string_view what)
{
    Checker checker(what);
    Json::sax_parse(text, &checker);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const size_t end = std::min(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        throw InvalidArgument("is no JSON from line " + std::to_string(line) + " on; mend it there or load another file");
    } catch (const Json::exception&) {
        throw InvalidArgument("holds a number too large for any computer; mend it or load another file");
    }
}

namespace {

[[noreturn]] void refuseSize(std::string_view what)
{
    throw InvalidArgument("holds more than " + std::to_string(largestFile >> 20) + " MiB; this is no " + std::string(what));
}

void appendUtf8(std::string& text, std::uint32_t code)
{
    const auto tail = [&](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3f)); };
    if (code < 0x80)
        text += static_cast<char>(code);
    else if (code < 0x800)
        text += {static_cast<char>(0xc0 | code >> 6), tail(0)};
    else if (code < 0x10000)
        text += {static_cast<char>(0xe0 | code >> 12), tail(6), tail(0)};
    else
        text += {static_cast<char>(0xf0 | code >> 18), tail(12), tail(6), tail(0)};
}

/// Text that begins with the byte order mark of UTF-16, as some editors and shells of Windows write it, as UTF-8; other text as it is.
/// @throws InvalidArgument for half characters
std::string fromUtf16(std::string text)
{
    const bool little = text.starts_with("\xff\xfe"), big = text.starts_with("\xfe\xff");
    if (!little && !big)
        return text;
    const auto unit = [&](size_t at) -> std::uint32_t {
        const auto first = static_cast<unsigned char>(text[at]), second = static_cast<unsigned char>(text[at + 1]);
        return little ? first | second << 8u : first << 8u | second;
    };
    std::string utf8;
    for (size_t at = 2; at + 1 < text.size(); at += 2) {
        std::uint32_t code = unit(at);
        if (code >> 10 == 0x36 && at + 3 < text.size() && unit(at + 2) >> 10 == 0x37) { // a pair of surrogates
            code = 0x10000 + ((code & 0x3ff) << 10) + (unit(at + 2) & 0x3ff);
            at += 2;
        }
        if (code >> 11 == 0x1b)
            throw InvalidArgument("is UTF-16 with half characters in it; save it as UTF-8");
        appendUtf8(utf8, code);
    }
    if (text.size() % 2 != 0)
        throw InvalidArgument("is UTF-16 and cut short; save it as UTF-8");
    return utf8;
}

/// What reading the text again would refuse, before it takes the place of a good file.
void checkReadable(const std::string& text, const std::filesystem::path& path, std::string_view what)
{
    const auto refuse = [&](const std::string& why) {
        throw InvalidArgument(shownPath(path.string()) + ": was not saved, because nobody could read it again: the " + std::string(what) +
                              " " + why);
    };
    if (text.size() > largestFile)
        refuse("would take " + std::to_string(text.size() >> 20) + " MiB, and " + std::to_string(largestFile >> 20) +
               " MiB are the most; take something out of it");
    try {
        Checker checker(what);
        Json::sax_parse(text, &checker);
    } catch (const InvalidArgument& error) {
        refuse(error.what());
    }
}

} // namespace

std::string readText(const std::filesystem::path& path, std::string_view what)
{
    noteRead(path);
    std::error_code error;
    const auto type = std::filesystem::status(path, error).type();
    if (type == std::filesystem::file_type::directory)
        throw InvalidArgument("is a folder; give a file");
    if (type != std::filesystem::file_type::regular && type != std::filesystem::file_type::not_found) // reading could block
        throw InvalidArgument("is not a regular file; save the " + std::string(what) + " to one first");
    if (const auto size = std::filesystem::file_size(path, error); !error && size > largestFile)
        refuseSize(what);
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw InvalidArgument(std::filesystem::exists(path, error) ? "cannot be opened; check its permissions"
                                                                   : "does not exist; check the path");
    std::string text;
    for (size_t read = 1; read > 0 && text.size() <= largestFile;) { // files of /proc say that they are empty
        const size_t before = text.size(), block = std::max(size_t{1} << 16, before);
        text.resize(before + block);
        file.read(text.data() + before, static_cast<std::streamsize>(block));
        read = static_cast<size_t>(file.gcount());
        text.resize(before + read);
    }
    if (file.bad())
        throw InvalidArgument("cannot be read; check the disk");
    if (text.size() > largestFile)
        refuseSize(what);
    text = fromUtf16(std::move(text));
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InvalidArgument("is empty; write a " + std::string(what) + " into it or load another file");
    return text;
}

void checkVersion(const Json& json, int version, std::string_view what)
{
    const auto found = json.find("version");
    if (found == json.end())
        throw InvalidArgument("version: is missing; a " + std::string(what) + " file begins with {\"version\": 1, ...}");
    if (!found->is_number_integer() || found->get<double>() < 1)
        refuse("version", "a whole number from 1", *found);
    if (found->get<double>() > version)
        throw InvalidArgument("version: is " + found->dump() + ", but this program reads up to " + std::to_string(version) +
                              "; update Mirrorball");
}

// ---- writing -------------------------------------------------------------------------------------------------------------------

void Writer::writeUnknown(const UnknownKeys& unknown)
{
    auto& members = m_object.get_ref<OrderedJson::object_t&>();
    for (const auto& [key, value] : unknown) // appended without a search: there may be very many
        members.push_back({key, OrderedJson::parse(value)});
}

void save(const OrderedJson& json, const std::filesystem::path& path, std::string_view what)
{
    std::string text;
    try {
        text = json.dump(2) + "\n";
    } catch (const OrderedJson::exception&) {
        throw InvalidArgument(path.string() + ": a text of the " + std::string(what) +
                              " is not UTF-8 and cannot be saved; rename the file it names");
    }
    checkReadable(text, path, what);
    AtomicFile file(path, Durability::Synced);
    file.write(text.data(), text.size());
    file.commit();
}

std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return std::filesystem::absolute(file).lexically_normal().parent_path();
}

namespace {

/// A file whose name reads like that of something built in.
std::string asFile(const std::string& relative) { return relative.starts_with("builtin:") ? "./" + relative : relative; }

} // namespace

std::string rebased(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to)
{
    if (path.empty() || path.starts_with("builtin:") || std::filesystem::path(path).is_absolute() || from == to)
        return path;
    std::error_code none; // of a file that does not exist: the text decides
    const std::filesystem::path given = from / path;
    std::filesystem::path whole = given.lexically_normal();
    if (std::filesystem::exists(given, none) && !std::filesystem::equivalent(given, whole, none))
        whole = std::filesystem::canonical(given, none);
    const std::filesystem::path moved = whole.lexically_relative(to);
    if (moved.empty() || (std::filesystem::exists(whole, none) && !std::filesystem::equivalent(to / moved, whole, none)))
        return whole.string();
    return asFile(moved.string());
}

std::string withSlashes(const std::string& path, const std::filesystem::path& folder)
{
    std::error_code none;
    if (path.find('\\') == std::string::npos || std::filesystem::exists(folder / path, none))
        return path;
    std::string slashed = path;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    return slashed;
}

std::string storedPath(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to)
{
    if (!std::filesystem::path(path).is_absolute())
        return rebased(path, from, to);
    const std::filesystem::path inside = std::filesystem::path(path).lexically_normal().lexically_relative(to);
    return inside.empty() || *inside.begin() == ".." || inside == "." ? path : asFile(inside.string());
}

} // namespace mirrorball::field_json
