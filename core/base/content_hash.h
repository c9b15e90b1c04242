#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace mirrorball {

/// SHA-256 (FIPS 180-4, by libcrypto) of bytes, as 64 hexadecimal digits.
std::string contentHash(std::string_view bytes);

/// A file's content.
struct FileContent {
    std::uint64_t bytes = 0;
    std::string sha256{};

    bool operator==(const FileContent&) const = default;
};
/// Reads the file once, block by block. @throws FileError where it cannot be read
FileContent fileContent(const std::filesystem::path& path);

} // namespace mirrorball
