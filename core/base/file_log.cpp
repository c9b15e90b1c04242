#include "file_log.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <mutex>
#include <system_error>

#include <sys/stat.h>

namespace mirrorball {
namespace {

/// Of the process, as its files are: a reader deep in a call has nobody to hand the path to.
struct Log {
    std::atomic<bool> isOpen{false};
    std::mutex mutex;
    std::vector<FileRead> read;
    std::vector<std::filesystem::path> written;
};

Log& log()
{
    static Log only;
    return only;
}

std::filesystem::path absolutePath(const std::filesystem::path& path) { return std::filesystem::absolute(path).lexically_normal(); }

} // namespace

FileStamp fileStamp(const std::filesystem::path& path)
{
    struct stat now {};
    if (::stat(path.c_str(), &now) != 0)
        throw std::system_error(errno, std::generic_category(), path.string());
    return {static_cast<std::uint64_t>(now.st_dev), static_cast<std::uint64_t>(now.st_ino), static_cast<std::uint64_t>(now.st_size),
            std::int64_t{now.st_mtim.tv_sec} * 1'000'000'000 + now.st_mtim.tv_nsec};
}

FileLog::FileLog()
{
    const std::lock_guard lock(log().mutex);
    assert(!log().isOpen);
    log().read.clear();
    log().written.clear();
    log().isOpen = true;
}

FileLog::~FileLog() { log().isOpen = false; }

std::vector<FileRead> FileLog::read() const
{
    const std::lock_guard lock(log().mutex);
    return log().read;
}

std::vector<std::filesystem::path> FileLog::written() const
{
    const std::lock_guard lock(log().mutex);
    std::vector<std::filesystem::path> files;
    std::copy_if(log().written.begin(), log().written.end(), std::back_inserter(files),
                 [](const std::filesystem::path& path) { return std::filesystem::is_regular_file(path); });
    return files;
}

void noteRead(const std::filesystem::path& path)
{
    if (!log().isOpen)
        return;
    const std::filesystem::path whole = absolutePath(path);
    std::error_code missing;
    if (!std::filesystem::is_regular_file(whole, missing))
        return; // opening it fails, in words of its own
    const FileStamp stamp = fileStamp(whole);
    const std::lock_guard lock(log().mutex);
    const auto isThis = [&](const FileRead& known) { return known.path == whole; };
    if (std::none_of(log().read.begin(), log().read.end(), isThis))
        log().read.push_back({whole, stamp});
}

void noteWritten(const std::filesystem::path& path)
{
    if (!log().isOpen)
        return;
    const std::filesystem::path whole = absolutePath(path);
    const std::lock_guard lock(log().mutex);
    auto& written = log().written;
    if (std::find(written.begin(), written.end(), whole) == written.end())
        written.push_back(whole);
}

} // namespace mirrorball
