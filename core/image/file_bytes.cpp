#include "file_bytes.h"

#include "core/base/error.h"
#include "core/base/file_log.h"

#include <fstream>

namespace mirrorball {

std::string fileBytes(const std::filesystem::path& path, std::uintmax_t most)
{
    noteRead(path);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream)
        throw FileError(path.string(), "cannot be read; check its name and permissions");
    if (size > most)
        throw FileError(path.string(), "has " + std::to_string(size) + " bytes, and no more than " + std::to_string(most) +
                                           " are read of a file of its kind; it is damaged, or scale it down first");
    std::string bytes(static_cast<size_t>(size), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(stream.gcount()));
    return bytes;
}

} // namespace mirrorball
