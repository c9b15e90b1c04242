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

/// NAME.LEVEL.EXT, or where the name has a `%d` the level in its place.
std::filesystem::path withLevel(const std::filesystem::path& path, std::string_view face, size_t level)
{
    if (namesLevels(path))
        return fileNamed(path, {.face = face, .level = static_cast<int>(level)});
    const std::filesystem::path whole = fileNamed(path, {.face = face});
    std::filesystem::path result = whole;
    result.replace_extension();
    result += '.';
    result += std::to_string(level);
    result += whole.extension();
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

/// The files of one chain of images, of one face where `face` names it: one where it holds them all, else one a level.
std::vector<std::filesystem::path> levelFiles(const std::filesystem::path& out, std::string_view face, const std::vector<Edges>& levels)
{
    if (!namesLevels(out) && (levels.size() == 1 || (holdsMips(out) && halveExactly(levels))))
        return {fileNamed(out, {.face = face})};
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < levels.size(); ++i)
        files.push_back(withLevel(out, face, i));
    return files;
}

std::vector<std::filesystem::path> writeLevels(const std::filesystem::path& out, std::string_view face, const std::vector<Image>& levels,
                                               const WriteOptions& options)
{
    std::vector<Edges> edges;
    for (const Image& level : levels)
        edges.push_back({level.width, level.height / options.faces});
    if (levels.size() == 1)
        refuseDoubtfulLevel(out);
    std::vector<std::filesystem::path> files = levelFiles(out, face, edges);
    if (files.size() < levels.size())
        writeMips(files.front(), levels, options);
    else
        for (size_t i = 0; i < levels.size(); ++i)
            writeImage(files[i], levels[i], options);
    return files;
}

/// The words of the faces that a name with `%s` stands for; a single empty one for a name without.
std::vector<std::string_view> facesOf(const std::filesystem::path& out, Parameterization kind)
{
    if (!namesFaces(out))
        return {std::string_view()};
    if (kind != Parameterization::Cube)
        throw InvalidArgument("output: '%s' stands for the six faces of a cube, but this map is a " + std::string(name(kind)) +
                              " map; give a plain name, or '%d' for one file a level");
    return {faceNames.begin(), faceNames.end()};
}

bool keepsFaces(const ImageFormat& format, const MapLayout& layout) { return format.faces && layout.kind == Parameterization::Cube; }

Image face(const Image& cube, int index)
{
    Image result(cube.width, cube.width, cube.channels);
    std::copy_n(cube.row(index * cube.width), result.texels.size(), result.texels.begin());
    return result;
}

std::vector<std::filesystem::path> filesOfMap(const std::filesystem::path& out, const std::vector<MapLayout>& levels)
{
    const ImageFormat& format = writableFormat(out);
    std::vector<Edges> edges;
    const std::vector<std::string_view> faces = facesOf(out, levels.front().kind);
    const bool areFaces = faces.size() > 1 || keepsFaces(format, levels.front());
    for (const MapLayout& level : levels)
        edges.push_back({level.width(), areFaces ? level.width() : level.height()});
    std::vector<std::filesystem::path> files;
    for (const std::string_view word : faces)
        for (std::filesystem::path& file : levelFiles(out, word, edges))
            files.push_back(std::move(file));
    return files;
}

} // namespace

std::vector<std::filesystem::path> mapFiles(const std::filesystem::path& out, const std::vector<MapLayout>& levels)
{
    if (levels.size() == 1)
        refuseDoubtfulLevel(out);
    return filesOfMap(out, levels);
}

std::vector<std::filesystem::path> writeMap(const std::filesystem::path& out, const std::vector<EnvironmentMap>& levels,
                                            const WriteOptions& options)
{
    const MapLayout& layout = levels.front().layout;
    WriteOptions described = options;
    described.attributes["mirrorball:parameterization"] = name(layout.kind);
    if (layout.border > 0)
        described.attributes["mirrorball:border"] = std::to_string(layout.border);

    const std::vector<std::string_view> faces = facesOf(out, layout.kind);
    std::vector<Image> images;
    if (faces.size() == 1) {
        described.faces = keepsFaces(writableFormat(out), layout) ? 6 : 1;
        if (levels.size() == 1 && !namesLevels(out)) { // where it lies: it may be large
            refuseDoubtfulLevel(out);
            std::filesystem::path file = fileNamed(out, {});
            writeImage(file, levels.front().image, described);
            return {std::move(file)};
        }
        for (const EnvironmentMap& level : levels)
            images.push_back(level.image);
        return writeLevels(out, {}, images, described);
    }
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < faces.size(); ++i) {
        images.clear();
        for (const EnvironmentMap& level : levels)
            images.push_back(face(level.image, static_cast<int>(i)));
        described.attributes["mirrorball:parameterization"] = "cube face " + std::string(faces[i]);
        for (auto& written : writeLevels(out, faces[i], images, described))
            files.push_back(std::move(written));
    }
    return files;
}

std::vector<std::filesystem::path> writePictures(const std::filesystem::path& out, const std::vector<Image>& levels,
                                                 const WriteOptions& options)
{
    facesOf(out, Parameterization::Sphere); // says that a picture has no faces
    const ImageFormat& format = writableFormat(out);
    if (format.samples != StoredSamples::Byte)
        return writeLevels(out, {}, levels, options);
    std::vector<Image> shown;
    for (const Image& level : levels)
        shown.push_back(toDisplay(level.channels == 4 && !format.alpha ? withoutOpacity(level) : level, 0.0, ToneCurve::None));
    WriteOptions display = options;
    display.encoding = Encoding::Display;
    return writeLevels(out, {}, shown, display);
}

void checkMapFile(const std::filesystem::path& out, const MapLayout& base) { checkTarget(filesOfMap(out, {base}).front()); }

} // namespace mirrorball
