#include "file_transaction.h"

#include "atomic_file.h"
#include "error.h"
#include "file_log.h"

#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

WorkError cannotWrite(const std::filesystem::path& path, int error)
{
    return WorkError(path.string() + ": cannot be written: " + std::strerror(error) + "; free some space or choose another folder");
}

struct Descriptor {
    int number;
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (number >= 0)
            ::close(number);
    }
};

Json entryOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> block(size_t{1} << 16);
    uLong sum = ::crc32(0, nullptr, 0);
    std::uint64_t bytes = 0;
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0) {
        sum = ::crc32(sum, reinterpret_cast<const Bytef*>(block.data()), static_cast<uInt>(stream.gcount()));
        bytes += static_cast<std::uint64_t>(stream.gcount());
    }
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%08lx", sum);
    return {{"file", file.filename().string()}, {"bytes", bytes}, {"crc32", text.data()}};
}

/// The entries of an older manifest by file; none where there is none that can be read.
std::map<std::string, Json> entriesOf(const std::filesystem::path& manifest)
{
    std::map<std::string, Json> entries;
    std::error_code ignored;
    if (std::filesystem::file_size(manifest, ignored) > (std::uintmax_t{1} << 24) || ignored)
        return entries;
    std::ifstream stream(manifest, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const Json old = Json::parse(text, nullptr, false);
    if (!old.is_object() || !old.contains("files") || !old["files"].is_array())
        return entries;
    for (const Json& entry : old["files"])
        if (entry.is_object() && entry.contains("file") && entry["file"].is_string())
            entries[entry["file"].get<std::string>()] = entry;
    return entries;
}

/// A target that is a link to another file system takes the bytes and not the file.
void moveTo(const std::filesystem::path& file, const std::filesystem::path& target, const std::filesystem::path& named)
{
    if (std::rename(file.c_str(), target.c_str()) == 0)
        return;
    if (errno != EXDEV)
        throw cannotWrite(named, errno);
    AtomicFile copy(target, Durability::Synced);
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> block(size_t{1} << 20);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0)
        copy.write(block.data(), static_cast<size_t>(stream.gcount()));
    copy.commit();
}

std::filesystem::path checkedFolder(const std::filesystem::path& folder)
{
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
        throw cannotWrite(folder, errno);
    return folder;
}

} // namespace

FileTransaction::FileTransaction(const std::filesystem::path& folder)
try : m_folder(checkedFolder(folder)), m_staging(folder / "export", TemporaryPath::Kind::Folder) {
} catch (const std::system_error& error) {
    throw cannotWrite(folder, error.code().value());
}

std::vector<std::filesystem::path> FileTransaction::names() const
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(staging()))
        if (entry.is_regular_file() && entry.path().filename() != manifestName)
            files.push_back(entry.path().filename());
    std::sort(files.begin(), files.end());
    std::stable_partition(files.begin(), files.end(), [](const auto& file) { return file.extension() != ".json"; }); // which describe them
    return files;
}

std::string FileTransaction::aboutTheFolder(std::string message) const
{
    const std::string inside = staging().string(), folder = m_folder.string();
    for (size_t at = message.find(inside); at != std::string::npos; at = message.find(inside, at + folder.size()))
        message.replace(at, inside.size(), folder);
    return message;
}

void FileTransaction::addManifest()
{
    std::map<std::string, Json> entries = entriesOf(m_folder / manifestName);
    std::erase_if(entries, [&](const auto& entry) { return !std::filesystem::is_regular_file(m_folder / entry.first); });
    for (const std::filesystem::path& name : names())
        entries[name.string()] = entryOf(staging() / name);
    Json files = Json::array();
    for (auto& [name, entry] : entries)
        files.push_back(std::move(entry));
    const std::string text = Json{{"version", 1}, {"files", std::move(files)}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    AtomicFile file(staging() / manifestName);
    file.write(text.data(), text.size());
    file.commit();
}

void FileTransaction::commit()
{
    struct Move {
        std::filesystem::path name, target;
    };
    std::vector<Move> moves;
    std::vector<std::filesystem::path> files = names();
    if (std::filesystem::exists(staging() / manifestName))
        files.emplace_back(manifestName);
    for (const std::filesystem::path& name : files) {
        moves.push_back({name, replaceableTarget(m_folder / name)});
        const Descriptor made(::open((staging() / name).c_str(), O_RDONLY | O_CLOEXEC));
        takeOwnership(made.number, moves.back().target);
    }
    if (::syncfs(m_staging.descriptor()) != 0)
        throw cannotWrite(m_folder, errno);
    const Descriptor folder(::open(m_folder.empty() ? "." : m_folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.number >= 0)
        static_cast<void>(::flock(folder.number, LOCK_EX)); // not every file system can
    for (const Move& move : moves) {
        moveTo(staging() / move.name, move.target, m_folder / move.name);
        noteWritten(m_folder / move.name);
    }
    if (folder.number >= 0)
        static_cast<void>(::fsync(folder.number));
}

} // namespace mirrorball
