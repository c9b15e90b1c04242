#include "stored_map.h"

#include "core/base/error.h"
#include "core/image/container/container_file.h"
#include "core/image/image_io.h"
#include "core/image/layout_detection.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace mirrorball {

namespace {

constexpr std::array<std::string_view, 6> faceWords{"px", "nx", "py", "ny", "pz", "nz"};
constexpr int mostLevels = 32;

std::string firstBytes(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(16, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(stream.gcount()));
    return bytes;
}

StoredLevel repaired(Image image)
{
    StoredLevel level{std::move(image), {}};
    level.repaired = repair(level.image, NegativePolicy::Keep);
    return level;
}

std::string replaced(std::string name, std::string_view mark, std::string_view word)
{
    const size_t at = name.find(mark);
    return at == std::string::npos ? name : name.replace(at, mark.size(), word);
}

Image readWhole(ImageReader& reader)
{
    Image image(reader.info().width, reader.info().height, 3);
    reader.readRows(0, image.height, image.texels.data());
    return image;
}

/// One picture as a level of the map. What OpenEXR's attribute says about edges and mirrored faces is left for the measurement to find.
std::optional<Image> asLevel(Image image, ImageFileInfo info, std::optional<Parameterization> kind, Detection& found)
{
    info.width = image.width;
    info.height = image.height;
    info.envmap.clear();
    if (kind && *kind != Parameterization::Cube && image.width == 1 && image.height == 1 && info.levels > 1)
        return std::nullopt; // what a format's own chain ends in is no level of a 2 N x N map
    try {
        found = detectLayout(info, kind);
    } catch (const FileError&) {
        if (!kind) // the first picture must fit something; levels that no longer fit end the chain
            throw;
        return std::nullopt;
    }
    return toEnvironmentMap(std::move(image), found).image;
}

StoredMap ofContainer(const std::filesystem::path& path)
{
    ContainedTexture contained = readContainer(path);
    StoredMap map;
    map.container = contained.format;
    map.texels = contained.texels;
    map.metadata = contained.texture.metadata;
    if (contained.texture.slices > 1)
        throw FileError(path.string(), "is an array of pictures; give a cube, or one picture");
    map.shape = contained.texture.faces == 6 ? "the container holds a cube" : "the container holds one picture";
    if (contained.texture.faces != 6) {
        const int width = contained.texture.width(), height = contained.texture.height();
        if (width != 2 * height)
            throw FileError(path.string(), "holds one picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                               " texels, which is neither a cube nor a latlong");
        map.kind = Parameterization::Latlong;
    }
    for (Image& level : contained.texture.levels)
        if (map.kind == Parameterization::Cube || level.width == 2 * level.height)
            map.levels.push_back(repaired(std::move(level)));
    return map;
}

/// One image file, or one file a level.
StoredMap ofImages(const std::vector<std::filesystem::path>& paths, std::optional<Parameterization> from, const JobControl& job)
{
    StoredMap map;
    map.files = paths.size();
    for (const std::filesystem::path& path : paths) {
        const std::unique_ptr<ImageReader> first = openImage(path);
        const ImageFileInfo info = first->info();
        const int levels = paths.size() == 1 ? std::clamp(info.levels, 1, mostLevels) : 1;
        for (int l = 0; l < levels; ++l) {
            job.checkStop();
            const bool begins = map.levels.empty();
            Detection found;
            std::optional<Image> image =
                asLevel(l == 0 ? readWhole(*first) : readLevel(path, l), info, begins ? from : std::optional(map.kind), found);
            if (!image)
                return map;
            if (begins) {
                map.container = info.format + (paths.size() > 1 ? " levels" : "");
                map.texels = info.sampleType;
                map.kind = found.layout.kind;
                map.shape = found.reason;
                map.certain = found.certain;
            }
            map.levels.push_back(repaired(std::move(*image)));
        }
    }
    return map;
}

/// Six square pictures a level.
StoredMap ofFaces(const std::vector<std::string>& names, const JobControl& job)
{
    StoredMap map;
    map.shape = "six faces by name";
    map.files = 6 * names.size();
    for (const std::string& name : names) {
        Image level;
        for (size_t face = 0; face < 6; ++face) {
            job.checkStop();
            const std::filesystem::path path = replaced(name, "%s", faceWords[face]);
            const std::unique_ptr<ImageReader> reader = openImage(path);
            const Image picture = readWhole(*reader);
            if (level.empty()) {
                map.container = reader->info().format + " faces";
                map.texels = reader->info().sampleType;
                level = Image(picture.width, 6 * picture.width, 3);
            }
            if (picture.width != level.width || picture.height != level.width)
                throw FileError(path.string(), "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                                                   " texels where a face of " + std::to_string(level.width) + " x " +
                                                   std::to_string(level.width) + " is needed");
            std::copy(picture.texels.begin(), picture.texels.end(), level.row(static_cast<int>(face) * level.width));
        }
        map.levels.push_back(repaired(std::move(level)));
    }
    return map;
}

/// The names of the levels that are there, `%s` still in them.
std::vector<std::string> levelNames(const std::string& path)
{
    if (path.find("%d") == std::string::npos)
        return {path};
    const auto there = [&](int level) {
        return std::filesystem::exists(replaced(replaced(path, "%d", std::to_string(level)), "%s", faceWords[0]));
    };
    std::vector<std::string> names;
    for (int level = there(0) ? 0 : 1; level < mostLevels && there(level); ++level)
        names.push_back(replaced(path, "%d", std::to_string(level)));
    if (names.empty())
        throw FileError(path, "no such files: neither level 0 nor level 1 is there");
    return names;
}

} // namespace

StoredMap readStoredMap(const std::string& path, std::optional<Parameterization> from, const JobControl& job)
{
    StoredMap map;
    if (std::filesystem::exists(path)) {
        map = isContainer(firstBytes(path)) ? ofContainer(path) : ofImages({path}, from, job);
    } else {
        const std::vector<std::string> names = levelNames(path);
        map = path.find("%s") != std::string::npos ? ofFaces(names, job) : ofImages({names.begin(), names.end()}, from, job);
    }
    if (map.levels.empty())
        throw FileError(path, "holds no levels");
    return map;
}

} // namespace mirrorball
