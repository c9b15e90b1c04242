#include "opened_file.h"

#include "error.h"
#include "file_log.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <sys/stat.h>

namespace mirrorball {

namespace {

std::FILE* opened(const std::filesystem::path& path)
{
    noteRead(path);
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw FileError(path.string(), "there is no such file; check the name");
    if (status.type() == std::filesystem::file_type::directory)
        throw FileError(path.string(), "this is a folder; name an image file");
    if (status.type() != std::filesystem::file_type::regular)
        throw FileError(path.string(), error ? "cannot be read: " + error.message() + "; check its permissions"
                                             : std::string("this is not a regular file; save the image to one first"));
    std::FILE* file = std::fopen(path.c_str(), "rbe"); // e: programs that are started do not get it
    if (!file)
        throw FileError(path.string(), std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
    return file;
}

} // namespace

OpenedFile::OpenedFile(std::filesystem::path path) : m_path(std::move(path)), m_file(opened(m_path), &std::fclose)
{
    struct stat status {};
    if (::fstat(::fileno(m_file.get()), &status) != 0)
        throw FileError(m_path.string(), std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions");
    m_size = static_cast<std::uint64_t>(status.st_size);
    constexpr size_t looked = 16;
    m_firstBytes.resize(looked);
    m_firstBytes.resize(read(m_firstBytes.data(), looked));
    if (m_firstBytes.empty())
        throw FileError(m_path.string(), "the file is empty; export or download it again");
    seek(0);
}

std::string OpenedFile::readAll(std::uint64_t most)
{
    if (m_size > most)
        throw FileError(m_path.string(), "has " + std::to_string(m_size) + " bytes, and no more than " + std::to_string(most) +
                                             " are read of a file of its kind; it is damaged, or scale it down first");
    seek(0);
    std::string bytes(static_cast<size_t>(m_size), '\0');
    bytes.resize(read(bytes.data(), bytes.size()));
    return bytes;
}

std::uint64_t OpenedFile::position() const { return static_cast<std::uint64_t>(::ftello(m_file.get())); }

void OpenedFile::seek(std::uint64_t position)
{
    if (::fseeko(m_file.get(), static_cast<off_t>(position), SEEK_SET) != 0)
        throw FileError(m_path.string(), std::string("cannot be read: ") + std::strerror(errno));
}

} // namespace mirrorball
