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

/// NAME with its `%s` replaced by the word of each face or half; empty when it has none.
std::vector<std::filesystem::path> faceFiles(const std::filesystem::path& out, Parameterization kind)
{
    if (!namesFaces(out))
        return {};
    if (kind != Parameterization::Cube && kind != Parameterization::Paraboloid)
        throw InvalidArgument("output: '%s' stands for the six faces of a cube or the halves of a paraboloid, but this map is a " +
                              std::string(name(kind)) + " map; give a plain name, or '%d' for one file a level");
    std::vector<std::filesystem::path> files;
    const auto add = [&](const auto& words) {
        for (const std::string_view word : words)
            files.push_back(*withMarkReplaced(out, faceMark, word));
    };
    if (kind == Parameterization::Cube)
        add(faceNames);
    else
        add(halfNames);
    return files;
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
        edges.push_back({faces.size() == halfNames.size() ? level.size : level.width(), areFaces ? level.size : level.height()});
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
    const bool isCube = layout.kind == Parameterization::Cube;
    if (options.faceBorder < 0 || (options.faceBorder > 0 && (!isCube || options.faceBorder > layout.size)))
        throw InvalidArgument("border: must be 0 for this map, or for a cube at most the size of a face; it is " +
                              std::to_string(options.faceBorder));
    WriteOptions described = options;
    described.attributes["mirrorball:parameterization"] = name(layout.kind);
    if (const int border = isCube ? options.faceBorder : layout.border; border > 0)
        described.attributes["mirrorball:border"] = std::to_string(border);

    const std::vector<std::filesystem::path> parts = faceFiles(out, layout.kind);
    if (parts.empty())
        described.faces = keepsFaces(writableFormat(out), layout) ? 6 : 1;
    const size_t count = std::max<size_t>(1, parts.size());
    std::vector<std::vector<Image>> images(count); // by file, then by level
    for (const EnvironmentMap& level : levels) {
        std::vector<Image> own = pieces(level, count, options.faceBorder);
        for (size_t i = 0; i < count; ++i)
            images[i].push_back(std::move(own[i]));
    }
    if (parts.empty())
        return writeLevels(out, images.front(), described);
    std::vector<std::filesystem::path> files;
    for (size_t i = 0; i < count; ++i) {
        described.attributes["mirrorball:parameterization"] =
            isCube ? "cube face " + std::string(faceNames[i]) : "paraboloid half " + std::string(halfNames[i]);
        for (auto& written : writeLevels(parts[i], images[i], described))
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
