#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace mirrorball {

/// A file that is open for reading and goes from hand to hand: what its first bytes told is true of the bytes that are read, even where
/// another file takes its name meanwhile, and it is opened once. It is noted as read (file_log.h).
class OpenedFile {
public:
    /// @throws FileError for what is missing, a folder, empty, or may not be read; and for a pipe, before it could block
    explicit OpenedFile(std::filesystem::path path);

    const std::filesystem::path& path() const { return m_path; }
    /// Bytes, as they were when it was opened.
    std::uint64_t size() const { return m_size; }
    /// The first 16, or as many as there are: what a file is, is told by them.
    std::string_view firstBytes() const { return m_firstBytes; }

    /// Reads on from where it stands. @return bytes read: fewer than `most` where the file ends
    size_t read(void* to, size_t most) { return std::fread(to, 1, most, m_file.get()); }
    /// All of it.
    /// @param most  longer files are refused before memory is taken: a file with holes claims any length and costs nothing
    /// @throws FileError
    std::string readAll(std::uint64_t most);
    std::uint64_t position() const;
    void seek(std::uint64_t position);

private:
    std::filesystem::path m_path;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_file;
    std::uint64_t m_size = 0;
    std::string m_firstBytes{};
};

} // namespace mirrorball
