#include "map_file.h"

#include "color.h"
#include "image_format.h"
#include "opacity.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <optional>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 6> faceNames{"px", "nx", "py", "ny", "pz", "nz"};
constexpr std::string_view faceMark = "%s", levelMark = "%d";

/// The file with the first `mark` of its name replaced; nothing when it has none.
std::optional<std::filesystem::path> withMarkReplaced(const std::filesystem::path& path, std::string_view mark, std::string_view word)
{
    std::string file = path.filename().string();
    const size_t at = file.find(mark);
    if (at == std::string::npos)
        return {};
    return path.parent_path() / file.replace(at, mark.size(), word);
}

/// NAME.LEVEL.EXT, or where the name has a `%d` the level in its place.
std::filesystem::path withLevel(const std::filesystem::path& path, size_t level)
{
    if (auto named = withMarkReplaced(path, levelMark, std::to_string(level)))
        return *named;
    std::filesystem::path result = path;
    result.replace_extension();
    result += '.';
    result += std::to_string(level);
    result += path.extension();
    return result;
}

struct Edges {
    int width = 0, height = 0;
};

/// Whether each level has half the edges of the one before, rounded down, which a mip-mapped file takes for granted.
bool halveExactly(const std::vector<Edges>& levels)
{
    for (size_t i = 1; i < levels.size(); ++i)
        if (levels[i].width != std::max(1, levels[i - 1].width / 2) || levels[i].height != std::max(1, levels[i - 1].height / 2))
            return false;
    return true;
}

/// The files of one chain of images: one where it holds them all, else one a level.
std::vector<std::filesystem::path> levelFiles(const std::filesystem::path& out, const std::vector<Edges>& levels)
{
    if (!namesLevels(out) && (levels.size() == 1 || (holdsMips(out) && halveExactly(levels))))
        return {out};
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < levels.size(); ++i)
        files.push_back(withLevel(out, i));
    return files;
}

std::vector<std::filesystem::path> writeLevels(const std::filesystem::path& out, const std::vector<Image>& levels,
                                               const WriteOptions& options)
{
    std::vector<Edges> edges;
    for (const Image& level : levels)
        edges.push_back({level.width, level.height / options.faces});
    std::vector<std::filesystem::path> files = levelFiles(out, edges);
    if (files.size() < levels.size())
        writeMips(out, levels, options);
    else
        for (size_t i = 0; i < levels.size(); ++i)
            writeImage(files[i], levels[i], options);
    return files;
}

/// NAME with its `%s` replaced by the word of each face; empty when it has none.
std::vector<std::filesystem::path> faceFiles(const std::filesystem::path& out, Parameterization kind)
{
    if (!namesFaces(out))
        return {};
    if (kind != Parameterization::Cube)
        throw InvalidArgument("output: '%s' stands for the six faces of a cube, but this map is a " + std::string(name(kind)) +
                              " map; give a plain name, or '%d' for one file a level");
    std::vector<std::filesystem::path> files;
    for (const std::string_view word : faceNames)
        files.push_back(*withMarkReplaced(out, faceMark, word));
    return files;
}

bool keepsFaces(const ImageFormat& format, const MapLayout& layout) { return format.faces && layout.kind == Parameterization::Cube; }

Image face(const Image& cube, int index)
{
    Image result(cube.width, cube.width, cube.channels);
    std::copy_n(cube.row(index * cube.width), result.texels.size(), result.texels.begin());
    return result;
}

} // namespace

bool namesLevels(const std::filesystem::path& out) { return out.filename().string().find(levelMark) != std::string::npos; }

bool namesFaces(const std::filesystem::path& out) { return out.filename().string().find(faceMark) != std::string::npos; }

std::vector<std::filesystem::path> mapFiles(const std::filesystem::path& out, const std::vector<MapLayout>& levels)
{
    const ImageFormat& format = writableFormat(out);
    std::vector<Edges> edges;
    const std::vector<std::filesystem::path> faces = faceFiles(out, levels.front().kind);
    const bool areFaces = !faces.empty() || keepsFaces(format, levels.front());
    for (const MapLayout& level : levels)
        edges.push_back({level.width(), areFaces ? level.width() : level.height()});
    if (faces.empty())
        return levelFiles(out, edges);
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& faceFile : faces)
        for (std::filesystem::path& file : levelFiles(faceFile, edges))
            files.push_back(std::move(file));
    return files;
}

std::vector<std::filesystem::path> writeMap(const std::filesystem::path& out, const std::vector<EnvironmentMap>& levels,
                                            const WriteOptions& options)
{
    const MapLayout& layout = levels.front().layout;
    WriteOptions described = options;
    described.attributes["mirrorball:parameterization"] = name(layout.kind);
    if (layout.border > 0)
        described.attributes["mirrorball:border"] = std::to_string(layout.border);

    const std::vector<std::filesystem::path> faces = faceFiles(out, layout.kind);
    std::vector<Image> images;
    if (faces.empty()) {
        described.faces = keepsFaces(writableFormat(out), layout) ? 6 : 1;
        for (const EnvironmentMap& level : levels)
            images.push_back(level.image);
        return writeLevels(out, images, described);
    }
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < faces.size(); ++i) {
        images.clear();
        for (const EnvironmentMap& level : levels)
            images.push_back(face(level.image, static_cast<int>(i)));
        described.attributes["mirrorball:parameterization"] = "cube face " + std::string(faceNames[i]);
        for (auto& written : writeLevels(faces[i], images, described))
            files.push_back(std::move(written));
    }
    return files;
}

std::vector<std::filesystem::path> writePictures(const std::filesystem::path& out, const std::vector<Image>& levels,
                                                 const WriteOptions& options)
{
    faceFiles(out, Parameterization::Sphere); // says that a picture has no faces
    const ImageFormat& format = writableFormat(out);
    if (format.samples != StoredSamples::Byte)
        return writeLevels(out, levels, options);
    std::vector<Image> shown;
    for (const Image& level : levels)
        shown.push_back(toDisplay(level.channels == 4 && !format.alpha ? withoutOpacity(level) : level, 0.0, ToneCurve::None));
    WriteOptions display = options;
    display.encoding = Encoding::Display;
    return writeLevels(out, shown, display);
}

void checkMapFile(const std::filesystem::path& out, const MapLayout& base) { checkTarget(mapFiles(out, {base}).front()); }

} // namespace mirrorball
