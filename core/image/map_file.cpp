#include "map_file.h"

#include "color.h"
#include "cube_sheet.h"
#include "image_format.h"
#include "opacity.h"
#include "paraboloid_halves.h"
#include "probe_picture.h"
#include "reproject.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <optional>

namespace mirrorball {

namespace {

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

/// The words that a `%s` in the name stands for, of a cube's faces or a paraboloid's halves; a single empty one for a name without.
std::vector<std::string_view> partsOf(const std::filesystem::path& out, Parameterization kind)
{
    if (!namesFaces(out))
        return {std::string_view()};
    if (kind == Parameterization::Cube && writableFormat(out).faces)
        throw InvalidArgument("output: '%s' stands for six files of a face each, but " + out.extension().string() +
                              " holds the six faces in one; give a name without it");
    if (kind == Parameterization::Cube)
        return {faceNames.begin(), faceNames.end()};
    if (kind == Parameterization::Paraboloid)
        return {halfNames.begin(), halfNames.end()};
    throw InvalidArgument("output: '%s' stands for the six faces of a cube or the two halves of a paraboloid, but this map is a " +
                          std::string(name(kind)) + " map; give a plain name, or '%d' for one file a level");
}

bool keepsFaces(const ImageFormat& format, const MapLayout& layout) { return format.faces && layout.kind == Parameterization::Cube; }

/// A face of six squares on top of each other.
Image face(const Image& stack, int index)
{
    Image result(stack.width, stack.width, stack.channels);
    std::copy_n(stack.row(index * stack.width), result.texels.size(), result.texels.begin());
    return result;
}

/// The images that go into the files of one level: the whole map, its faces or its halves.
std::vector<Image> pieces(const EnvironmentMap& level, size_t count, int faceBorder)
{
    if (level.layout.kind == Parameterization::Paraboloid && count == halfNames.size()) {
        std::array<Image, 2> halves = splitHalves(level);
        return {std::move(halves[0]), std::move(halves[1])};
    }
    Image whole = faceBorder > 0 ? withBorders(level, std::min(faceBorder, level.layout.size)) : level.image;
    if (count == 1)
        return {std::move(whole)};
    std::vector<Image> faces;
    for (int i = 0; i < static_cast<int>(count); ++i)
        faces.push_back(face(whole, i));
    return faces;
}

std::vector<std::filesystem::path> filesOfMap(const std::filesystem::path& out, const std::vector<MapLayout>& levels, int faceBorder)
{
    const ImageFormat& format = writableFormat(out);
    std::vector<Edges> edges;
    const std::vector<std::string_view> parts = partsOf(out, levels.front().kind);
    const bool areFaces = parts.size() > 1 || keepsFaces(format, levels.front());
    for (const MapLayout& level : levels) {
        const int around = 2 * std::min(faceBorder, level.size), edge = level.size + around;
        if (areFaces)
            edges.push_back({edge, edge});
        else
            edges.push_back({level.width() + around, level.height() + (around > 0 ? 6 * around : 0)});
    }
    std::vector<std::filesystem::path> files;
    for (const std::string_view word : parts)
        for (std::filesystem::path& file : levelFiles(out, word, edges))
            files.push_back(std::move(file));
    return files;
}

} // namespace

std::vector<std::filesystem::path> mapFiles(const std::filesystem::path& out, const std::vector<MapLayout>& levels, int faceBorder)
{
    if (levels.size() == 1)
        refuseDoubtfulLevel(out);
    return filesOfMap(out, levels, faceBorder);
}

std::vector<std::filesystem::path> writeMap(const std::filesystem::path& out, const std::vector<EnvironmentMap>& levels,
                                            const WriteOptions& options)
{
    const MapLayout& layout = levels.front().layout;
    const bool isCube = layout.kind == Parameterization::Cube;
    if (options.faceBorder < 0 || (options.faceBorder > 0 && (!isCube || options.faceBorder > layout.size)))
        throw InvalidArgument("border: must be 0 for this map, or for a cube at most the size of a face; it is " +
                              std::to_string(options.faceBorder));
    WriteOptions described = options;
    described.attributes["mirrorball:parameterization"] = name(layout.kind);
    if (const int border = isCube ? options.faceBorder : layout.border; border > 0)
        described.attributes["mirrorball:border"] = std::to_string(border);

    const std::vector<std::string_view> parts = partsOf(out, layout.kind);
    if (parts.size() == 1) {
        described.faces = keepsFaces(writableFormat(out), layout) ? 6 : 1;
        if (levels.size() == 1 && options.faceBorder == 0 && !namesLevels(out)) { // where it lies: it may be large
            refuseDoubtfulLevel(out);
            std::filesystem::path file = fileNamed(out, {});
            writeImage(file, levels.front().image, described);
            return {std::move(file)};
        }
    }
    std::vector<std::vector<Image>> images(parts.size()); // by file, then by level
    for (const EnvironmentMap& level : levels) {
        std::vector<Image> own = pieces(level, parts.size(), options.faceBorder);
        for (size_t i = 0; i < parts.size(); ++i)
            images[i].push_back(std::move(own[i]));
    }
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < parts.size(); ++i) {
        if (parts.size() > 1)
            described.attributes["mirrorball:parameterization"] = (isCube ? "cube face " : "paraboloid half ") + std::string(parts[i]);
        for (auto& written : writeLevels(out, parts[i], images[i], described))
            files.push_back(std::move(written));
    }
    return files;
}

std::vector<std::filesystem::path> writePictures(const std::filesystem::path& out, const std::vector<Image>& levels,
                                                 const WriteOptions& options)
{
    partsOf(out, Parameterization::Sphere); // says that a picture has no faces
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

void checkMapFile(const std::filesystem::path& out, const MapLayout& base) { checkTarget(filesOfMap(out, {base}, 0).front()); }

} // namespace mirrorball
