#include "mesh_files.h"

#include "gltf_text.h"
#include "obj_text.h"
#include "off_text.h"

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

/// @param text  lives longer than the stream
Assimp::IOStream* streamOf(const std::string& text)
{
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

/// A copy of the stream's own.
Assimp::IOStream* streamOfCopy(const std::string& text)
{
    auto* bytes = new std::uint8_t[text.size() + 1];
    std::copy(text.begin(), text.end(), bytes);
    return new Assimp::MemoryIOStream(bytes, text.size(), true);
}

/// ".obj"
std::string lowerExtension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

} // namespace

MeshFiles::MeshFiles(const std::filesystem::path& mesh, std::uintmax_t largest)
    : m_mesh(mesh), m_folder(mesh.parent_path()), m_largest(largest)
{
    const std::string extension = lowerExtension(mesh);
    const bool isObj = extension == ".obj", isOff = extension == ".off", isGltf = extension == ".gltf" || extension == ".glb";
    if ((!isObj && !isOff && !isGltf) || !allows(mesh))
        return;
    std::string text = textOf(mesh).substr(beginsWithMark(mesh) ? 3 : 0);
    if (isObj) {
        ObjText good = withoutBadFaces(text);
        m_dropped = good.dropped;
        m_text = std::move(good.text);
    } else if (isOff) {
        OffText good = cleanedOff(text);
        m_dropped = good.dropped;
        m_split = std::move(good.split);
        m_text = std::move(good.text);
    } else {
        GltfText good = withFloatAttributes(text, [&](const std::string& uri) { return bytesBeside(uri); });
        m_text = std::move(good.bytes);
        m_floats = std::move(good.floats);
    }
}

Assimp::IOStream* MeshFiles::Open(const char* file, const char* mode)
{
    if (mode[0] == 'r' && isUnpacked(file))
        return streamOf(m_floats);
    const std::filesystem::path path = mode[0] == 'r' ? found(file) : std::filesystem::path();
    if (path.empty())
        return nullptr;
    m_opened.insert(path.string());
    if (m_text && path == m_mesh)
        return streamOf(*m_text);
    return beginsWithMark(path) ? streamOfCopy(textOf(path).substr(3)) : DefaultIOSystem::Open(path.c_str(), mode);
}

bool MeshFiles::isUnpacked(const std::filesystem::path& name) const { return !m_floats.empty() && name.filename() == gltfFloats; }

std::optional<std::string> MeshFiles::bytesBeside(const std::string& uri)
{
    const std::filesystem::path path = found((m_folder / uri).c_str());
    if (path.empty())
        return {};
    m_opened.insert(path.string());
    return textOf(path);
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
