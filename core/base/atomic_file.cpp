#include "atomic_file.h"

#include "error.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

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

/// A name that no other writer of this or another process uses: O_EXCL decides, the counter only makes a clash unlikely.
std::filesystem::path temporaryName(const std::filesystem::path& target)
{
    static std::atomic<unsigned> counter{0};
    // The name of a target may use up all that the file system allows, so only part of it is repeated.
    std::string name = target.filename().string().substr(0, 200);
    name.insert(0, 1, '.');
    name.append(".tmp").append(std::to_string(::getpid())).append("-").append(std::to_string(counter++));
    return target.parent_path() / name;
}

} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& target) : m_named(target), m_target(target)
{
    std::error_code ignored;
    for (int links = 0; links < 40 && std::filesystem::is_symlink(m_target, ignored); ++links)
        m_target = m_target.parent_path() / std::filesystem::read_symlink(m_target, ignored);
    struct stat existing {};
    const bool exists = ::stat(m_target.c_str(), &existing) == 0;
    if (exists && !S_ISREG(existing.st_mode))
        throw WorkError(target.string() + ": cannot be written: it is " + (S_ISDIR(existing.st_mode) ? "a folder" : "not a regular file") +
                        "; name a file");

    int descriptor = -1;
    do {
        m_temporary = temporaryName(m_target);
        descriptor = ::open(m_temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    if (descriptor < 0)
        throw writeError(target, errno);
    if (exists)
        static_cast<void>(::fchmod(descriptor, existing.st_mode & 07777)); // best effort: the bytes matter more than the mode
    m_file = ::fdopen(descriptor, "w+b");
    if (!m_file) {
        const int error = errno;
        ::close(descriptor);
        ::unlink(m_temporary.c_str());
        throw writeError(target, error);
    }
}

void checkTarget(const std::filesystem::path& target) { const AtomicFile made(target); }

AtomicFile::~AtomicFile()
{
    if (m_file)
        std::fclose(m_file);
    if (!m_temporary.empty())
        ::unlink(m_temporary.c_str());
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
    if (std::fclose(file) != 0 || m_error != 0)
        fail(errno);
    if (std::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        fail(errno);
    m_temporary.clear();
}

} // namespace mirrorball
