#include "mesh_files.h"

#include "obj_text.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <string>

namespace mirrorball::helper {
namespace {

/// RFC 3986, section 2.1.
std::string percentDecoded(const std::string& text)
{
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) ? c - '0' : std::tolower(c) - 'a' + 10; };
    std::string decoded;
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] == '%' && i + 2 < text.size() && std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
            std::isxdigit(static_cast<unsigned char>(text[i + 2]))) {
            decoded += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
            i += 2;
        } else {
            decoded += text[i];
        }
    return decoded;
}

std::string textOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool beginsWithMark(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string mark(3, '\0');
    return file.read(mark.data(), 3) && mark == "\xef\xbb\xbf";
}

Assimp::IOStream* streamOf(const std::string& text)
{
    auto* bytes = new std::uint8_t[text.size() + 1]; // the stream's own
    std::copy(text.begin(), text.end(), bytes);
    return new Assimp::MemoryIOStream(bytes, text.size(), true);
}

bool isObj(const std::filesystem::path& path)
{
    const std::string extension = path.extension().string();
    return extension.size() == 4 &&
           std::equal(extension.begin(), extension.end(), ".obj", [](unsigned char a, char b) { return std::tolower(a) == b; });
}

} // namespace

Assimp::IOStream* MeshFiles::Open(const char* file, const char* mode)
{
    const std::filesystem::path path = mode[0] == 'r' ? found(file) : std::filesystem::path();
    if (path.empty())
        return nullptr;
    m_opened.insert(path.string());
    const size_t mark = beginsWithMark(path) ? 3 : 0;
    if (isObj(path)) {
        ObjText good = withoutBadFaces(textOf(path).substr(mark));
        m_dropped = good.dropped; // assimp opens it several times
        return streamOf(good.text);
    }
    return mark > 0 ? streamOf(textOf(path).substr(mark)) : DefaultIOSystem::Open(path.c_str(), mode);
}

std::filesystem::path MeshFiles::found(const char* name) const
{
    for (const std::string& text : {std::string(name), percentDecoded(name)}) {
        std::error_code error;
        const std::filesystem::path path = std::filesystem::weakly_canonical(text, error);
        if (!error && text.find('\0') == std::string::npos && allows(path))
            return path;
    }
    return {};
}

bool MeshFiles::allows(const std::filesystem::path& file) const
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) > m_largest)
        return false;
    const auto below = std::mismatch(m_folder.begin(), m_folder.end(), file.begin(), file.end());
    return below.first == m_folder.end();
}

} // namespace mirrorball::helper
