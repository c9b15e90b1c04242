#pragma once

#include "core/base/error.h"
#include "core/image/image_io.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <unistd.h>

namespace mirrorball::fuzz {

/// Files that go when the program ends.
class InputFiles {
public:
    ~InputFiles()
    {
        std::error_code ignored;
        for (const std::filesystem::path& path : m_paths)
            std::filesystem::remove(path, ignored);
    }
    void add(const std::filesystem::path& path) { m_paths.insert(path); }

private:
    std::set<std::filesystem::path> m_paths;
};

/// The input as a file in memory, for readers that take a path.
inline std::filesystem::path fileOf(const std::uint8_t* bytes, std::size_t size, std::string_view extension)
{
    static const std::filesystem::path folder =
        std::filesystem::exists("/dev/shm") ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
    std::filesystem::path path = folder / ("mirrorball-fuzz-" + std::to_string(::getpid()) + std::string(extension));
    static InputFiles files;
    files.add(path);
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    return path;
}

/// Runs a reader: what it refuses it must refuse with one of our errors, in one line.
template <class Read>
int refusingPolitely(const Read& read)
{
    try {
        read();
    } catch (const Error& error) {
        if (std::string_view(error.what()).empty() || std::string_view(error.what()).find('\n') != std::string_view::npos)
            __builtin_trap();
    }
    return 0;
}

/// Reads all rows of pictures up to the size that fits a fuzzer's memory.
inline void readRows(ImageReader& reader)
{
    const int width = reader.info().width, height = reader.info().height;
    constexpr int block = 16;
    if (width > 1 << 20)
        return;
    std::vector<float> rows(static_cast<std::size_t>(width) * block * 3);
    for (int y = 0; y < height; y += block)
        reader.readRows(y, std::min(block, height - y), rows.data());
}

} // namespace mirrorball::fuzz
