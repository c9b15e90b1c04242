#include "atomic_file.h"

#include "error.h"
#include "file_log.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mirrorball {
namespace {

std::string remedy(int error)
{
    switch (error) {
    case ENOENT:
    case ENOTDIR:
        return "create the folder first";
    case EACCES:
    case EPERM:
    case EROFS:
        return "choose a folder that you may write to";
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "free some space or write elsewhere";
    default:
        return "try another place";
    }
}

WorkError writeError(const std::filesystem::path& path, int error)
{
    return WorkError(path.string() + ": cannot be written: " + std::strerror(error) + "; " + remedy(error));
}

void syncFolder(const std::filesystem::path& folder)
{
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;                             // a folder may be written to that may not be read
    static_cast<void>(::fsync(descriptor)); // not every file system can
    ::close(descriptor);
}

} // namespace

std::filesystem::path replaceableTarget(const std::filesystem::path& named)
{
    std::filesystem::path target = named;
    std::error_code ignored;
    for (int links = 0; links < 40 && std::filesystem::is_symlink(target, ignored); ++links)
        target = target.parent_path() / std::filesystem::read_symlink(target, ignored);
    struct stat existing {};
    if (::stat(target.c_str(), &existing) == 0 && !S_ISREG(existing.st_mode))
        throw WorkError(named.string() + ": cannot be written: it is " + (S_ISDIR(existing.st_mode) ? "a folder" : "not a regular file") +
                        "; name a file");
    return target;
}

void takeOwnership(int descriptor, const std::filesystem::path& existing)
{
    struct stat old {
    }, now{};
    if (::stat(existing.c_str(), &old) != 0 || ::fstat(descriptor, &now) != 0)
        return;
    if (old.st_uid != now.st_uid)
        static_cast<void>(::fchown(descriptor, old.st_uid, static_cast<gid_t>(-1)));
    const bool keepsGroup = old.st_gid == now.st_gid || ::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) == 0;
    static_cast<void>(::fchmod(descriptor, old.st_mode & (keepsGroup ? 0777 : 0707))); // best effort: the bytes matter more
}

AtomicFile::AtomicFile(const std::filesystem::path& target, Durability durability)
    : m_named(target), m_target(replaceableTarget(target)), m_durability(durability)
{
    try {
        m_temporary.emplace(m_target, TemporaryPath::Kind::File);
    } catch (const std::system_error& error) {
        throw writeError(target, error.code().value());
    }
    takeOwnership(m_temporary->descriptor(), m_target);
    // The stream gets a descriptor of its own: closing it tells the last errors, while the lock is held on until the file has its name.
    const int descriptor = ::fcntl(m_temporary->descriptor(), F_DUPFD_CLOEXEC, 0);
    m_file = descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+b");
    if (!m_file) {
        const int error = errno;
        if (descriptor >= 0)
            ::close(descriptor);
        throw writeError(target, error);
    }
}

void checkTarget(const std::filesystem::path& target) { const AtomicFile made(target); }

AtomicFile::~AtomicFile()
{
    if (m_file)
        std::fclose(m_file);
}

void AtomicFile::fail(int error)
{
    if (m_error == 0)
        m_error = error != 0 ? error : EIO;
    throw writeError(m_named, m_error);
}

void AtomicFile::write(const void* bytes, size_t count)
{
    if (count == 0)
        return; // some writers pass a null pointer then, which fwrite may not get
    errno = 0;
    if (m_error != 0 || std::fwrite(bytes, 1, count, m_file) != count)
        fail(errno);
}

std::uint64_t AtomicFile::position() { return static_cast<std::uint64_t>(::ftello(m_file)); }

void AtomicFile::seek(std::uint64_t position)
{
    errno = 0;
    if (m_error != 0 || ::fseeko(m_file, static_cast<off_t>(position), SEEK_SET) != 0)
        fail(errno);
}

void AtomicFile::commit()
{
    errno = 0;
    std::FILE* const file = m_file;
    m_file = nullptr;
    const bool synced = m_durability == Durability::Buffered || (std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0);
    if (!synced)
        m_error = errno;
    if (std::fclose(file) != 0 || m_error != 0)
        fail(errno);
    if (std::rename(m_temporary->path().c_str(), m_target.c_str()) != 0)
        fail(errno);
    m_temporary->release();
    noteWritten(m_named);
    if (m_durability == Durability::Synced)
        syncFolder(m_target.parent_path());
}

} // namespace mirrorball
