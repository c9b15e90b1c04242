#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace mirrorball {

/// The bytes of a file, which is noted as read.
/// @param most  longer files are refused before memory is taken: a file with holes claims any length and costs nothing
/// @throws FileError
std::string fileBytes(const std::filesystem::path& path, std::uintmax_t most);

} // namespace mirrorball
